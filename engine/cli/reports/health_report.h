#pragma once

#include <string>
#include <utility>
#include <vector>

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/mesh_health.h>
#include <nlohmann/json_fwd.hpp>

namespace graze::cli {

/// Says where the triangles of a mesh stand in its file; empty if that is not known.
using TrianglePlaces = std::vector<mesh_io::Place>;

/// Returns what is wrong with a mesh, for JSON: how much there is of each kind, and the first
/// thousand.
nlohmann::ordered_json health_object(const MeshHealth& health, const TrianglePlaces& places);

/// Returns the same as lines for people, each a name and what stands beside it: how much there is
/// of each kind, and where the first few are.
std::vector<std::pair<std::string, std::string>> health_lines(const MeshHealth& health,
                                                              const TrianglePlaces& places);

}  // namespace graze::cli
