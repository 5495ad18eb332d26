#pragma once

#include <graze/bvh/error.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/work.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape_pairs.h>

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

/// How a World works. What need not be done is left out: each setting that begins with `skip_`
/// switches one such saving off, which changes no answer, only what it costs.
struct WorldSettings {
  /// How many threads share each stage of update() at most; 0: all that there are. Filters are
  /// asked by the thread that calls it, and so are shapes of a user's own that do not allow others
  /// (BodyShape::allows_concurrent_calls()). No result depends on it, nor does WorldWork.
  int threads = 1;
  bool contacts = true;  ///< update() finds contacts; without, only World::contacts() does
  RigidContactSettings sweeps = {};  ///< how first contacts of bodies that are swept are found
  /// Metres. A convex body that is swept and touches a mesh slides along those triangles of it that
  /// it gets no deeper behind than this, beyond how deep it is already: they are not listed again.
  double sliding_depth = 1e-3;

  bool skip_apart = true;         ///< pairs whose gap cannot have closed are not tested
  bool skip_at_rest = true;       ///< pairs in which nothing moved are not tested again
  bool skip_unused_trees = true;  ///< a mesh's tree is built where a query first walks it; else
                                  ///< when a body takes the mesh
};

/// Where two solid bodies that touch meet, or that are near, if they have a margin. Half-spaces
/// among themselves, and shapes of a user's own that tell of none, touch with an empty manifold.
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
  bool touches_at_start;
  /// At `low`, unit, from pair.a to pair.b; zero where nothing tells it: for two half-spaces and
  /// for shapes of a user's own.
  Eigen::Vector3d normal;
  Eigen::Vector3d point;  ///< at `low`, between the two, in the world's frame; likewise

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

  /// Pairs that were asked for their first contact: the boxes around all places of both met.
  std::uint64_t pairs_swept = 0;

  /// Meshes of bodies that are there, each once however many bodies share it, of whose tree nothing
  /// is built, because nobody has walked it. One that was built elsewhere - by a query, by another
  /// world, by prepare() - is counted until an update looks at a body that has it.
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

  bool operator==(const BodyDistance&) const = default;
};

/// A body and where a ray meets it first.
struct BodyRayHit {
  BodyId id;   ///< of the body
  RayHit hit;  ///< where the ray meets it first

  bool operator==(const BodyRayHit&) const = default;
};

/// A body that a shape in motion comes to, and when.
struct BodyCast {
  BodyId id;             ///< of the body
  RigidContact contact;  ///< Hit or Close: first_contact() of the shape, A, and the body

  bool operator==(const BodyCast&) const = default;
};

/// A copy of a world's state, for World::restore().
class WorldSnapshot {
 public:
  WorldSnapshot(const WorldSnapshot&) = default;
  WorldSnapshot& operator=(const WorldSnapshot&) = default;

 private:
  friend class World;
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
  /// Likewise. Throws InputError for a margin that is negative, infinite or NaN.
  void set_margin(BodyId id, double margin);
  /// Whether the body is swept from here on: a way that it went before this call is forgotten. So
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
  /// update in which it moves, and one that leaves it in `ended`. Whom that wakes, and with whom,
  /// is for a solver to decide, who knows of speeds and of islands.
  ///
  /// A static body is not awake, unless it is a sensor; but its pairs are looked at in the update
  /// after it changed. To put a body to sleep that sleeps, or wake one that is awake, does nothing.
  void sleep(BodyId id);
  void wake(BodyId id);

  /// Two bodies never meet, or may meet again. An exclusion ends with either body.
  void exclude(BodyId a, BodyId b);
  void include(BodyId a, BodyId b);

  /// Asked last, once for each pair whose boxes begin to overlap and that all filters let pass. It
  /// cannot change the world: what tries to, within an update, throws InputError.
  void set_pair_filter(std::function<bool(BodyId, BodyId)> filter);

  /// Whether the id is of a body that is there.
  bool contains(BodyId id) const;
  std::size_t size() const;
  /// Where the body was put last.
  const Pose& pose(BodyId id) const;
  /// What it was added with; valid until the body is gone or takes another.
  const BodyShape& shape(BodyId id) const;
  /// As settings or set_kind() said last.
  BodyKind kind(BodyId id) const;
  /// As settings or set_role() said last.
  Role role(BodyId id) const;
  /// As settings or set_margin() said last.
  double margin(BodyId id) const;
  /// As settings or set_detection() said last.
  Detection detection(BodyId id) const;
  /// As settings said, while it has the mesh.
  const MeshSides& sides(BodyId id) const;
  /// As settings or set_filter() said last.
  const Filter& filter(BodyId id) const;
  /// As settings or set_user_data() said last.
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

  /// The contacts of all solid pairs that touch or are near, in ascending order. Computes each: for
  /// bodies that were put to sleep where they were moved to from where they are, which may be none.
  /// Throws InputError while changes wait for an update.
  std::vector<BodyContact> contacts() const;

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
  /// user's own. A body is asked if its box meets that of all places of the shape, so that a long
  /// motion that turns is better asked in parts.
  std::optional<BodyCast> cast(const Shape& shape, const RigidMotion& motion,
                               const RigidContactSettings& contact = {},
                               const BodyQuerySettings& settings = {}) const;

  /// All that it comes to, each asked as if it were alone, by `low`, then by id. Throws likewise.
  std::vector<BodyCast> cast_all(const Shape& shape, const RigidMotion& motion,
                                 const RigidContactSettings& contact = {},
                                 const BodyQuerySettings& settings = {}) const;

  /// A copy of all there is, and the world as it was. Throws InputError while changes wait for an
  /// update. From a restored world on, all is as it was from there the first time, bit for bit.
  WorldSnapshot snapshot() const;
  void restore(const WorldSnapshot& snapshot);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graze
