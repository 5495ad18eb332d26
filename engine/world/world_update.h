#pragma once

// The results of an update of a world.

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/work.h>
#include <graze/engine/world/ids.h>
#include <graze/engine/world/manifold.h>
#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace graze {

/// The contacts of two solid bodies that touch or, if they have a margin, are near. The manifold is
/// empty for half-spaces that touch each other, and for shapes of a user's own that offer no
/// contacts. For a Compound there is one BodyContact for each part that meets a body, or a part of
/// another: Manifold::part_a() and part_b() say which.
struct BodyContact {
  BodyPair pair;      ///< the pair, which touches or is near; if it is only near, no depth is above
                      ///< 0
  Manifold manifold;  ///< the contacts by find_contacts(), normals from pair.a to pair.b

  bool operator==(const BodyContact&) const = default;
};

/// The first contact of two bodies of which one is swept (Detection) and which are not proved to
/// stay apart from one update to the next. Times go from 0, the last update, to 1, this one.
struct BodyFirstContact {
  BodyPair pair;  ///< the pair, which may have a sensor; only pairs that filters let pass now are
                  ///< listed
  /// first_contact() of both in motion: Hit or Close. Where a shape of a user's own does not know,
  /// it is Close from 0 on and out of budget.
  RigidContact contact;
  /// True if they touch at 0: then `low` is 0, and a solver needs only the contacts of the last
  /// update. A convex body that at time 0 is no further than the tolerance from a mesh that does
  /// not turn is listed with it once more, with the first triangle that it comes to after that and
  /// does not slide along (WorldSettings::sliding_depth), such as a wall for a body that lies on
  /// the floor beside it. Two meshes, or two convex bodies, that are so near are not listed again.
  bool is_at_start;
  /// The normal at `low`, unit, from pair.a to pair.b; zero where nothing tells it: for two
  /// half-spaces and for shapes of a user's own.
  Eigen::Vector3d normal;
  Eigen::Vector3d point;     ///< a point between the two at `low`, in the world's frame; zero like
                             ///< the normal
  std::uint32_t part_a = 0;  ///< the part of pair.a, if that is a Compound: each pair of parts is
                             ///< listed
  std::uint32_t part_b = 0;  ///< the part of pair.b, if that is a Compound

  bool operator==(const BodyFirstContact&) const = default;
};

/// Counts of what an update did, and of what it could leave out.
struct WorldWork {
  /// The pairs of bodies that may not meet, among those whose boxes began to overlap, or for which
  /// a filter, kind, role or exclusion changed. After that they cost nothing, and are not counted.
  std::uint64_t pairs_filtered = 0;
  std::uint64_t pairs_at_rest = 0;  ///< pairs with overlapping boxes in which nothing changed
  std::uint64_t pairs_asleep = 0;   ///< pairs in which something changed, but neither body is awake
  std::uint64_t pairs_apart = 0;    ///< pairs in which something moved, but by less than their gap
  std::uint64_t shape_tests = 0;    ///< pairs that were tested for touching
  std::uint64_t gaps_measured = 0;  ///< tested pairs whose gap was measured
  std::uint64_t pairs_near = 0;     ///< tested pairs that are within their margin and do not touch
  std::uint64_t contacts_found = 0;  ///< pairs whose contacts were computed
  /// Pairs in `moved`, or near, whose contacts were not computed: the settings ask for none, or one
  /// body is a sensor.
  std::uint64_t contacts_skipped = 0;

  // The next three count only with WorldSettings::islands.
  std::uint64_t islands_merged = 0;  ///< how often two islands became one
  std::uint64_t islands_split = 0;   ///< how often one island became two
  /// Bodies that went from one island to another, and edges that were looked at where a pair ended,
  /// to see whether its island is still one.
  std::uint64_t island_steps = 0;

  /// Pairs whose first contact was searched for, because the boxes around all places of both met.
  std::uint64_t pairs_swept = 0;

  /// Meshes of bodies, except parts of compounds, of whose tree nothing is built, because no query
  /// has walked it. A mesh counts once, however many bodies share it. A mesh whose tree was built
  /// elsewhere - by a query, by another world, by prepare() - is counted until an update looks at a
  /// body that has it.
  std::uint64_t trees_unbuilt = 0;

  /// The work of tests, gaps and contacts of Shapes: among others the trees that were built (other
  /// trees are left until something walks them), and searches among convex shapes that proved
  /// neither answer, which count as hits, or no least depth. The work of World::contacts() is not
  /// included.
  Work shapes;

  bool operator==(const WorldWork&) const = default;
};

/// The changes between two updates, each list in ascending order. The spans are valid until the
/// world's next update() or restore(): a loop that reads them may add, move and remove bodies.
struct WorldUpdate {
  std::span<const BodyPair> begun;  ///< pairs that touch now and did not
  std::span<const BodyPair> ended;  ///< pairs that touched and do not now, also because one body is
                                    ///< gone, or a filter keeps them apart
  /// Pairs that touch now and of which one body moved, came, woke or changed its filter.
  std::span<const BodyPair> moved;
  /// The contacts of the solid pairs in `moved`, and of near pairs of which one body moved, came,
  /// woke or changed its filter; empty unless the settings ask for contacts.
  std::span<const BodyContact> contacts;
  WorldWork work;  ///< what the update did and could leave out

  /// Pairs with a margin that are within it now, touching or not, and were not. The other lists of
  /// pairs are about touching.
  std::span<const BodyPair> begun_near;
  std::span<const BodyPair> ended_near;  ///< pairs that were within their margin and are not now

  /// The first contacts of bodies that are swept and moved, in ascending order of pairs, those of a
  /// pair by time. What the bodies do after their first contact is not looked at: a caller who
  /// stops a body there moves it, and updates again.
  std::span<const BodyFirstContact> first_contacts;
};

}  // namespace graze
