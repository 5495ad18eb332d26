#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tests/benchmark/pairs/contest.h"

namespace graze::benchmark {

using Json = nlohmann::ordered_json;

/// One scene: builds, and for each regime times, wrong answers and work, per query.
Json to_json(const SceneResult& result);

/// Throws Error if it cannot be written.
void write(const Json& document, const std::string& path);

}  // namespace graze::benchmark
