#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <graze/bvh/pose.h>
#include <graze/engine/cases/case.h>
#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/world/shape.h>

namespace graze::compare {

/// Holds poses of B, of which no more are kept than are needed at a time. Many threads may read it.
class PoseSource {
 public:
  virtual ~PoseSource() = default;
  virtual std::size_t size() const = 0;

  /// Returns the pose of a number below size(). Throws PoseError for one that its file has no
  /// longer, and what a generator throws.
  virtual Pose at(std::size_t place) const = 0;

  /// Returns what tells these poses from others, together with the meshes and the pose of A.
  virtual const std::string& key() const = 0;
};

/// A generator draws so many poses from one seed: each block of them has its own, so that a part of
/// a run begins where it begins. The first block has the seed that was given.
inline constexpr std::size_t kPosesOfSeed = 1024;

/// Draws poses of B at random: any rotation, the middle of its bounds within the bounds of A grown
/// by half of B's size, so that hits and misses are both common. They are the same for the same
/// seed on every machine: it uses no library's distributions, and no libm beyond sqrt.
std::vector<Pose> random_poses(const PlacedMeshView& mesh_a, const Mesh& mesh_b, std::size_t count,
                               std::uint64_t seed);

/// Finds poses at which the two just touch, where engines go wrong: B comes from outside along a
/// line through A, and the last step before the first hit is halved until the translations of a hit
/// and of a miss are next to each other. Hits and misses follow in turn. Throws InputError if they
/// never touch.
std::vector<Pose> grazing_poses(const PlacedMeshView& mesh_a, const Mesh& mesh_b, std::size_t count,
                                std::uint64_t seed);

/// Return a source of `count` such poses, which are not all held. The meshes are kept.
std::shared_ptr<const PoseSource> random_pose_source(const CaseMesh& a, const Mesh& b,
                                                     std::size_t count, std::uint64_t seed);
std::shared_ptr<const PoseSource> grazing_pose_source(const CaseMesh& a, const Mesh& b,
                                                      std::size_t count, std::uint64_t seed);

/// Return such sources for shapes of all kinds, to whose bounds in their own frames all of that
/// applies. A half-space or a plane, which has no bounds, counts as a piece as large as the other,
/// about the point nearest to the origin of its frame. Touching is what intersects() of shapes
/// says.
std::shared_ptr<const PoseSource> random_pose_source(const CaseBody& a, const Shape& b,
                                                     std::size_t count, std::uint64_t seed);
std::shared_ptr<const PoseSource> grazing_pose_source(const CaseBody& a, const Shape& b,
                                                      std::size_t count, std::uint64_t seed);

/// Returns a source of these poses.
std::shared_ptr<const PoseSource> pose_list(std::vector<Pose> poses);

/// Returns the poses of a file, as load_pose_lines() has them. All are looked at once: a body with
/// such bounds must be able to stand there. Those of a regular file stay in it, and it must not
/// change meanwhile; those of a pipe are all held. Throws PoseError, naming file and line.
std::shared_ptr<const PoseSource> pose_file(const std::filesystem::path& path,
                                            const Aabb& bounds_b);

}  // namespace graze::compare
