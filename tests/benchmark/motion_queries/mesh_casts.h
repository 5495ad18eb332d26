#pragma once

#include <nlohmann/json.hpp>

namespace graze::benchmark {

/// Casts of the bundled meshes in pairs (law 13): B stands in any rotation beside A, and goes to
/// its other side; and of a ball and a capsule at the bolt. Prints a table and returns its rows.
nlohmann::ordered_json measure_mesh_casts(int queries, int repetitions);

}  // namespace graze::benchmark
