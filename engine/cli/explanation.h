#pragma once

#include <optional>
#include <string>
#include <vector>

#include <graze/engine/mesh/pair.h>
#include <graze/narrowphase/verdict.h>

namespace graze::cli {

/// An axis along which the boxes around two whole meshes are compared.
struct BoxAxis {
  std::string name;           ///< "x of A", "x of A cross y of B"
  Eigen::Vector3d direction;  ///< a unit vector in the common frame
  double gap;                 ///< metres between the boxes along it; negative where they overlap
};

/// What the query did with one kind of volume.
struct VolumeWork {
  Volume volume;
  Work work;
};

/// Why two meshes intersect, or do not. Everything comes from public queries and from the stages of
/// the narrow phase for one pair of triangles, so that it holds for any traversal.
struct Explanation {
  bool intersects = false;
  TrianglePair pair{};  ///< a witness of the hit, or the pair that came closest
  narrowphase::Stage stage = narrowphase::Stage::Triage;  ///< that decides about this pair
  Eigen::Vector3d point_a;  ///< of a hit the witness point; else the nearest points
  Eigen::Vector3d point_b;
  double gap = 0;                       ///< metres; 0 for a hit
  std::optional<Eigen::Vector3d> axis;  ///< of a miss: the unit vector from A's point to B's
  BoxAxis widest;                       ///< of 15: where the boxes of the meshes are furthest apart
  double all_pairs = 0;                 ///< of triangles
  std::vector<VolumeWork> volumes;      ///< as if each had been asked for; trees were there
  Work first;                           ///< of the very first query, with its trees built
};

Explanation explain(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b);

std::string to_text(const Explanation& explanation);
std::string to_json(const Explanation& explanation);

}  // namespace graze::cli
