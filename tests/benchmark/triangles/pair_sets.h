#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tests/benchmark/triangles/contest.h>
#include <tests/oracle/shapes.h>

namespace graze::benchmark {

/// How many elements in a row share the first triangle, in the sets made for one against many.
inline constexpr std::size_t kGroup = 64;

/// Names of all sets: generic ones, whose names say their share of hits in percent, then those of
/// the corpora of hard inputs.
std::vector<std::string> pair_set_names();

/// Throws std::invalid_argument for a name that is none.
Set<oracle::TrianglePair> pair_set(const std::string& name, std::size_t count);

}  // namespace graze::benchmark
