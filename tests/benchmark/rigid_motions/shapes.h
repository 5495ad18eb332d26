#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

namespace graze::benchmark {

/// Pairs of convex shapes that move and turn, ours beside every peer that is there: what each
/// takes, in microseconds, and how often a peer is wrong. Prints a table. `wrong` grows by answers
/// of ours that samples refute.
nlohmann::ordered_json measure_shape_motions(int motions, std::size_t& wrong);

}  // namespace graze::benchmark
