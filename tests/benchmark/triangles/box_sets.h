#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tests/benchmark/triangles/contest.h>
#include <tests/oracle/shapes.h>

namespace graze::benchmark {

/// As pair_sets.h. In the sets made for one against many, kGroup elements in a row share the
/// triangle or the box.
std::vector<std::string> box_set_names();

/// Throws std::invalid_argument for a name that is none.
Set<oracle::TriangleAndBox> box_set(const std::string& name, std::size_t count);

}  // namespace graze::benchmark
