#pragma once

#include <graze/bvh/box_set/search/pair_index.h>
#include <graze/engine/world/bodies/body_motion.h>
#include <graze/engine/world/bodies/unbuilt_trees.h>
#include <graze/engine/world/bodies/users_shape.h>
#include <graze/engine/world/boxes/id_table.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/world.h>

#include <algorithm>
#include <set>

namespace graze {

/// Memory for so many more elements: to append them throws nothing.
template <typename T>
void make_room_in(std::vector<T>& of, std::size_t more) {
  if (of.capacity() - of.size() < more) of.reserve(std::max(2 * of.size(), of.size() + more));
}

/// The part of a world that a snapshot copies.
struct Bodies {
  struct Body {
    std::shared_ptr<const BodyShape> shape;
    const Mesh* mesh = nullptr;  ///< the mesh that the shape stands for, if it is one
    Pose pose;
    Filter filter;
    std::uint64_t user_data = 0;
    std::uint32_t box = 0;  ///< its index in the broad phase
    std::uint32_t exclusions = 0;
    BodyKind kind = BodyKind::Dynamic;
    Role role = Role::Solid;
    bool is_awake = true;
    bool is_users = false;  ///< whether a user wrote the shape's class
    /// What `question(shape)` says, computed as its author does.
    template <typename Question>
    auto ask(const Question& question) const {
      return ask_shape(is_users, [&] { return question(*shape); });
    }
    bool is_static() const { return kind == BodyKind::Static && role == Role::Solid; }
  };

  /// What a walk over all pairs reads of each body. It is kept apart from the rest, so that it
  /// stays in the cache.
  struct Changes {
    /// Metres: since the body was added no point of it has travelled farther.
    double path = 0;
    /// Whether since the last update it was added, moved, woken or given another filter.
    bool has_changed = false;
    bool has_other_filter = false;  ///< whether its filter, kind or exclusions changed
    bool has_other_shape = false;   ///< whether known gaps of its pairs no longer hold
    bool has_unbuilt_tree = false;  ///< the mark that UnbuiltTrees speaks of
  };

  IdTable<std::uint32_t> ids;
  std::vector<Body> bodies;          ///< by index
  std::vector<Changes> changes;      ///< by index
  std::set<std::uint64_t> excluded;  ///< pairs in both orders, one index in the high half
  std::function<bool(BodyId, BodyId)> pair_filter;

  /// The id of a body that is there, or was until the last update.
  BodyId id(std::uint32_t index) const {
    const std::uint32_t generation = ids.generation(index);
    return {index, ids.is_live(index) ? generation : generation - 1};
  }
  BodyPair id_pair(BoxPair pair) const { return {id(pair.a), id(pair.b)}; }
  bool meet(std::uint32_t a, std::uint32_t b) const;
  /// Whether it is awake and changed or can move. A pair of which a body changed is looked at if
  /// this is true of one of the two.
  bool is_up(std::uint32_t index) const {
    return bodies[index].is_awake && (changes[index].has_changed || !bodies[index].is_static());
  }
  bool are_solid(std::uint32_t a, std::uint32_t b) const {
    return bodies[a].role == Role::Solid && bodies[b].role == Role::Solid;
  }
};

/// The pairs of bodies whose boxes overlap and which no filter keeps apart, and which of them
/// touch.
class CandidatePairs {
 public:
  /// What throws has changed nothing.
  void add(BoxPair pair) {
    make_room_in(touches_, 1), make_room_in(known_gaps_, 1);
    index_.add(list_, pair);
    touches_.push_back(0);
    known_gaps_.emplace_back();
  }
  void remove(std::uint32_t at) {
    index_.remove(list_, list_.data()[at]);
    touches_[at] = touches_.back();
    touches_.pop_back();
    known_gaps_[at] = known_gaps_.back();
    known_gaps_.pop_back();
  }
  std::uint32_t position(BoxPair pair) const { return index_.position(list_, pair); }
  /// What position() reads first, and what is known of the pair there.
  void fetch(BoxPair pair) const { index_.prefetch(pair); }
  void fetch(std::uint32_t at) const {
    __builtin_prefetch(&touches_[at]);
    __builtin_prefetch(&known_gaps_[at]);
  }
  static constexpr std::uint32_t kNowhere = bvh::PairIndex::kNowhere;

  std::span<const BoxPair> list() const { return list_.pairs(); }
  bool touches(std::uint32_t at) const { return touches_[at] != 0; }
  void set_touches(std::uint32_t at, bool does) { touches_[at] = does; }
  KnownGap& known_gap(std::uint32_t at) { return known_gaps_[at]; }
  void rebuild(std::span<const BoxPair> pairs, std::span<const std::uint8_t> touches) {
    list_.clear();
    for (const BoxPair& pair : pairs)
      list_.push_back(pair);
    touches_.assign(touches.begin(), touches.end());
    known_gaps_.assign(pairs.size(), {});
    index_.build(list_);
  }
  std::span<const std::uint8_t> all_touches() const { return touches_; }

 private:
  bvh::PairBuffer list_;
  bvh::PairIndex index_;
  std::vector<std::uint8_t> touches_;
  std::vector<KnownGap> known_gaps_;

 public:
  CandidatePairs() { index_.build(list_); }
};

struct WorldSnapshot::State {
  Bodies all;
  std::vector<BoxPair> candidates;
  std::vector<std::uint8_t> touches;
};

/// Contacts of pairs, kept from update to update and written over: of a manifold only the contacts
/// that there are, mostly one or two of four.
class ContactList {
 public:
  void clear() {
    count_ = 0;
    is_ascending_ = true;
  }
  void add(const BodyPair& pair, const Manifold& manifold) {
    if (count_ == list_.size()) list_.emplace_back();
    if (count_ != 0 && !(last_ < pair)) is_ascending_ = false;
    last_ = pair;
    BodyContact& contact = list_[count_++];
    contact.pair = pair;
    contact.manifold.count = manifold.count;
    std::copy(manifold.begin(), manifold.end(), contact.manifold.contacts.begin());
    if (count_ < list_.size()) fetch(list_[count_]);
  }
  void add(const BodyContact& contact) { add(contact.pair, contact.manifold); }
  std::span<const BodyContact> all() const { return {list_.data(), count_}; }
  bool is_ascending() const { return is_ascending_; }

 private:
  /// Fetches the memory that the next manifold is written to, if it has one contact.
  static void fetch(const BodyContact& next) {
    __builtin_prefetch(&next, 1);
    __builtin_prefetch(&next.manifold.contacts[0].feature, 1);
    __builtin_prefetch(&next.manifold.count, 1);
  }

  std::vector<BodyContact> list_;
  std::size_t count_ = 0;
  BodyPair last_;
  bool is_ascending_ = true;
};

struct World::State {
  explicit State(const WorldSettings& chosen)
      : settings(chosen), broad({.threads = chosen.threads}) {}

  WorldSettings settings;
  Bodies all;
  BroadPhase broad;
  std::vector<std::uint32_t> body_of_box;
  CandidatePairs candidates;
  UnbuiltTrees unbuilt;
  std::vector<std::uint32_t> changed;  ///< indices of bodies
  std::size_t removed = 0;             ///< how many bodies were removed since the last update
  std::vector<std::uint32_t> partners;
  std::vector<BoxPair> asked;  ///< changed bodies and their partners: as boxes, and then as bodies
  std::vector<BodyPair> begun, ended, moved;
  ContactList found;                      ///< in the order in which pairs were tested
  std::vector<std::uint32_t> due;         ///< pairs to be tested, in the order of the list
  std::vector<std::uint32_t> order;       ///< an order of `due`, or of `found`
  std::vector<std::uint32_t> first_pair;  ///< of each body, its first place in `order`
  ContactList contacts;                   ///< `found` in ascending order of pairs
  std::vector<BodyId> box_hits;
  std::vector<BoxId> boxes_to_move;
  std::vector<Aabb> places;
  std::vector<double> bounding_radii;
  WorldWork work;

  bool is_updating = false;
  /// The last update did not end: something that it asked threw, or it had no memory.
  bool is_cut_short = false;

  const Bodies::Body& body(BodyId id, const char* what) const;
  Bodies::Body& body(BodyId id, const char* what) {
    check_is_free(what);
    return const_cast<Bodies::Body&>(static_cast<const State&>(*this).body(id, what));
  }
  /// Throws if a filter or a shape that an update asks tries to change the world.
  void check_is_free(const char* what) const;
  void make_room_for_changes(std::size_t more);
  void note_change(std::uint32_t index);
  void note_other_filter(std::uint32_t index);
  void note_everything();
  std::uint32_t make_room_for_one();
  void insert_box(std::uint32_t index, const Aabb& box);
  void begin_move();
  void prepare_move(BodyId id, const Pose& pose, const char* what);
  void move_prepared(std::span<const BodyId> ids, std::span<const Pose> poses);
  const Mesh* prepared_mesh(const BodyShape& shape, bool is_users) const;
  void take_shape(std::uint32_t index, std::shared_ptr<const BodyShape> shape, const Mesh* mesh);
  void drop_shape(std::uint32_t index);
  void look_for_tree(std::uint32_t index);

  void find_changes();
  void list_changes();
  void end_pairs();
  void end_parted_pairs();
  void begin_pairs();
  void filter_again(std::uint32_t index);
  void test_changed();
  void list_changed_pairs();
  void fetch(BoxPair pair) const;
  void test_partners();
  bool is_due(BoxPair pair) const;
  void test_candidate(std::uint32_t at);
  void test_pairs_at_rest();
  void note_answer(std::uint32_t at, bool touches);
  bool is_apart_for_sure(std::uint32_t at);
  void learn_gap(std::uint32_t at);
  void list_partners(std::uint32_t index);
  void end(std::uint32_t at);
  bool is_asked_for(std::uint32_t index, const BodyQuerySettings& query) const;
  bool asks_for_any(const BodyQuerySettings& query) const;
  std::vector<std::uint32_t> find_bodies(const Aabb& box, const BodyQuerySettings& query) const;
  BodyDistance distance_to(std::uint32_t index, const Shape& shape, const Pose& pose) const;
  template <typename OnHit>
  void for_each_hit(const Ray& ray, const BodyQuerySettings& query, OnHit&& on_hit) const;
  void check_is_updated(const char* what) const;
  BodyContact contact_of(const BodyPair& pair) const;
  bool test(BoxPair pair);
  void sort_contacts();
};

}  // namespace graze
