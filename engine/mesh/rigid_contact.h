#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/query_settings.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/work.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace graze {

/// The settings of first_contact() for two rigid motions.
struct RigidContactSettings {
  double clearance = 0;  ///< metres: what is not further apart counts as a hit
  /// The tolerance, metres beyond the clearance: what comes so near is not called free. At least
  /// 2^-37 of all lengths that bodies and motions are made of, and 2^-44 of how far they move, take
  /// its place where it is less: nothing finer could be proved in doubles.
  double tolerance = 1e-6;
  /// The number of pairs of boxes and of triangles that are tested at most. It is no time: so what
  /// comes out is the same on every machine.
  std::uint64_t budget = std::uint64_t{1} << 24;
};

/// The answers about two rigid motions.
enum class RigidStatus {
  Free,  ///< further apart than the clearance at all times from 0 to 1: proved
  Hit,   ///< a contact is proved
  Close  ///< nearer than the tolerance beyond the clearance, and no contact is proved
};

/// Says when two rigid motions meet first.
struct RigidContact {
  RigidStatus status;  ///< whether they are free, meet, or neither is proved
  /// The meshes are further apart than the clearance at all times below it: it is never later than
  /// the first contact. It is 1 for what is free; else it is the first time of a grid at which
  /// distance() is not above clearance and tolerance, or at which the budget ended.
  double low;
  /// A witness: at this time intersects() says yes of both poses, or within() where there is a
  /// clearance. It is 1 where there is none.
  double high;
  bool is_out_of_budget;  ///< true if the budget ended the search at `low`, whatever lies there

  bool operator==(const RigidContact&) const = default;
};

/// A mesh in rigid motion, as the argument of queries: `first_contact({bolt, rest}, {nut, path})`.
/// It is a value, which holds a handle to the mesh.
struct MeshInMotion {
  Mesh mesh;           ///< a handle
  RigidMotion motion;  ///< where the mesh is from t = 0 to 1

  bool operator==(const MeshInMotion&) const = default;
};

/// Returns when the surfaces of two meshes in rigid motion meet first (law 14), conservatively:
/// what is called free is free for every real t, in real arithmetic on the motions' numbers and for
/// the poses RigidMotion::at() rounded and vertices placed by law 1. `low` is the least k / 2^m at
/// which the distance is not above clearance and tolerance, m being such that nothing moves by more
/// than a quarter of the tolerance in a step; so it depends on no tree and no order, and swapping A
/// and B changes nothing, unless a budget ends. From there on contacts are looked for at 1, 2, 4,
/// ... steps, and the first that is found is narrowed to one step; a shorter touch than it took to
/// come there may be missed, which is Close. Throws InputError for a clearance or tolerance that is
/// not a distance, and PoseError for motions that take a mesh too far away. The squares of lengths
/// below 2^-430 m underflow: what is so near is Close, or the budget ends.
RigidContact first_contact(const MeshInMotion& mesh_a, const MeshInMotion& mesh_b,
                           const RigidContactSettings& settings = {}, Work* work = nullptr);

/// True if first_contact() says Free. It stops at the first pair of triangles that comes too near.
bool is_free(const MeshInMotion& mesh_a, const MeshInMotion& mesh_b,
             const RigidContactSettings& settings = {}, Work* work = nullptr);

/// Returns the last time of the same grid up to which all is free, with the tolerance: 1 if that is
/// so to the end, nothing if the meshes are too near at the start.
std::optional<double> last_free(const MeshInMotion& mesh_a, const MeshInMotion& mesh_b,
                                const RigidContactSettings& settings = {}, Work* work = nullptr);

/// A mesh in each of many motions, as the second argument of queries: `is_free({robot, rest},
/// {part, motions})`. It refers to the motions, which must outlive it.
struct MeshInMotions {
  /// Refers to the motions.
  MeshInMotions(Mesh of_mesh, std::span<const RigidMotion> in_motions)
      : mesh(std::move(of_mesh)), motions(in_motions) {}
  MeshInMotions(Mesh, std::initializer_list<RigidMotion>) = delete;  // they would not outlive it

  Mesh mesh;                             ///< a handle
  std::span<const RigidMotion> motions;  ///< must outlive this
};

/// These answer first_contact() and is_free() for each of many motions of B, edges of a roadmap
/// say, in their order, on all threads. What has to be built is built once. They throw as the
/// single queries do, before the first answer where a motion is to blame, which the error names by
/// its index.
std::vector<RigidContact> first_contact(const MeshInMotion& mesh_a, const MeshInMotions& mesh_b,
                                        const RigidContactSettings& settings = {},
                                        const BatchSettings& batch = {}, Work* work = nullptr);
std::vector<bool> is_free(const MeshInMotion& mesh_a, const MeshInMotions& mesh_b,
                          const RigidContactSettings& settings = {},
                          const BatchSettings& batch = {}, Work* work = nullptr);

/// Two meshes in rigid motion, as one of many pairs.
struct RigidPair {
  MeshInMotion a;  ///< mesh A
  MeshInMotion b;  ///< mesh B, perhaps the same mesh

  bool operator==(const RigidPair&) const = default;
};

/// These answer first_contact() and is_free() for each of many pairs, in their order, on all
/// threads: the motions of many bodies beside one, or of each beside each. Trees of meshes that
/// stand in several pairs are built once. They throw as the single queries do, before the first
/// answer where a motion is to blame, which the error names by the index of its pair.
std::vector<RigidContact> first_contact(std::span<const RigidPair> pairs,
                                        const RigidContactSettings& settings = {},
                                        const BatchSettings& batch = {}, Work* work = nullptr);
std::vector<bool> is_free(std::span<const RigidPair> pairs,
                          const RigidContactSettings& settings = {},
                          const BatchSettings& batch = {}, Work* work = nullptr);

}  // namespace graze
