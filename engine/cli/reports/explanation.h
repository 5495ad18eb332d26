#pragma once

#include <optional>
#include <string>
#include <vector>

#include <graze/engine/cli/reports/separated_boxes.h>
#include <graze/engine/mesh/pair.h>
#include <graze/narrowphase/predicates/verdict.h>

namespace graze::cli {

/// Says what the query did with one kind of volume.
struct VolumeWork {
  PairVolume volume;
  Work work;
};

/// Names the last stage that a query which found a miss had to ask.
enum class Decider { MeshBoxes, Volumes, Leaves, Triangles, Exact };

/// Says how closed meshes lie whose surfaces share no point.
enum class Solids { Apart, Meet };

/// Says why two meshes intersect, or do not. Everything comes from public queries and from the
/// stages of the narrow phase for one pair of triangles, so that it holds for any traversal.
struct Explanation {
  bool intersects = false;
  TrianglePair pair{};  ///< a witness of the hit, or the pair that came closest
  narrowphase::Stage stage = narrowphase::Stage::Triage;  ///< the stage that decides about this
                                                          ///< pair
  Eigen::Vector3d point_a;  ///< the witness point of a hit, and else the nearest points
  Eigen::Vector3d point_b;
  double gap = 0;                        ///< metres; 0 for a hit
  std::optional<Eigen::Vector3d> axis;   ///< for a miss the unit vector from A's point to B's
  Decider decider = Decider::MeshBoxes;  ///< for a miss the stage that decides with the default
                                         ///< volume
  std::optional<SeparatedBoxes> boxes;   ///< for a miss the boxes around the pair that came closest
  std::optional<Solids> solids;          ///< for a miss how two closed meshes lie
  BoxAxis widest;  ///< the one of 15 axes along which the boxes of the meshes are furthest apart
  double all_pairs = 0;             ///< the number of pairs of triangles
  std::vector<VolumeWork> volumes;  ///< the work as if each volume had been asked for; trees were
                                    ///< there
  Work first;                       ///< the work of the very first query, with its trees built
};

Explanation explain(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b);

std::string to_text(const Explanation& explanation);
std::string to_json(const Explanation& explanation);

}  // namespace graze::cli
