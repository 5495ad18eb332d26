#pragma once

// What queries on meshes can be told. Each query takes the settings that it can honour: what it
// cannot does not compile.

#include <graze/bvh/volume.h>
#include <graze/engine/mesh/interior.h>
#include <graze/narrowphase/touch.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <stop_token>

namespace graze {

// `threads` means the same in all settings: how many threads share the work at most; 0: all that
// there are; 1: the caller's alone. It changes the time, never a result.

/// No limit to how many are found.
inline constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

/// What two meshes must do for a query to say yes.
enum class Hit {
  Touching,  ///< share a point of their surfaces (law 2)
  Crossing,  ///< have triangles for which crosses() is true: insides meet, and no plane holds both
  Solid,     ///< share a point, both being closed and solid: a mesh wholly inside another counts
};

/// intersects() of two meshes.
struct QuerySettings {
  /// What prunes: changes the time, never the answer.
  PairVolume volume = PairVolume::WideObb;
  Hit hit = Hit::Touching;  ///< what counts as a hit
};

/// intersects() of two meshes with a PairMemory.
struct MemoryQuerySettings {
  Hit hit = Hit::Touching;  ///< what counts as a hit
};

/// find_triangle_pairs().
struct PairSettings {
  /// Stop after this many pairs. Which pairs these are is reproducible, and may depend on `volume`
  /// and, of deformed meshes, on what had been asked of the meshes that they were made of.
  std::size_t limit = kNoLimit;
  /// What prunes: changes the time, never which pairs there are.
  PairVolume volume = PairVolume::WideObb;
  /// Which pairs count.
  Touch touch = Touch::Include;
  /// How many threads share the query at most; 0: all that there are. A query with a limit and one
  /// by another volume than WideObb run on one, whatever is allowed: which pairs come first is for
  /// one thread to say.
  int threads = 1;
};

/// find_triangle_pairs() with a PairMemory.
struct MemoryPairSettings {
  std::size_t limit = kNoLimit;  ///< as of PairSettings
  Touch touch = Touch::Include;  ///< which pairs count
  int threads = 1;               ///< as of PairSettings
};

/// find_intersection().
struct IntersectionSettings {
  /// What prunes: changes the time, never the result.
  PairVolume volume = PairVolume::WideObb;
};

/// find_contacts() of two meshes.
struct ContactSettings {
  /// At most so many contacts, the deepest ones. All are found, whatever the limit.
  std::size_t limit = kNoLimit;
  /// What prunes: changes the time, never the contacts.
  PairVolume volume = PairVolume::WideObb;
};

/// intersects() of a mesh and a box or a ball.
struct VolumeQuerySettings {
  /// What prunes: changes the time, never the answer.
  Volume volume = Volume::Aabb;
  /// Whether a closed mesh is solid: what is wholly inside it is then a hit.
  Interior interior = Interior::Surface;
};

/// find_triangles().
struct TriangleSettings {
  /// Stop after this many triangles. Which ones these are is reproducible, and may depend on
  /// `volume`.
  std::size_t limit = kNoLimit;
  /// What prunes: changes the time, never which triangles there are.
  Volume volume = Volume::Aabb;
};

/// self_intersects().
struct SelfQuerySettings {
  /// What prunes: changes the time, never the answer.
  Volume volume = Volume::Aabb;
};

/// Which pairs of a mesh with itself are wanted.
enum class SelfPairKind {
  /// The triangles share more than the welded vertex or edge that they have in common.
  Intersecting,
  /// They share exactly that: one welded vertex, or the edge between two.
  Neighbour,
};

/// find_self_pairs().
struct SelfSettings {
  SelfPairKind kind = SelfPairKind::Intersecting;  ///< which pairs are wanted
  /// Stop after this many pairs. Which pairs these are is reproducible, and may depend on `volume`.
  std::size_t limit = kNoLimit;
  /// What prunes: changes the time, never which pairs there are.
  Volume volume = Volume::Aabb;
};

/// Queries for many poses, points, rays or motions at once.
struct BatchSettings {
  int threads = 0;  ///< how many threads share the elements at most; 0: all that there are
  /// Whoever holds the source may ask a batch to stop, from any thread. No element is begun after
  /// that, and the batch throws StoppedError unless all were done: there is no part of an answer.
  std::stop_token stop = {};
  /// If set, called on the thread that called the batch: when that one has answered something,
  /// then some twenty times a second, with how many elements are done by all threads and their
  /// total, and once more at the end. What it throws ends the batch.
  std::function<void(std::size_t done, std::size_t total)> on_progress = {};
};

}  // namespace graze
