#pragma once

#include <graze/bvh/error.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/work.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape_motion.h>
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

/// The settings of a body. Each but the sides can be changed later.
struct BodySettings {
  BodyKind kind = BodyKind::Dynamic;  ///< who moves the body
  Filter filter = {};                 ///< which bodies it may meet
  std::uint64_t user_data = 0;        ///< a number that the world keeps and does not read
  Role role = Role::Solid;            ///< whether the body is solid or a sensor
  /// The margin of the body, metres, finite and not negative. Contacts of two bodies begin when
  /// they are apart by no more than the sum of both margins: ManifoldSettings says what they then
  /// are. A margin costs nothing if it is 0, and else up to one distance() for each pair that is
  /// looked at and does not touch.
  double margin = 0;
  /// What counts as a part of a mesh beside its surface: see ManifoldSettings. A body behind the
  /// surface then touches it in all lists and contacts of the world, but not in its queries.
  MeshSides sides = {};
  /// Whether the body is swept. Bodies that are not swept cost no more because others are.
  Detection detection = Detection::Discrete;

  bool operator==(const BodySettings&) const = default;
};

/// The largest WorldSettings::number.
inline constexpr std::uint32_t kLargestWorldNumber = 255;

/// The settings of a World. A world leaves out work that no answer needs: each setting that begins
/// with `skip_` stands for one such saving, and to switch it off changes no answer, only the cost.
struct WorldSettings {
  /// At most so many threads share each stage of update(); 0 means all threads of the machine.
  /// Only the thread that calls update() asks filters, and shapes of a user's own that do not allow
  /// other threads (BodyShape::allows_concurrent_calls()). Neither results nor WorldWork depend on
  /// it.
  int threads = 1;
  bool contacts = true;  ///< if true, update() finds contacts; else only World::contacts() does
  /// The number of this world among several, from 1 to kLargestWorldNumber; its ids carry the
  /// number, and worlds of other numbers refuse them. A world with 0 has no number, and nothing
  /// tells its ids from those of other worlds without one. A world with a number uses an index 2^23
  /// times, others 2^31 times. A world that is restored takes the number of the world that the
  /// snapshot is of, as all its ids do.
  std::uint32_t number = 0;
  /// If true, update() keeps islands up to date, for World::islands() and island(). This costs time
  /// for the pairs that begin and end, and 36 bytes for each body and 24 for each pair of bodies in
  /// islands, and up to as much again while their number grows.
  bool islands = false;
  RigidContactSettings sweeps = {};  ///< how first contacts of swept bodies are found
  /// A convex body that is swept and touches a mesh may get deeper behind a triangle of it by so
  /// much, metres, and still slide along that triangle. Triangles along which it slides are not
  /// listed again.
  double sliding_depth = 1e-3;

  bool skip_apart = true;         ///< pairs whose gap cannot have closed are not tested
  bool skip_at_rest = true;       ///< pairs in which nothing moved are not tested again
  bool skip_unused_trees = true;  ///< a mesh's tree is built when a query first walks it, not when
                                  ///< a body takes the mesh
};

/// Says which bodies a query of a world is about.
struct BodyQuerySettings {
  std::optional<Filter> filter =
      {};                         ///< if set, only bodies that may meet it by lets_pass(); else all
  std::optional<Role> role = {};  ///< if set, only solid bodies, or only sensors; else both
};

/// A body and its distance from a shape: A is the shape that was asked about, and B that of the
/// body.
struct BodyDistance {
  BodyId id;               ///< the id of the body
  ShapeDistance distance;  ///< the distance from the shape to the body
  std::uint32_t part = 0;  ///< the nearest part of a Compound, of equals the one with the least
                           ///< number

  bool operator==(const BodyDistance&) const = default;
};

/// A body and where a ray meets it first.
struct BodyRayHit {
  BodyId id;               ///< the id of the body
  RayHit hit;              ///< where the ray meets it first
  std::uint32_t part = 0;  ///< the part of a Compound that is met; of equal distances the least
                           ///< number

  bool operator==(const BodyRayHit&) const = default;
};

/// A body that a shape in motion comes to, and the time.
struct BodyCast {
  BodyId id;               ///< the id of the body
  RigidContact contact;    ///< first_contact() of the shape, A, and the body: Hit or Close
  std::uint32_t part = 0;  ///< the part of a Compound with the least `low`; of equals the least
                           ///< number

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

/// Holds bodies that move, and finds which of them touch. It looks only at bodies that moved: the
/// cost of a step grows with these and the pairs around them.
class World {
 public:
  /// Makes a world without bodies. Throws InputError for invalid settings.
  explicit World(const WorldSettings& settings = {});
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Adds a body. Throws PoseError for a pose that is not rigid, InputError for a shape without
  /// finite bounds or for an invalid margin, and as find_contacts() does for sides that do not suit
  /// the shape.
  BodyId add(const PlacedShapeView& shape, const BodySettings& settings = {});
  BodyId add(const PlacedBodyShape& shape, const BodySettings& settings = {});

  /// Takes a body out of the world. This function, and all others that take the id of a body, throw
  /// StaleIdError for a body that is gone.
  void remove(BodyId id);
  /// Takes the body to a pose, and wakes it. A swept body goes there from its pose at the last
  /// update: its origin moves straight, and it turns the short way (RigidMotion::between()).
  void move(BodyId id, const Pose& pose);
  /// Takes many bodies to their poses, and wakes them. Either all are moved or none: an error names
  /// the element that is to blame.
  void move(std::span<const BodyId> ids, std::span<const Pose> poses);
  /// Takes the body along a motion to its end, at(1), and wakes it. A swept body is swept along
  /// that motion; for others this is move() to the pose at its end. Throws InputError if the body
  /// is swept and the motion does not start, to the bit, where the body was at the last update, or
  /// where it was added or set to be swept since then.
  void move(BodyId id, const RigidMotion& motion);
  /// Gives the body another shape where it is, and wakes it: a mesh that deforms is a new mesh in
  /// each step. The sides that the settings gave it stay, and must suit the new shape. Throws as
  /// add() does, and then leaves the body as it was.
  void set_shape(BodyId id, const Shape& shape);
  void set_shape(BodyId id, std::shared_ptr<const BodyShape> shape);

  /// Change the filter, the kind or the role of a body from the next update() on.
  void set_filter(BodyId id, const Filter& filter);
  void set_kind(BodyId id, BodyKind kind);
  void set_role(BodyId id, Role role);
  /// Changes the margin from the next update() on. Throws InputError for a margin that is negative,
  /// infinite or NaN.
  void set_margin(BodyId id, double margin);
  /// Sets whether the body is swept from here on: its motion before this call is forgotten. So to
  /// take a swept body elsewhere without sweeping it, move it, and set Continuous again.
  void set_detection(BodyId id, Detection detection);
  /// Sets a number that the world keeps and does not read.
  void set_user_data(BodyId id, std::uint64_t data);

  /// Put a body to sleep, or wake it. A body that is added is awake; one that is moved or takes
  /// another shape wakes. An update looks at a pair if one of the two changed (it came, moved,
  /// woke, or took another shape, filter, kind or role) and one of the two is awake. So a body that
  /// lies still costs nothing, asleep or not. A body that is put to sleep where it was moved to is
  /// not tested against others that sleep, nor against static bodies: the last answer stands until
  /// one of the two wakes, but ends if their boxes part, a filter keeps them apart or one is
  /// removed. A body that wakes is listed with all that it touches.
  ///
  /// The world itself wakes no body: a body that comes to touch one that sleeps is listed with it
  /// in each update in which it moves, and the pair is listed in `ended` when it leaves. The
  /// solver, which knows speeds, decides which bodies wake; island() says which others wake with
  /// them.
  ///
  /// A static body is not awake, unless it is a sensor; but its pairs are looked at in the update
  /// after it changed. Putting a body to sleep that sleeps, or waking one that is awake, does
  /// nothing.
  void sleep(BodyId id);
  void wake(BodyId id);
  /// Put many bodies, such as an island(), to sleep, or wake them. Either all are changed or none:
  /// an error names the element that is to blame.
  void sleep(std::span<const BodyId> ids);
  void wake(std::span<const BodyId> ids);

  /// Say that two bodies never meet, or may meet again. An exclusion ends when either body is
  /// removed.
  void exclude(BodyId a, BodyId b);
  void include(BodyId a, BodyId b);

  /// Sets a filter of the user's own. It is asked last, once for each pair whose boxes begin to
  /// overlap and that all filters let pass. It must not change the world: functions that would,
  /// within an update, throw InputError.
  void set_pair_filter(std::function<bool(BodyId, BodyId)> filter);

  /// True if the world has a body with this id.
  bool contains(BodyId id) const;
  std::size_t size() const;
  /// Returns all bodies, or those that the settings ask for, in ascending order.
  std::vector<BodyId> bodies(const BodyQuerySettings& settings = {}) const;
  /// Returns the pose that the body was given last.
  const Pose& pose(BodyId id) const;
  /// Returns the shape of the body. It is valid until the body is gone or takes another shape.
  const BodyShape& shape(BodyId id) const;
  /// Returns the kind that settings or set_kind() gave last.
  BodyKind kind(BodyId id) const;
  /// Returns the role that settings or set_role() gave last.
  Role role(BodyId id) const;
  /// Returns the margin that settings or set_margin() gave last, metres.
  double margin(BodyId id) const;
  /// Returns the detection that settings or set_detection() gave last.
  Detection detection(BodyId id) const;
  /// Returns the sides that the settings gave.
  const MeshSides& sides(BodyId id) const;
  /// Returns the filter that settings or set_filter() gave last.
  const Filter& filter(BodyId id) const;
  /// Returns the number that settings or set_user_data() gave last.
  std::uint64_t user_data(BodyId id) const;
  /// True if the body is awake: see sleep(). Static bodies are not, unless they are sensors.
  bool is_awake(BodyId id) const;

  /// Brings all pairs up to date. It throws where a filter or a shape of a user's own throws, or
  /// where memory is short (std::bad_alloc); the next update then looks at every body as if it had
  /// changed, and lists what has begun and ended since the last update that was completed.
  WorldUpdate update();

  /// Returns all pairs that touched at the last update, in ascending order, without bodies that
  /// were removed since. It costs O(pairs log pairs).
  std::vector<BodyPair> pairs() const;

  /// Returns all pairs with a margin that were within it at the last update, whether they touched
  /// or not, in ascending order, without bodies that were removed since.
  std::vector<BodyPair> near_pairs() const;

  /// Return the pairs of either kind at the last update that one body belongs to, and the bodies
  /// that it touched then, in ascending order, without bodies that were removed since. While
  /// changes wait for an update they cost O(all pairs), and else only the work for the bodies
  /// around this one.
  std::vector<BodyPair> pairs(BodyId id) const;
  std::vector<BodyPair> near_pairs(BodyId id) const;
  std::vector<BodyId> touching(BodyId id) const;

  /// Returns the islands: the smallest sets of solid dynamic bodies such that a set with a body has
  /// all other such bodies that this one touches. Static and kinematic bodies and sensors are in no
  /// island, and do not connect others; a body that touches no other is an island of its own.
  /// Islands are those of the last update, without bodies that were removed since; bodies that were
  /// added since are in none. Each island is ascending, and the islands are ordered by their first
  /// bodies. Throws InputError if the settings do not ask for islands (WorldSettings::islands). It
  /// costs O(bodies log bodies).
  std::vector<std::vector<BodyId>> islands() const;
  /// Returns the island of a body, itself included; empty if the body is in no island. Throws as
  /// islands() does. It costs O(n log n) for n bodies in the island.
  std::vector<BodyId> island(BodyId id) const;

  /// Returns the contacts of all solid pairs that touch or are near, in ascending order. Each is
  /// computed from the poses that bodies have now: for bodies that were put to sleep where they
  /// were moved to there may be none. Throws InputError while changes wait for an update.
  std::vector<BodyContact> contacts() const;
  /// Returns the contacts of one body's pairs. Throws as contacts() of all does.
  std::vector<BodyContact> contacts(BodyId id) const;

  /// Returns the bodies whose boxes share a point with `box`, in ascending order.
  std::vector<BodyId> find_in_box(const Aabb& box, const BodyQuerySettings& settings = {}) const;

  /// Returns the bodies that touch a shape that is no body's own, in ascending order. Bodies are as
  /// they are now, moves since the last update included. Throws PoseError.
  std::vector<BodyId> find_touching(const PlacedShapeView& shape,
                                    const BodyQuerySettings& settings = {}) const;

  /// Returns the bodies whose distance() to such a shape is at most the clearance, metres, as they
  /// are now and in ascending order. Throws PoseError, InputError for a clearance that is not
  /// finite or negative, and UnsupportedPairError where it has to measure a shape of a user's own.
  std::vector<BodyDistance> find_within(const PlacedShapeView& shape, double clearance,
                                        const BodyQuerySettings& settings = {}) const;

  /// Returns the body whose distance() is least, the first of equals, or nothing if the settings
  /// leave out all bodies. Throws as find_within() does.
  std::optional<BodyDistance> find_closest(const PlacedShapeView& shape,
                                           const BodyQuerySettings& settings = {}) const;

  /// Returns the pairs of a body of this world and a body of another world that touch. The other
  /// world stands in this one in a pose, such as a robot in its cell. Surfaces count, as in
  /// intersects(); all bodies are as they are now, and pairs are in ascending order. Each body of
  /// the other world is in the pose placed_part(other.pose, its own pose). Kinds and exclusions do
  /// not count, because they are each world's own. For n bodies in the other world and m in this
  /// one it costs O(n log m) and the work for near bodies: where that matters the smaller world
  /// should be the other one. Throws PoseError.
  std::vector<WorldBodyPair> find_touching(const PlacedWorldView& other,
                                           const WorldPairSettings& settings = {}) const;

  /// Returns the pairs of the two worlds whose distance() is at most the clearance, metres, with
  /// all bodies as they are now, as in find_touching() of two worlds, and in ascending order.
  /// Throws as find_within() of one shape does.
  std::vector<BodyPairDistance> find_within(const PlacedWorldView& other, double clearance,
                                            const WorldPairSettings& settings = {}) const;

  /// Returns the pair of the two worlds whose distance() is least, the first of equals, or nothing
  /// if the settings leave out all pairs.
  std::optional<BodyPairDistance> find_closest(const PlacedWorldView& other,
                                               const WorldPairSettings& settings = {}) const;

  /// Returns the pair of bodies of this world whose distance() is least, the first of equals, or
  /// nothing if no two bodies may meet. Kinds, filters, exclusions and the user's own filter say
  /// which may meet. The user's filter is asked about each pair that is looked at, and must not
  /// change the world. A is the body with the smaller index.
  std::optional<BodyPairDistance> find_closest_pair(const WorldPairSettings& settings = {}) const;

  /// Returns the body that a ray meets first, by cast_ray() of its shape in its pose now; of equal
  /// distances the one with the smaller id. Throws as check_ray() does, and UnsupportedPairError if
  /// the ray comes near a shape of a user's own that knows no rays.
  std::optional<BodyRayHit> cast_ray(const Ray& ray, const BodyQuerySettings& settings = {}) const;

  /// Returns where a ray first meets each body that it meets, ordered by distance, then by id.
  /// Throws as cast_ray() does.
  std::vector<BodyRayHit> cast_ray_all(const Ray& ray,
                                       const BodyQuerySettings& settings = {}) const;

  /// Returns the body to which a shape in rigid motion comes first (law 14): the one with the least
  /// `low` among those that are not Free, of equals the one with the smaller id; nothing if the
  /// motion is free of all bodies that are asked for. Bodies rest where they are now. A body that
  /// the shape touches where it starts has time 0, and can be left out by a filter. No body is
  /// missed, however thin it is. Throws as first_contact() does, and UnsupportedPairError if the
  /// shape comes near a shape of a user's own. A body is tested if the shape's box, on its way,
  /// comes to the body's own, in the order in which the boxes meet, until no body that is left can
  /// be met earlier. A long motion with turns is better split into several, because a box around
  /// all places of a motion that turns is compared. Where a budget ends, `low` is no earlier than
  /// the time at which boxes meet.
  std::optional<BodyCast> cast(const ShapeInMotion& shape, const RigidContactSettings& contact = {},
                               const BodyQuerySettings& settings = {}) const;

  /// Returns all bodies that a shape in rigid motion comes to, ordered by `low`, then by id. Throws
  /// as cast() does.
  std::vector<BodyCast> cast_all(const ShapeInMotion& shape,
                                 const RigidContactSettings& contact = {},
                                 const BodyQuerySettings& settings = {}) const;

  /// Return a copy of the world's state, and bring a world back to one. snapshot() throws
  /// InputError while changes wait for an update. After restore() all answers are those that the
  /// world gave after the snapshot, bit for bit.
  WorldSnapshot snapshot() const;
  void restore(const WorldSnapshot& snapshot);

 private:
  friend struct WorldJournalAccess;
  struct State;
  class OtherBodies;
  std::unique_ptr<State> state_;
};

}  // namespace graze
