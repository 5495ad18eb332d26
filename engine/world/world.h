#pragma once

#include <graze/bvh/error.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/work.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/world_pairs.h>
#include <graze/engine/world/world_update.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// What a body is to others. Each can be changed later.
struct BodySettings {
  BodyKind kind = BodyKind::Dynamic;  ///< who moves it
  Filter filter = {};                 ///< whom it meets
  std::uint64_t user_data = 0;        ///< a number that the world keeps and does not read
  Role role = Role::Solid;            ///< whether it meets others, or is told of them
  /// Metres, finite and not negative. Contacts of two bodies begin when they are apart by no more
  /// than the sum of both margins: ManifoldSettings says what they then are. Costs nothing where it
  /// is 0; else up to a distance() for each pair that is looked at and does not touch.
  double margin = 0;
  /// What of a mesh counts beside its surface: see ManifoldSettings. What is behind it touches
  /// then, in all lists and contacts of the world, not in its queries.
  MeshSides sides = {};
  /// Whether it is swept. Bodies that are not cost what they cost without any that is.
  Detection detection = Detection::Discrete;
};

/// The largest WorldSettings::number.
inline constexpr std::uint32_t kLargestWorldNumber = 255;

/// How a World works. What need not be done is left out: each setting that begins with `skip_`
/// switches one such saving off, which changes no answer, only what it costs.
struct WorldSettings {
  /// How many threads share each stage of update() at most; 0: all that there are. Filters are
  /// asked by the thread that calls it, and so are shapes of a user's own that do not allow others
  /// (BodyShape::allows_concurrent_calls()). No result depends on it, nor does WorldWork.
  int threads = 1;
  bool contacts = true;  ///< update() finds contacts; without, only World::contacts() does
  /// Which of several worlds it is, from 1 to kLargestWorldNumber; its ids carry it, and are
  /// refused by all worlds but those of its number. 0: none, and nothing tells its ids from those
  /// of others without one. A world with a number uses an index 2^23 times, others 2^31 times. A
  /// world that is restored takes the number of the world that the snapshot is of, as all its ids
  /// do.
  std::uint32_t number = 0;
  /// update() keeps up islands, for World::islands() and island(): at the cost of the pairs that
  /// begin and end, of 36 bytes for each body and 24 for each pair of two in islands, and up to as
  /// much again while they become more.
  bool islands = false;
  RigidContactSettings sweeps = {};  ///< how first contacts of bodies that are swept are found
  /// Metres. A convex body that is swept and touches a mesh slides along those triangles of it that
  /// it gets no deeper behind than this, beyond how deep it is already: they are not listed again.
  double sliding_depth = 1e-3;

  bool skip_apart = true;         ///< pairs whose gap cannot have closed are not tested
  bool skip_at_rest = true;       ///< pairs in which nothing moved are not tested again
  bool skip_unused_trees = true;  ///< a mesh's tree is built where a query first walks it; else
                                  ///< when a body takes the mesh
};

/// Which bodies a query of a world is about.
struct BodyQuerySettings {
  std::optional<Filter> filter =
      {};                         ///< only bodies that lets_pass() lets meet it; else all bodies
  std::optional<Role> role = {};  ///< only solid bodies, or only sensors; else both
};

/// A body and how far it is from a shape: A is the shape that was asked about, B the body's.
struct BodyDistance {
  BodyId id;               ///< of the body
  ShapeDistance distance;  ///< from the shape to the body
  std::uint32_t part = 0;  ///< of a Compound: the nearest, of equals that of the least number

  bool operator==(const BodyDistance&) const = default;
};

/// A body and where a ray meets it first.
struct BodyRayHit {
  BodyId id;               ///< of the body
  RayHit hit;              ///< where the ray meets it first
  std::uint32_t part = 0;  ///< of a Compound: of equal distances the least number

  bool operator==(const BodyRayHit&) const = default;
};

/// A body that a shape in motion comes to, and when.
struct BodyCast {
  BodyId id;               ///< of the body
  RigidContact contact;    ///< Hit or Close: first_contact() of the shape, A, and the body
  std::uint32_t part = 0;  ///< of a Compound: that whose `low` is least, of equals by number

  bool operator==(const BodyCast&) const = default;
};

/// A copy of a world's state, for World::restore().
class WorldSnapshot {
 public:
  WorldSnapshot(const WorldSnapshot&) = default;
  WorldSnapshot& operator=(const WorldSnapshot&) = default;

 private:
  friend class World;
  friend struct WorldSnapshotAccess;
  struct State;
  explicit WorldSnapshot(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// Bodies that move, and which of them touch. It looks only at what moved: a step costs what the
/// movers and the pairs around them do.
class World {
 public:
  /// Without bodies. Throws InputError for settings that are none.
  explicit World(const WorldSettings& settings = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Throws PoseError for a pose that is not rigid, InputError for a shape without finite bounds or
  /// a margin that is none, and as find_contacts() does for sides that the shape has not.
  BodyId add(const PlacedShapeView& shape, const BodySettings& settings = {});
  BodyId add(const PlacedBodyShape& shape, const BodySettings& settings = {});

  /// Takes a body out of the world. This, and all that take the id of one body, throw StaleIdError
  /// for a body that is gone.
  void remove(BodyId id);
  /// Takes the body to a pose, and wakes it. One that is swept goes there from where it was at the
  /// last update: its origin straight, and turning the short way (RigidMotion::between()).
  void move(BodyId id, const Pose& pose);
  /// The same of many bodies. Moves all or none: an error names the element that is to blame.
  void move(std::span<const BodyId> ids, std::span<const Pose> poses);
  /// Takes the body along a motion to its end, at(1), and wakes it: what is swept is swept along
  /// that motion, others as by move() to that pose. Of one that is swept throws InputError if it
  /// does not start, to the bit, where the body was at the last update; or where it was added or
  /// set to be swept since.
  void move(BodyId id, const RigidMotion& motion);
  /// Gives the body another shape where it is, and wakes it: a mesh that deforms is a new mesh in
  /// each step. Throws as add() does, and leaves the body as it was.
  /// Sides that the settings gave it stay, and must suit the new shape.
  void set_shape(BodyId id, const Shape& shape);
  void set_shape(BodyId id, std::shared_ptr<const BodyShape> shape);

  /// These four hold from the next update() on.
  void set_filter(BodyId id, const Filter& filter);
  void set_kind(BodyId id, BodyKind kind);
  void set_role(BodyId id, Role role);
  /// This holds from then on, too. Throws InputError for a margin that is negative, infinite or
  /// NaN.
  void set_margin(BodyId id, double margin);
  /// Sets whether the body is swept from here on: how it moved before this call is forgotten. So
  /// to take a body elsewhere without sweeping it, move it, and set Continuous again.
  void set_detection(BodyId id, Detection detection);
  /// A number that the world keeps and does not read.
  void set_user_data(BodyId id, std::uint64_t data);

  /// A body that comes is awake; what is moved or takes another shape wakes. An update looks at a
  /// pair if one of the two changed - came, moved, woke, took another shape, filter, kind or role
  /// - and one of the two is awake. So what lies still costs nothing, asleep or not; and what is
  /// put to sleep where it was moved to is not asked about others that sleep, nor about what is
  /// static: the last answer stands until one of the two wakes, but ends if their boxes part, a
  /// filter keeps them apart or one is removed. What wakes is listed with all that it touches.
  ///
  /// The world wakes nobody: a body that comes to touch one that sleeps is listed with it in each
  /// update in which it moves, and one that leaves it in `ended`. Whom that wakes is for a solver
  /// to decide, who knows of speeds; with whom says island().
  ///
  /// A static body is not awake, unless it is a sensor; but its pairs are looked at in the update
  /// after it changed. To put a body to sleep that sleeps, or wake one that is awake, does nothing.
  void sleep(BodyId id);
  void wake(BodyId id);
  /// The same of many bodies, such as an island(). All or none: an error names the element that is
  /// to blame.
  void sleep(std::span<const BodyId> ids);
  void wake(std::span<const BodyId> ids);

  /// Says that two bodies never meet, or may meet again. An exclusion ends with either body.
  void exclude(BodyId a, BodyId b);
  void include(BodyId a, BodyId b);

  /// The filter is asked last, once for each pair whose boxes begin to overlap and that all filters
  /// let pass. It cannot change the world: what tries to, within an update, throws InputError.
  void set_pair_filter(std::function<bool(BodyId, BodyId)> filter);

  /// Whether the id is of a body that is there.
  bool contains(BodyId id) const;
  std::size_t size() const;
  /// All bodies, or those that are asked for, in ascending order.
  std::vector<BodyId> bodies(const BodyQuerySettings& settings = {}) const;
  /// Where the body was put last.
  const Pose& pose(BodyId id) const;
  /// What it was added with; valid until the body is gone or takes another.
  const BodyShape& shape(BodyId id) const;
  /// What settings or set_kind() said last.
  BodyKind kind(BodyId id) const;
  /// What settings or set_role() said last.
  Role role(BodyId id) const;
  /// What settings or set_margin() said last.
  double margin(BodyId id) const;
  /// What settings or set_detection() said last.
  Detection detection(BodyId id) const;
  /// What settings said, while the body has the mesh.
  const MeshSides& sides(BodyId id) const;
  /// What settings or set_filter() said last.
  const Filter& filter(BodyId id) const;
  /// What settings or set_user_data() said last.
  std::uint64_t user_data(BodyId id) const;
  /// Whether it is awake: see sleep(). Static bodies are not, unless they are sensors.
  bool is_awake(BodyId id) const;

  /// Brings all pairs up to date. Where a filter or a shape of a user's own throws, or memory is
  /// short (std::bad_alloc), so does this; the next update then looks at every body as if it had
  /// changed, and lists what has begun and ended since the last one that came to its end.
  WorldUpdate update();

  /// All pairs that touched at the last update, in ascending order, without bodies that were
  /// removed since. O(pairs log pairs).
  std::vector<BodyPair> pairs() const;

  /// All pairs with a margin that were within it at the last update, likewise; whether they touch
  /// or not.
  std::vector<BodyPair> near_pairs() const;

  /// Those pairs of both kinds that one body is of, and the bodies that it touched at the last
  /// update, likewise. While changes wait for an update O(all pairs), else what bodies around it
  /// cost.
  std::vector<BodyPair> pairs(BodyId id) const;
  std::vector<BodyPair> near_pairs(BodyId id) const;
  std::vector<BodyId> touching(BodyId id) const;

  /// The islands: sets of solid dynamic bodies, such that those of them that a body of a set
  /// touches are in it, too, and no smaller one would do. Static and kinematic bodies and sensors
  /// join none, and none to another; a body that touches no other is an island of its own. As the
  /// last update found them, without bodies that were removed since; those that came since are in
  /// none. Each ascending, and the islands by their first bodies. Throws InputError if the settings
  /// ask for none (WorldSettings::islands). O(bodies log bodies).
  std::vector<std::vector<BodyId>> islands() const;
  /// The island that a body is in, itself included; none for one that is in no island. Throws
  /// likewise. O(n log n) for n bodies in it.
  std::vector<BodyId> island(BodyId id) const;

  /// The contacts of all solid pairs that touch or are near, in ascending order. Computes each: for
  /// bodies that were put to sleep where they were moved to from where they are, which may be none.
  /// Throws InputError while changes wait for an update.
  std::vector<BodyContact> contacts() const;
  /// Those of one body's pairs. Throws likewise.
  std::vector<BodyContact> contacts(BodyId id) const;

  /// The bodies whose boxes share a point with `box`, in ascending order.
  std::vector<BodyId> find_in_box(const Aabb& box, const BodyQuerySettings& settings = {}) const;

  /// The bodies that touch a shape that is none of them: as they are now, moves since the last
  /// update included, and in ascending order. Throws PoseError.
  std::vector<BodyId> find_touching(const PlacedShapeView& shape,
                                    const BodyQuerySettings& settings = {}) const;

  /// The bodies whose distance() to such a shape is at most the clearance, metres, likewise. Throws
  /// PoseError, InputError for a clearance that is not finite or negative, and UnsupportedPairError
  /// where it has to measure a shape of a user's own.
  std::vector<BodyDistance> find_within(const PlacedShapeView& shape, double clearance,
                                        const BodyQuerySettings& settings = {}) const;

  /// The body whose distance() is least, the first of equals; none if the settings ask for none.
  /// Throws as find_within() does.
  std::optional<BodyDistance> find_closest(const PlacedShapeView& shape,
                                           const BodyQuerySettings& settings = {}) const;

  /// The pairs of a body of this world and one of another world that stands in it in a pose, such
  /// as a robot in its cell, that touch, by their surfaces as intersects() has it; as all are now,
  /// and in ascending order. Each body of the other stands in placed_part(other.pose, its own
  /// pose). Neither kinds nor exclusions count, which are each world's own. For n bodies there O(n
  /// log m) and what is near: where that matters the other is the smaller. Throws PoseError.
  std::vector<WorldBodyPair> find_touching(const PlacedWorldView& other,
                                           const WorldPairSettings& settings = {}) const;

  /// Those whose distance() is at most the clearance, metres, likewise. Throws as the question
  /// about one shape does.
  std::vector<BodyPairDistance> find_within(const PlacedWorldView& other, double clearance,
                                            const WorldPairSettings& settings = {}) const;

  /// The pair whose distance() is least, the first of equals; none if the settings ask for none.
  std::optional<BodyPairDistance> find_closest(const PlacedWorldView& other,
                                               const WorldPairSettings& settings = {}) const;

  /// The same of two bodies of this world that may meet: by kinds, filters, exclusions, and the
  /// user's own filter, which is asked about each pair that is looked at and must not change the
  /// world. A is the one of the smaller index.
  std::optional<BodyPairDistance> find_closest_pair(const WorldPairSettings& settings = {}) const;

  /// The body that a ray meets first, as cast_ray() of a shape says, bodies being as they are now;
  /// of equal distances the one with the smaller id. Throws as check_ray() does, and
  /// UnsupportedPairError if the ray comes near a shape of a user's own that does not know.
  std::optional<BodyRayHit> cast_ray(const Ray& ray, const BodyQuerySettings& settings = {}) const;

  /// Where it first meets each body that it meets, by distance, then by id. Throws likewise.
  std::vector<BodyRayHit> cast_ray_all(const Ray& ray,
                                       const BodyQuerySettings& settings = {}) const;

  /// The body to which a shape in rigid motion comes first (law 14): that of the least `low` that
  /// is not Free, of equals the one with the smaller id; nothing if the motion is free of all that
  /// are asked for. Bodies are as they are now, and rest; one that the shape touches where it
  /// starts has time 0, and can be left out by a filter. However thin a body, none is missed.
  /// Throws as first_contact() does, and UnsupportedPairError if the shape comes near one of a
  /// user's own. A body is asked if the shape's box, on its way, comes to its own; and, from the
  /// first on, until what is known cannot be later. A long motion that turns is better asked in
  /// parts, for then boxes of all its places are compared. Where a budget ends, `low` is no earlier
  /// than boxes meet.
  std::optional<BodyCast> cast(const Shape& shape, const RigidMotion& motion,
                               const RigidContactSettings& contact = {},
                               const BodyQuerySettings& settings = {}) const;

  /// All that it comes to, by `low`, then by id. Throws likewise.
  std::vector<BodyCast> cast_all(const Shape& shape, const RigidMotion& motion,
                                 const RigidContactSettings& contact = {},
                                 const BodyQuerySettings& settings = {}) const;

  /// A copy of all there is, and the world as it was. Throws InputError while changes wait for an
  /// update. From a restored world on, all is as it was from there the first time, bit for bit.
  WorldSnapshot snapshot() const;
  void restore(const WorldSnapshot& snapshot);

 private:
  friend struct WorldJournalAccess;
  struct State;
  class OtherBodies;
  std::unique_ptr<State> state_;
};

}  // namespace graze
