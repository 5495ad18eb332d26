#pragma once

#include <memory>
#include <string>
#include <vector>

#include <tests/benchmark/triangles/contest.h>
#include <tests/oracle/shapes.h>

namespace graze::benchmark {

/// Those that can take part in the set of that name.
std::vector<std::unique_ptr<Contestant<oracle::TriangleAndBox>>> box_contestants(
    const std::string& set);

Truth truth_of(const std::vector<oracle::TriangleAndBox>& elements);

}  // namespace graze::benchmark
