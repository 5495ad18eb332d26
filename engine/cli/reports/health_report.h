#pragma once

#include <string>
#include <utility>
#include <vector>

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/mesh_health.h>
#include <nlohmann/json_fwd.hpp>

namespace graze::cli {

/// Where the triangles of a mesh stand in its file; empty if that is not known.
using TrianglePlaces = std::vector<mesh_io::Place>;

/// What is wrong with a mesh, for JSON: of each kind how much there is, and the first thousand.
nlohmann::ordered_json health_object(const MeshHealth& health, const TrianglePlaces& places);

/// The same as lines for people, each a name and what stands beside it: of each kind how much there
/// is, and where the first few are.
std::vector<std::pair<std::string, std::string>> health_lines(const MeshHealth& health,
                                                              const TrianglePlaces& places);

}  // namespace graze::cli
