#pragma once

// This is private to engine/mesh.

#include <graze/bvh/value/rigid.h>
#include <graze/engine/mesh/memory/motion_front.h>
#include <graze/engine/mesh/pair_memory.h>
#include <graze/engine/mesh/query/wide_query.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace graze {

/// True if the two poses are equal bit by bit.
bool have_same_bits(const Pose& one, const Pose& other);

/// A mesh in its last pose, and numbers that bound how far a motion takes its points.
class CachedMesh {
 public:
  explicit CachedMesh(const Mesh& mesh);

  const Mesh& mesh() const { return mesh_; }
  const Pose& pose() const { return pose_; }
  /// Returns a number that grows each time that the pose changes.
  std::uint64_t pose_number() const { return pose_number_; }
  double deviation() const { return error_.largest(); }

  /// Takes the pose of the next query, checked by check_placement() unless it is the last one.
  void place(const Pose& pose, const char* what);

  /// Bounds a displacement: no placed point of the mesh is further from where `before` placed it
  /// than the root of `square` and `rounding` (metres).
  struct DisplacementBound {
    double square = 0;
    double rounding = 0;
  };
  DisplacementBound displacement_from(const Pose& before) const;

 private:
  alignas(64) Pose pose_ = Pose::Identity();  ///< fills two cache lines, as each query compares it
  Mesh mesh_;
  double middle_[3];
  double radius_;   ///< radius of a ball around the bounds, about their middle
  double largest_;  ///< the largest coordinate of the bounds
  double sizes_;    ///< the sizes of the bounds, added up
  bvh::RotationError error_{pose_};
  std::uint64_t pose_number_ = 0;
  bool is_placed_ = false;
};

/// The knowledge that a PairMemory has of one pair of meshes.
class PairCache {
 public:
  static constexpr std::size_t kMostPairs = 8;

  PairCache(const Mesh& mesh_a, const Mesh& mesh_b) : a_(mesh_a), b_(mesh_b) {}

  bool is_about(const PlacedMeshView& a, const PlacedMeshView& b) const {
    return a_.mesh() == a.mesh && b_.mesh() == b.mesh;
  }

  /// Puts both meshes into the poses of the next query. Throws PoseError.
  void place(const Pose& pose_a, const Pose& pose_b);

  double deviation_a() const { return a_.deviation(); }
  double deviation_b() const { return b_.deviation(); }

  /// True if all placed triangles are surely farther apart than so many metres: by the gap that was
  /// proved last, less how far both meshes moved since.
  bool are_apart_by(double metres) const;

  /// Says the same for a query that this answers, and counts it if so.
  bool are_still_apart_by(double metres, Work* work);

  /// Takes note that in these poses no triangles are nearer than so many metres.
  void learn_gap(double metres);

  /// Adds to the motion of both fronts how far B has come in A since the last call. Returns false
  /// if this is the first.
  bool add_motion(const WideQuery& query);

  std::span<const TrianglePair> pairs() const { return {pairs_.data(), pair_count_}; }
  void remember(std::span<const TrianglePair> found);
  void put_first(std::size_t index) { std::swap(pairs_[0], pairs_[index]); }

  std::optional<TrianglePair> nearest;
  std::optional<Pose> nearest_pose;  ///< roughly the pose of B in A when distance() was last asked
  bool was_within = false;
  bool was_touching = false;    ///< whether the meshes touched when a distance was last asked for
  std::size_t pairs_found = 0;  ///< how many pairs there were when all were last asked for
  MotionFront intersection_front{bvh::WideFront::Kind::Intersection};
  MotionFront distance_front{bvh::WideFront::Kind::Distance};
  std::uint64_t still_apart = 0;
  std::uint64_t still_touching = 0;

 private:
  CachedMesh a_;
  CachedMesh b_;

  struct NumberedPose {
    alignas(64) Pose pose = Pose::Identity();
    std::uint64_t number = 0;
  };
  static NumberedPose pose_of(const CachedMesh& mesh) { return {mesh.pose(), mesh.pose_number()}; }
  static CachedMesh::DisplacementBound displacement_from(const NumberedPose& before,
                                                         const CachedMesh& mesh) {
    return before.number == mesh.pose_number() ? CachedMesh::DisplacementBound()
                                               : mesh.displacement_from(before.pose);
  }

  NumberedPose gap_pose_a_;
  NumberedPose gap_pose_b_;
  double gap_ = -1;  ///< the gap in metres, in the two poses above; below 0 if unknown

  double rotation_[3][3];  ///< that of B in A, in common units, at the last add_motion()
  double translation_[3];
  bool is_motion_known_ = false;
  static constexpr int kMostQueries = 1 << 20;
  int queries_ = 0;  ///< queries since the last add_motion(), at most kMostQueries

  std::array<TrianglePair, kMostPairs> pairs_{};  ///< pairs that touched, the last one that did
                                                  ///< first
  std::size_t pair_count_ = 0;
};

/// Returns the cache of this pair of meshes, in these poses; an empty one if the memory was about
/// others. Throws PoseError.
PairCache& recall(PairMemory& memory, const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b);

/// Returns a lower bound of how far apart the meshes are by the boxes of all that they hold
/// (metres), or less than 0.
double gap_of_bounds(const WideQuery& query);

}  // namespace graze
