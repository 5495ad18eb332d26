#pragma once

// What an update of a world says.

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/work.h>
#include <graze/engine/world/ids.h>
#include <graze/engine/world/manifold.h>
#include <Eigen/Core>

#include <cstdint>
#include <span>

namespace graze {

/// Where two solid bodies that touch meet, or that are near, if they have a margin. Half-spaces
/// among themselves, and shapes of a user's own that tell of none, touch with an empty manifold. Of
/// a Compound there is one for each part that meets a body, or a part of another:
/// Manifold::part_a() and part_b() say which.
struct BodyContact {
  BodyPair pair;      ///< touches, or is near: then no depth is above 0
  Manifold manifold;  ///< as find_contacts() says, normals from pair.a to pair.b

  bool operator==(const BodyContact&) const = default;
};

/// Two bodies of which one is swept (Detection) and which are not proved to stay apart from one
/// update to the next. Times go from 0, the last update, to 1, this one.
struct BodyFirstContact {
  BodyPair pair;  ///< as all pairs: sensors too, and as filters say now
  /// Hit or Close: first_contact() of both in motion. Close from 0 on, out of budget, where a shape
  /// of a user's own does not know.
  RigidContact contact;
  /// Whether they touch at 0: then `low` is 0, and what a solver does with the contacts of the last
  /// update is all that there is to do. A convex body that is no further than the tolerance from a
  /// mesh at 0, which does not turn, is listed with it once more, with the first triangle that it
  /// comes to after that and does not slide along (WorldSettings::sliding_depth), as a wall is for
  /// what lies on the floor beside it; two meshes, or convex bodies, that are so near are not.
  bool is_at_start;
  /// At `low`, unit, from pair.a to pair.b; zero where nothing tells it: for two half-spaces and
  /// for shapes of a user's own.
  Eigen::Vector3d normal;
  Eigen::Vector3d point;     ///< at `low`, between the two, in the world's frame; likewise
  std::uint32_t part_a = 0;  ///< of pair.a, if that is a Compound: each pair of parts is one of its
                             ///< own
  std::uint32_t part_b = 0;  ///< of pair.b, likewise

  bool operator==(const BodyFirstContact&) const = default;
};

/// What an update did, and what it could leave out.
struct WorldWork {
  /// Pairs of bodies that do not meet: of those whose boxes began to overlap, or for whom a filter,
  /// kind, role or exclusion changed. After that they cost nothing, and are not counted.
  std::uint64_t pairs_filtered = 0;
  std::uint64_t pairs_at_rest = 0;  ///< pairs with overlapping boxes in which nothing changed
  std::uint64_t pairs_asleep = 0;   ///< pairs in which something changed, but neither body is awake
  std::uint64_t pairs_apart = 0;    ///< pairs in which something moved, but by less than their gap
  std::uint64_t shape_tests = 0;    ///< pairs that were asked whether they touch
  std::uint64_t gaps_measured = 0;  ///< gaps of pairs that were tested
  std::uint64_t pairs_near = 0;     ///< tested pairs that are within their margin and do not touch
  std::uint64_t contacts_found = 0;  ///< pairs whose contacts were asked for
  /// Pairs in `moved`, or near, without contacts: the settings ask for none, or one is a sensor.
  std::uint64_t contacts_skipped = 0;

  // Of WorldSettings::islands.
  std::uint64_t islands_merged = 0;  ///< times that two islands became one
  std::uint64_t islands_split = 0;   ///< times that one became two
  /// Bodies that went from one island to another, and touches that were looked at where a pair
  /// ended, to see whether its island is still one.
  std::uint64_t island_steps = 0;

  /// Pairs that were asked for their first contact: the boxes around all places of both met.
  std::uint64_t pairs_swept = 0;

  /// Meshes of bodies that are there, but for those of compounds, each once however many bodies
  /// share it, of whose tree nothing is built, because nobody has walked it. One that was built
  /// elsewhere - by a query, by another world, by prepare() - is counted until an update looks at a
  /// body that has it.
  std::uint64_t trees_unbuilt = 0;

  /// What tests, gaps and contacts of Shapes did. Above all the trees that it built, those of other
  /// meshes being left until something walks them; and searches among convex shapes that proved
  /// neither answer, which count as hits, or no least depth. Not what World::contacts() does.
  Work shapes;

  bool operator==(const WorldWork&) const = default;
};

/// What changed between two updates, each list in ascending order. The spans are valid until the
/// world's next update() or restore(): a loop that reads them may add, move and remove bodies.
struct WorldUpdate {
  std::span<const BodyPair> begun;  ///< touch now and did not
  std::span<const BodyPair> ended;  ///< touched and do not now, also because one body is gone, or a
                                    ///< filter keeps them apart
  /// Pairs that touch now and of which one body moved, came, woke or changed its filter.
  std::span<const BodyPair> moved;
  /// Of the solid pairs in `moved`, and of those that would be there if to be near were to touch;
  /// if the settings ask.
  std::span<const BodyContact> contacts;
  WorldWork work;  ///< what it did and could leave out

  /// Pairs with a margin that are within it now, touching or not, and were not. All lists but these
  /// two mean the touch.
  std::span<const BodyPair> begun_near;
  std::span<const BodyPair> ended_near;  ///< were within their margin and are not

  /// First contacts of the bodies that are swept and moved, in ascending order of pairs, those of a
  /// pair by time. Whatever
  /// the bodies do after that is not looked at: who stops a body there moves it, and updates again.
  std::span<const BodyFirstContact> first_contacts;
};

}  // namespace graze
