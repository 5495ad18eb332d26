#pragma once

#include <memory>
#include <vector>

#include <tests/benchmark/triangles/contest.h>
#include <tests/oracle/shapes.h>

namespace graze::benchmark {

std::vector<std::unique_ptr<Contestant<oracle::TriangleAndBox>>> box_contestants();

Truth truth_of(const std::vector<oracle::TriangleAndBox>& elements);

}  // namespace graze::benchmark
