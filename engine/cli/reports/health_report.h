#pragma once

#include <string>
#include <utility>
#include <vector>

#include <graze/engine/mesh/mesh_health.h>
#include <nlohmann/json_fwd.hpp>

namespace graze::cli {

/// What is wrong with a mesh, for JSON: of each kind how much there is, and the first thousand.
nlohmann::ordered_json health_object(const MeshHealth& health);

/// The same as lines for people, each a name and what stands beside it: of each kind how much there
/// is, and where the first few are.
std::vector<std::pair<std::string, std::string>> health_lines(const MeshHealth& health);

}  // namespace graze::cli
