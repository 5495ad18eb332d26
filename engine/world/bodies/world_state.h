#pragma once

#include <graze/bvh/box_set/search/pair_index.h>
#include <graze/bvh/box_set/store/workers.h>
#include <graze/engine/world/bodies/body_motion.h>
#include <graze/engine/world/bodies/islands.h>
#include <graze/engine/world/bodies/movers.h>
#include <graze/engine/world/bodies/pair_batches.h>
#include <graze/engine/world/bodies/pair_news.h>
#include <graze/engine/world/bodies/unbuilt_trees.h>
#include <graze/engine/world/bodies/world_journal.h>
#include <graze/engine/world/body_shapes/part_pairs.h>
#include <graze/engine/world/body_shapes/users_shape.h>
#include <graze/engine/world/boxes/id_table.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/contacts/margin/nearness.h>
#include <graze/engine/world/shapes/grown_box.h>
#include <graze/engine/world/world.h>

#include <algorithm>
#include <exception>
#include <set>

namespace graze {

/// The part of a world that a snapshot copies.
struct Bodies {
  struct Body {
    std::shared_ptr<const BodyShape> shape;
    const Mesh* mesh = nullptr;  ///< the mesh that the shape stands for, if it is one
    Pose pose;
    Filter filter;
    std::uint64_t user_data = 0;
    double margin = 0;
    MeshSides sides;
    std::uint32_t box = 0;  ///< the index of its box in the broad phase
    std::uint32_t exclusions = 0;
    BodyKind kind = BodyKind::Dynamic;
    Role role = Role::Solid;
    Detection detection = Detection::Discrete;
    bool is_awake = true;
    bool is_users = false;   ///< whether a user wrote the shape's class
    bool has_parts = false;  ///< whether the shape has parts (PartsBody)
    /// Returns `question(shape)`, computed in the floating-point settings of the shape's author.
    template <typename Question>
    auto ask(const Question& question) const {
      return ask_shape(is_users, [&] { return question(*shape); });
    }
    /// Returns how far from its shape the body may meet another, metres.
    double room() const { return margin + sides.thickness(); }
    bool is_static() const { return kind == BodyKind::Static && role == Role::Solid; }
    bool joins_islands() const { return kind == BodyKind::Dynamic && role == Role::Solid; }
  };

  /// The data of a body that a walk over all pairs reads. They are kept apart from the rest, so
  /// that they stay in the cache.
  struct Changes {
    /// No point of the body has travelled farther than this since it was added, metres.
    double path = 0;
    /// True if it was added, moved, woken or given another filter since the last update.
    bool has_changed = false;
    bool has_other_filter = false;  ///< whether its filter, kind or exclusions changed
    bool has_other_shape = false;   ///< whether known gaps of its pairs no longer hold
    bool has_unbuilt_tree = false;  ///< the mark of a body that UnbuiltTrees counts
    bool is_mesh = false;           ///< whether the shape stands for a mesh
    bool is_for_caller = false;     ///< whether only the caller's thread may ask the shape
  };

  IdTable<std::uint32_t> ids;
  std::vector<Body> bodies;          ///< by index
  std::vector<Changes> changes;      ///< by index
  std::set<std::uint64_t> excluded;  ///< pairs in both orders, one index in the high half
  std::function<bool(BodyId, BodyId)> pair_filter;
  std::uint32_t number_bits = 0;  ///< the world's number, as generations in ids have it
  static constexpr int kNumberShift = 24;

  /// True if the id is of a body of this world that has not been removed.
  bool has(BodyId id) const { return ids.is_live(id.index, id.generation ^ number_bits); }
  /// Returns the id of a body that is there, or was there until the last update.
  BodyId id(std::uint32_t index) const {
    const std::uint32_t generation = ids.generation(index);
    return {index, (ids.is_live(index) ? generation : generation - 1) | number_bits};
  }
  BodyPair id_pair(BoxPair pair) const { return {id(pair.a), id(pair.b)}; }
  /// True if kinds, roles and filters let the two form a pair.
  bool may_meet(std::uint32_t a, std::uint32_t b) const;
  /// True if the body is awake, and has changed or is not static. A pair in which a body has
  /// changed is tested if this is true for one of the two.
  bool is_up(std::uint32_t index) const {
    return bodies[index].is_awake && (changes[index].has_changed || !bodies[index].is_static());
  }
  double margin(BoxPair pair) const { return bodies[pair.a].margin + bodies[pair.b].margin; }
  ManifoldSettings settings(BoxPair pair) const {
    return {margin(pair), bodies[pair.a].sides, bodies[pair.b].sides};
  }
  bool has_parts(BoxPair pair) const {
    return bodies[pair.a].has_parts || bodies[pair.b].has_parts;
  }
  bool are_solid(std::uint32_t a, std::uint32_t b) const {
    return bodies[a].role == Role::Solid && bodies[b].role == Role::Solid;
  }
};

/// The states of a pair that a list may ask for, as bits.
enum class PairState : std::uint8_t { Touching = 1, Near = 2, Either = 3 };

/// The pairs of bodies whose boxes overlap and which no filter keeps apart, and which of them
/// touch.
class CandidatePairs {
 public:
  /// Adds a pair. If this throws it has changed nothing.
  void add(BoxPair pair) {
    make_room_in(states_, 1), make_room_in(known_gaps_, 1);
    index_.add(list_, pair);
    states_.push_back(0);
    known_gaps_.emplace_back();
  }
  void remove(std::uint32_t at) {
    index_.remove(list_, list_.data()[at]);
    states_[at] = states_.back();
    states_.pop_back();
    known_gaps_[at] = known_gaps_.back();
    known_gaps_.pop_back();
  }
  std::uint32_t position(BoxPair pair) const { return index_.position(list_, pair); }
  /// Prefetch what position() reads first, and what is known of the pair there.
  void prefetch(BoxPair pair) const { index_.prefetch(pair); }
  void prefetch(std::uint32_t at) const {
    __builtin_prefetch(&states_[at]);
    __builtin_prefetch(&known_gaps_[at]);
  }
  static constexpr std::uint32_t kNowhere = bvh::PairIndex::kNowhere;

  std::span<const BoxPair> list() const { return list_.pairs(); }
  bool touches(std::uint32_t at) const { return (states_[at] & kTouches) != 0; }
  /// True if the pair was within a margin above 0, touching or not.
  bool is_near(std::uint32_t at) const { return (states_[at] & kIsNear) != 0; }
  bool is(std::uint32_t at, PairState state) const {
    return (states_[at] & static_cast<std::uint8_t>(state)) != 0;
  }
  void set(std::uint32_t at, bool touches, bool is_near) {
    states_[at] = static_cast<std::uint8_t>((touches ? kTouches : 0) | (is_near ? kIsNear : 0));
  }
  KnownGap& known_gap(std::uint32_t at) { return known_gaps_[at]; }
  const KnownGap& known_gap(std::uint32_t at) const { return known_gaps_[at]; }
  void rebuild(std::span<const BoxPair> pairs, std::span<const std::uint8_t> states) {
    list_.clear();
    for (const BoxPair& pair : pairs)
      list_.push_back(pair);
    states_.assign(states.begin(), states.end());
    known_gaps_.assign(pairs.size(), {});
    index_.build(list_);
  }
  std::span<const std::uint8_t> all_states() const { return states_; }

 private:
  static constexpr auto kTouches = static_cast<std::uint8_t>(PairState::Touching);
  static constexpr auto kIsNear = static_cast<std::uint8_t>(PairState::Near);

  bvh::PairBuffer list_;
  bvh::PairIndex index_;
  std::vector<std::uint8_t> states_;
  std::vector<KnownGap> known_gaps_;

 public:
  CandidatePairs() { index_.build(list_); }
};

struct WorldSnapshot::State {
  Bodies all;
  std::vector<BoxPair> candidates;
  std::vector<std::uint8_t> states;
};

/// Gives access to the contents of a snapshot, for code that stores them elsewhere.
struct WorldSnapshotAccess {
  using State = WorldSnapshot::State;
  static const State& state(const WorldSnapshot& snapshot) { return *snapshot.state_; }
  static WorldSnapshot make(std::shared_ptr<const State> state) {
    return WorldSnapshot(std::move(state));
  }
};

/// Returns the box of the shape with room around it, metres. Throws if the box is not valid.
Aabb bounds_of(const BodyShape& shape, bool is_users, const Pose& pose, double room,
               const char* what);

inline PairAnswer::Kind kind_of(Nearness nearness) {
  using enum PairAnswer::Kind;
  if (nearness == Nearness::Apart) return Apart;
  return nearness == Nearness::Near ? Near : Touching;
}

inline BoxPair ordered_pair(std::uint32_t s, std::uint32_t t) {
  return {std::min(s, t), std::max(s, t)};
}

/// The reason why a pair is tested: either something in it changed, or nothing did, and the
/// settings ask for a test all the same.
enum class PairQuestion { Changed, AtRest };

/// The search for the pairs of some changed bodies, and the memory that it needs.
struct PartnerSearch {
  std::vector<std::uint32_t> partners;
  std::vector<BoxPair> asked;  ///< changed bodies and partners, first as boxes, then as bodies
  std::vector<std::uint32_t> found;
  std::vector<std::uint32_t> due;  ///< the found pairs that are not surely apart
};

struct CastQuery;      // the question of cast()
struct CastCandidate;  // a body that a cast may come to
struct PosedBox;       // the box and the pose that find_closest() is asked about

/// A body and a box around all places where it was since the last update.
struct SweptBody {
  std::uint32_t body;
  bool is_swept;  ///< false for a body that only moved far, and is listed so that others find it
  Aabb box;
};

/// The answer about the first contact of a pair, which is empty if the pair is free.
struct SweptAnswer {
  std::optional<BodyFirstContact> first, after_sliding;
  std::vector<BodyFirstContact> of_parts;  ///< those of parts, if one body is a compound
};

/// The work of a part of the pairs that are asked for a first contact.
struct SweptPart {
  Work work;
  std::exception_ptr failure;
};

/// Counts the pairs of a part of the list that are due, and those that a known gap keeps from it.
struct DuePart {
  std::uint32_t due, apart;
};

struct World::State {
  explicit State(const WorldSettings& chosen);

  WorldSettings settings;
  std::size_t threads;
  bvh::Workers workers;
  Bodies all;
  BroadPhase broad;
  std::vector<std::uint32_t> body_of_box;
  CandidatePairs candidates;
  UnbuiltTrees unbuilt;
  std::vector<std::uint32_t> changed;  ///< indices of bodies
  std::size_t removed = 0;             ///< how many bodies were removed since the last update
  std::vector<std::uint32_t> partners;
  PairNews news;
  std::vector<PartnerSearch> searches;
  std::vector<std::uint32_t> due;         ///< pairs to be tested, in the order of the list
  std::vector<DuePart> due_parts;         ///< for each part of the list of candidates
  std::vector<std::uint32_t> order;       ///< `due`, or contacts, put in order
  std::vector<std::uint32_t> first_pair;  ///< the first place of each body in `order`
  PairBatches batches;                    ///< the pairs in `order`, if threads share them
  ContactList contacts;                   ///< the contacts of `news` in ascending order of pairs
  std::vector<BodyId> box_hits;
  std::vector<BoxId> boxes_to_move;
  std::vector<Aabb> moved_boxes;
  std::vector<double> bounding_radii;
  Islands islands;
  std::vector<std::uint32_t> island_changes;  ///< bodies that are to join islands or to leave them
  std::vector<std::uint32_t> left_islands;    ///< bodies that were removed since the last update
  std::vector<BoxPair> island_edges;          ///< edges that are to be added
  Movers movers;
  std::vector<SweptBody> swept;
  std::vector<BoxPair> swept_pairs;
  std::vector<SweptPart> swept_parts;
  std::vector<SweptAnswer> swept_answers;  ///< in the order of `swept_pairs`

  JournalPlace journal;

  bool is_updating = false;
  /// True if the last update was not completed: something that it asked threw, or memory was short.
  bool is_cut_short = false;

  const Bodies::Body& body(BodyId id, const char* what) const;
  Bodies::Body& body(BodyId id, const char* what) {
    check_is_free(what);
    return const_cast<Bodies::Body&>(static_cast<const State&>(*this).body(id, what));
  }
  /// Throws if a filter or a shape that an update asks tries to change the world.
  void check_is_free(const char* what) const;
  void check_bodies(std::span<const BodyId> ids, const char* what) const;
  void make_room_for_changes(std::size_t more);
  void note_change(std::uint32_t index);
  void note_other_filter(std::uint32_t index);
  void note_everything();
  std::uint32_t make_room_for_one();
  void insert_box(std::uint32_t index, const Aabb& box);
  void begin_move();
  void prepare_move(BodyId id, const Pose& pose, const char* what);
  void move_prepared(std::span<const BodyId> ids, std::span<const Pose> poses);
  void note_travel(std::uint32_t index, const Pose& to, double bounding_radius);
  const Mesh* prepared_mesh(const BodyShape& shape, bool is_users) const;
  void take_shape(std::uint32_t index, std::shared_ptr<const BodyShape> shape, const Mesh* mesh);
  void drop_shape(std::uint32_t index);
  /// Removes the mark of a body if the tree of its mesh has been built. To be called after a query
  /// that may have built it.
  void look_for_tree(std::uint32_t index) {
    bool& is_marked = all.changes[index].has_unbuilt_tree;
    if (is_marked) is_marked = unbuilt.still_holds(*all.bodies[index].mesh);
  }

  void find_changes();
  void find_first_contacts();
  double list_swept();
  void list_swept_pairs(double others_travel);
  void list_partners_of(std::uint32_t index, const Aabb& box, double others_travel);
  SweptAnswer ask_swept_pair(BoxPair pair) const;
  void ask_swept_pairs();
  /// Sorts what an update found, takes out what cancels, and counts what it did not ask.
  void sort_news();
  void end_pairs();
  void end_parted_pairs();
  void begin_pairs();
  void filter_again(std::uint32_t index);
  void test_changed();
  void list_due_pairs();
  void list_due_part(std::size_t part);
  void list_due_partners();
  void search_partners(std::span<const std::uint32_t> bodies, PartnerSearch& search);
  void prefetch(BoxPair pair) const;
  void prefetch_ahead(std::size_t i, std::size_t ahead) const;
  bool has_changed_body(BoxPair pair) const;
  bool is_anyone_up(BoxPair pair) const { return all.is_up(pair.a) || all.is_up(pair.b); }
  bool is_apart_for_sure(std::uint32_t at);
  void test_pairs_at_rest();
  void test_in_order(PairQuestion question, std::size_t ahead);
  bool are_worth_sharing();
  void test_in_batches(PairQuestion question);
  void note_answers_of_batches(PairQuestion question);
  void note_answers_in_turn(PairQuestion question);
  PairAnswer answer_of(std::uint32_t at, PairQuestion question, ContactList& into) const;
  void tell(std::uint32_t at, PairQuestion question, const PairAnswer& answer, PairNews& to) const;
  void note_answer(std::uint32_t at, PairQuestion question, const PairAnswer& answer);
  bool learn_gap(BoxPair pair, KnownGap& known) const;
  void list_partners(std::uint32_t index);
  void end(std::uint32_t at);
  bool is_asked_for(std::uint32_t index, const BodyQuerySettings& query) const;
  bool asks_for_any(const BodyQuerySettings& query) const;
  std::vector<std::uint32_t> find_bodies(const Aabb& box, const BodyQuerySettings& query) const;
  std::optional<BodyDistance> distance_to(std::uint32_t index, const PlacedShapeView& placed,
                                          const BodyQuerySettings& query, double most) const;
  template <typename Ask>
  void for_nearest(const PosedBox& own, const BodyQuerySettings& query, double least,
                   const Ask& ask) const;
  PosedBody posed(std::uint32_t index) const;
  std::vector<CastCandidate> find_cast_candidates(const CastQuery& cast) const;
  std::optional<BodyCast> cast_at(const CastCandidate& candidate, const CastQuery& cast) const;
  std::optional<BodyCast> cast_at(std::uint32_t index, const CastQuery& cast) const;
  std::optional<BodyCast> cast_at_parts(std::uint32_t index, const CastQuery& cast) const;
  template <typename OnHit>
  void for_each_hit(const Ray& ray, const BodyQuerySettings& query, OnHit&& on_hit) const;
  bool is_updated() const { return changed.empty() && removed == 0 && !is_cut_short; }
  void check_is_updated(const char* what) const;
  void note_island_changes();
  void list_island_edges();
  void keep_up_islands();
  void rebuild_islands();
  void check_islands(const char* what) const;
  std::vector<BodyId> island_of(std::uint32_t index) const;
  template <typename Visit>
  void for_candidates_of(std::uint32_t index, const Visit& visit) const;
  std::vector<BodyPair> list_pairs(PairState state) const;
  std::vector<BodyPair> list_pairs_of(std::uint32_t index, PairState state) const;
  std::vector<BodyContact> contacts_of(std::span<const BodyPair> pairs) const;
  void add_contacts(const BodyPair& pair, std::vector<BodyContact>& list) const;
  bool do_touch(BoxPair pair) const;
  PairAnswer::Kind relation_of(BoxPair pair) const;
  PairAnswer::Kind meet(BoxPair pair, ContactList& into) const;
  PairAnswer::Kind meet_within(BoxPair pair, const ManifoldSettings& asked,
                               ContactList& into) const;
  template <typename Visit>
  void for_parts_of(BoxPair pair, const Visit& visit) const;
  PairAnswer::Kind relation_of_parts(BoxPair pair) const;
  PairAnswer::Kind meet_by_parts(BoxPair pair, ContactList& into) const;
  void add_contacts_of_parts(const BodyPair& pair, std::vector<BodyContact>& list) const;
  Manifold contacts_within(BoxPair pair, const ManifoldSettings& asked) const;
  void sort_contacts();
};

/// Calls `visit(at)` for the candidates of a body. They must have been found with the box that the
/// body has now.
template <typename Visit>
void World::State::for_candidates_of(std::uint32_t index, const Visit& visit) const {
  const std::uint32_t box = all.bodies[index].box;
  std::vector<std::uint32_t> boxes;
  broad.find_overlapping(broad.box(broad.id(box)), boxes);
  for (const std::uint32_t other : boxes) {
    if (other == box) continue;
    const std::uint32_t at = candidates.position(ordered_pair(index, body_of_box[other]));
    if (at != CandidatePairs::kNowhere) visit(at);
  }
}

}  // namespace graze
