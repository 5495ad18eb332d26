#pragma once

#include "tests/benchmark/world/scene.h"

namespace graze::benchmark {

/// Pours the bodies, lets them settle by the solver of the sample simulation_loop, and returns the
/// poses of that many steps more, in which all of them move as they will.
std::vector<Frame> settle(const Scene& scene, std::size_t frames);

/// As settle(), or what it returned before: kept in the file, if a path is given.
std::vector<Frame> settle_once(const Scene& scene, std::size_t frames, const std::string& file);

}  // namespace graze::benchmark
