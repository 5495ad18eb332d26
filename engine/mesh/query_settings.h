#pragma once

// The settings of queries on meshes. Each query takes the settings that it can honour: what it
// cannot does not compile.

#include <graze/bvh/volume.h>
#include <graze/engine/mesh/interior.h>
#include <graze/narrowphase/touch.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <stop_token>

namespace graze {

// `threads` means the same in all settings: how many threads share the work at most. 0 means all
// that there are, 1 the caller's alone. It changes the time, never a result.

/// The limit that ends no query: everything is found.
inline constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

/// The conditions under which a query on two meshes says yes.
enum class Hit {
  Touching,  ///< they share a point of their surfaces (law 2)
  Crossing,  ///< they have triangles for which crosses() is true: insides meet, and no plane holds
             ///< both
  Solid,     ///< they share a point, both being closed and solid: a mesh wholly inside another
             ///< counts
};

/// The settings of intersects() for two meshes.
struct QuerySettings {
  /// The volumes that prune: they change the time, never the answer.
  PairVolume volume = PairVolume::WideObb;
  Hit hit = Hit::Touching;  ///< the condition for a hit
};

/// The settings of intersects() for two meshes with a PairMemory.
struct MemoryQuerySettings {
  Hit hit = Hit::Touching;  ///< the condition for a hit
};

/// The settings of find_triangle_pairs().
struct PairSettings {
  /// The query stops after this many pairs. Which pairs these are is reproducible, and may depend
  /// on `volume` and, for deformed meshes, on what had been asked of the meshes that they were made
  /// of.
  std::size_t limit = kNoLimit;
  /// The volumes that prune: they change the time, never which pairs there are.
  PairVolume volume = PairVolume::WideObb;
  /// The pairs that count.
  Touch touch = Touch::Include;
};

/// The settings of find_triangle_pairs() that threads share. All pairs are found, always by
/// PairVolume::WideObb: which pairs come first is for one thread to say, so that there is no limit.
struct SharedPairSettings {
  int threads = 0;               ///< how many threads share the query at most; 0 means all
  Touch touch = Touch::Include;  ///< the pairs that count
};

/// The settings of find_triangle_pairs() with a PairMemory.
struct MemoryPairSettings {
  std::size_t limit = kNoLimit;  ///< the limit, as in PairSettings
  Touch touch = Touch::Include;  ///< the pairs that count
};

/// The settings of find_intersection().
struct IntersectionSettings {
  /// The volumes that prune: they change the time, never the result.
  PairVolume volume = PairVolume::WideObb;
};

/// The settings of find_contacts() for two meshes.
struct ContactSettings {
  /// The number of contacts that are returned at most, the deepest ones. All are found, whatever
  /// the limit.
  std::size_t limit = kNoLimit;
  /// The volumes that prune: they change the time, never the contacts.
  PairVolume volume = PairVolume::WideObb;
};

/// The settings of intersects() for a mesh and a box or a ball.
struct VolumeQuerySettings {
  /// The volumes that prune: they change the time, never the answer.
  Volume volume = Volume::Aabb;
  /// Says whether a closed mesh is solid: a volume wholly inside it is then a hit.
  Interior interior = Interior::Surface;
};

/// The settings of find_triangles().
struct TriangleSettings {
  /// The query stops after this many triangles. Which ones these are is reproducible, and may
  /// depend on `volume`.
  std::size_t limit = kNoLimit;
  /// The volumes that prune: they change the time, never which triangles there are.
  Volume volume = Volume::Aabb;
};

/// The settings of self_intersects().
struct SelfQuerySettings {
  /// The volumes that prune: they change the time, never the answer.
  Volume volume = Volume::Aabb;
};

/// The kinds of pairs of triangles of one mesh that may be asked for.
enum class SelfPairKind {
  /// The triangles share more than the welded vertex or edge that they have in common.
  Intersecting,
  /// The triangles share exactly that: one welded vertex, or the edge between two.
  Neighbour,
};

/// The settings of find_self_pairs().
struct SelfSettings {
  SelfPairKind kind = SelfPairKind::Intersecting;  ///< the kind of pairs that is wanted
  /// The query stops after this many pairs. Which pairs these are is reproducible, and may depend
  /// on `volume`.
  std::size_t limit = kNoLimit;
  /// The volumes that prune: they change the time, never which pairs there are.
  Volume volume = Volume::Aabb;
};

/// The settings of queries for many poses, points, rays or motions at once.
struct BatchSettings {
  int threads = 0;  ///< how many threads share the elements at most; 0 means all that there are
  /// Whoever holds the source may ask a batch to stop, from any thread. No element is begun after
  /// that, and the batch throws StoppedError unless all were done: it never returns a part of an
  /// answer.
  std::stop_token stop = {};
  /// If set, called on the thread that called the batch: when that one has answered something,
  /// then some twenty times a second, with how many elements are done by all threads and their
  /// total, and once more at the end. What it throws ends the batch.
  std::function<void(std::size_t done, std::size_t total)> on_progress = {};
};

}  // namespace graze
