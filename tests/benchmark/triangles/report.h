#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <tests/benchmark/triangles/contest.h>

namespace graze::benchmark {

void write_table(std::ostream& stream, const std::string& title, const std::vector<Score>& scores);
void write_json(std::ostream& stream, const std::vector<Score>& pairs,
                const std::vector<Score>& boxes);

}  // namespace graze::benchmark
