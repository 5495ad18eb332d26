// What an update of a world does: which pairs are candidates now, and which of those in which
// something changed touch.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/shapes/quick_gap.h>
#include <graze/engine/world/shapes/shape_work.h>
#include <graze/narrowphase/volumes/aabb_overlap.h>
#include <hwy/cache_control.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <numeric>

namespace graze {
namespace {

BoxPair ordered_pair(std::uint32_t s, std::uint32_t t) {
  return {std::min(s, t), std::max(s, t)};
}

}  // namespace

bool lets_pass(const Filter& a, const Filter& b) {
  if (a.group != 0 && a.group == b.group) return a.group > 0;
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

namespace {

/// Whether bodies of these roles and kinds can form a pair at all.
bool can_meet(const Bodies::Body& s, const Bodies::Body& t) {
  if (s.role == Role::Sensor && t.role == Role::Sensor) return false;
  if (s.role == Role::Sensor) return t.kind != BodyKind::Static;
  if (t.role == Role::Sensor) return s.kind != BodyKind::Static;
  return s.kind == BodyKind::Dynamic || t.kind == BodyKind::Dynamic;
}

/// Pairs that it finds begun and ended stay listed if it ends by an exception.
class UpdatingScope {
 public:
  UpdatingScope(bool& is_updating, bool& is_cut_short)
      : is_updating_(is_updating),
        is_cut_short_(is_cut_short),
        exceptions_(std::uncaught_exceptions()) {
    is_updating_ = true;
  }
  UpdatingScope(const UpdatingScope&) = delete;
  UpdatingScope& operator=(const UpdatingScope&) = delete;
  ~UpdatingScope() {
    is_updating_ = false;
    if (std::uncaught_exceptions() > exceptions_) is_cut_short_ = true;
  }

 private:
  bool& is_updating_;
  bool& is_cut_short_;
  int exceptions_;
};

/// Removes pairs of equal elements, one from each of two ascending lists: a pair that began, ended
/// and began again while updates were cut short has begun once.
void cancel_common(std::vector<BodyPair>& s, std::vector<BodyPair>& t) {
  std::vector<BodyPair> of_s, of_t;
  std::set_difference(s.begin(), s.end(), t.begin(), t.end(), std::back_inserter(of_s));
  std::set_difference(t.begin(), t.end(), s.begin(), s.end(), std::back_inserter(of_t));
  s = std::move(of_s), t = std::move(of_t);
}

GapCost cost_of_gap(const BodyShape& a, const BodyShape& b) {
  const Shape *s = a.shape(), *t = b.shape();
  const bool is_quick =
      s != nullptr && t != nullptr && is_gap_quick(pair_method(s->kind(), t->kind()));
  return is_quick ? kQuickGap : kMeasuredGap;
}

}  // namespace

bool Bodies::meet(std::uint32_t a, std::uint32_t b) const {
  const Body& s = bodies[a];
  const Body& t = bodies[b];
  if (!can_meet(s, t) || !lets_pass(s.filter, t.filter)) return false;
  if (s.exclusions != 0 && t.exclusions != 0 &&
      excluded.contains(static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b))) {
    return false;
  }
  if (!pair_filter) return true;
  const BodyId first = id(std::min(a, b)), second = id(std::max(a, b));
  return bvh::in_users_arithmetic([&] { return pair_filter(first, second); });
}

void World::State::end(std::uint32_t at) {
  if (candidates.touches(at)) ended.push_back(all.id_pair(candidates.list()[at]));
  candidates.remove(at);
}

void World::State::end_pairs() {
  for (const BoxPair& boxes : broad.ended()) {
    const std::uint32_t at =
        candidates.position(ordered_pair(body_of_box[boxes.a], body_of_box[boxes.b]));
    if (at != CandidatePairs::kNowhere) end(at);
  }
}

/// The same after an update that was cut short, when the broad phase's lists may be lost: asks
/// every candidate whether its boxes still overlap. filter_again() finds the pairs that began.
void World::State::end_parted_pairs() {
  for (auto at = static_cast<std::uint32_t>(candidates.list().size()); at-- > 0;) {
    const BoxPair pair = candidates.list()[at];
    const auto box = [&](std::uint32_t index) {
      return broad.box(broad.id(all.bodies[index].box));
    };
    const bool are_there = all.ids.is_live(pair.a) && all.ids.is_live(pair.b);
    if (!are_there || !intersects(box(pair.a), box(pair.b))) end(at);
  }
}

void World::State::begin_pairs() {
  for (const BoxPair& boxes : broad.begun()) {
    const BoxPair pair = ordered_pair(body_of_box[boxes.a], body_of_box[boxes.b]);
    // Where a filter changed, too, filter_again() adds the pair.
    if (all.changes[pair.a].has_other_filter || all.changes[pair.b].has_other_filter) continue;
    if (all.meet(pair.a, pair.b)) {
      candidates.add(pair);
    } else {
      ++work.pairs_filtered;
    }
  }
}

/// The bodies whose boxes overlap that of a body, ascending, without itself.
void World::State::list_partners(std::uint32_t index) {
  partners.clear();
  const std::uint32_t box = all.bodies[index].box;
  broad.find_overlapping(broad.box(broad.id(box)), partners);
  std::erase(partners, box);
  for (std::uint32_t& partner : partners)
    partner = body_of_box[partner];
  std::sort(partners.begin(), partners.end());
}

/// Of two bodies whose filters changed the one with the smaller index adds the pair: once.
void World::State::filter_again(std::uint32_t index) {
  list_partners(index);
  for (const std::uint32_t partner : partners) {
    if (all.changes[partner].has_other_filter && partner < index) continue;
    const BoxPair pair = ordered_pair(index, partner);
    const std::uint32_t at = candidates.position(pair);
    const bool do_meet = all.meet(index, partner);
    if (do_meet && at == CandidatePairs::kNowhere) candidates.add(pair);
    if (!do_meet && at != CandidatePairs::kNowhere) end(at);
    work.pairs_filtered += !do_meet;
  }
}

/// For few changed bodies: each is tested with its partners, a pair of two changed ones once. What
/// is known of pairs may lie anywhere in memory: each step of the lookup prefetches for the next.
void World::State::test_partners() {
  asked.clear(), due.clear(), order.clear();
  for (const std::uint32_t index : changed) {
    const std::uint32_t box = all.bodies[index].box;
    partners.clear();
    broad.find_overlapping(broad.box(broad.id(box)), partners);
    for (const std::uint32_t partner : partners) {
      if (partner == box) continue;
      asked.push_back({index, partner});
      hwy::Prefetch(&body_of_box[partner]);
    }
  }
  for (BoxPair& each : asked) {
    each.b = body_of_box[each.b];
    hwy::Prefetch(&all.changes[each.b]);
    candidates.fetch(ordered_pair(each.a, each.b));
  }
  for (const BoxPair& each : asked) {
    if (all.changes[each.b].has_changed && each.b < each.a) continue;
    const std::uint32_t at = candidates.position(ordered_pair(each.a, each.b));
    if (at == CandidatePairs::kNowhere) continue;
    due.push_back(at);
    candidates.fetch(at);
  }
  for (const std::uint32_t at : due) {
    if (is_apart_for_sure(at)) continue;
    order.push_back(at);
    fetch(candidates.list()[at]);
  }
  for (const std::uint32_t at : order)
    test_candidate(at);
}

void World::State::test_candidate(std::uint32_t at) {
  const BoxPair pair = candidates.list()[at];
  if (!all.is_up(pair.a) && !all.is_up(pair.b)) {
    ++work.pairs_asleep;
    return;
  }
  ++work.shape_tests;
  const bool touches = test(pair);
  if (touches) moved.push_back(all.id_pair(pair));
  note_answer(at, touches);
  if (touches) {
    candidates.known_gap(at) = {};
  } else {
    learn_gap(at);
  }
  look_for_tree(pair.a), look_for_tree(pair.b);
}

/// Prefetches the bodies of a pair, which may lie anywhere in memory.
void World::State::fetch(BoxPair pair) const {
  for (const std::uint32_t index : {pair.a, pair.b}) {
    const char* body = reinterpret_cast<const char*>(&all.bodies[index]);
    constexpr std::size_t kLine = 64;
    for (std::size_t at = 0; at < sizeof(Bodies::Body); at += kLine)
      hwy::Prefetch(body + at);
  }
}

/// For many changed bodies: goes through all pairs, which costs less than asking for partners.
void World::State::test_changed() {
  constexpr std::size_t kMany = 8;
  if (std::max(candidates.list().size(), all.bodies.size()) > kMany * changed.size()) {
    test_partners();
    return;
  }
  list_changed_pairs();
  for (std::size_t i = 0; i < order.size(); ++i) {
    constexpr std::size_t kAhead = 4;
    if (i + kAhead < order.size()) fetch(candidates.list()[order[i + kAhead]]);
    test_candidate(order[i]);
  }
}

bool World::State::is_due(BoxPair pair) const {
  return all.changes[pair.a].has_changed || all.changes[pair.b].has_changed;
}

/// Lists in `order` the pairs that no known gap keeps apart, ascending by their bodies, so that
/// what is found needs no sorting: a counting sort by the first body, then the few of each by the
/// second.
void World::State::list_changed_pairs() {
  const std::span<const BoxPair> list = candidates.list();
  due.clear();
  first_pair.assign(all.bodies.size() + 1, 0);
  for (std::uint32_t at = 0; at < list.size(); ++at) {
    if (!is_due(list[at]) || is_apart_for_sure(at)) continue;
    due.push_back(at);
    ++first_pair[list[at].a + 1];
  }
  std::partial_sum(first_pair.begin(), first_pair.end(), first_pair.begin());
  order.resize(due.size());
  for (const std::uint32_t at : due)
    order[first_pair[list[at].a]++] = at;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : first_pair) {
    std::sort(order.begin() + begin, order.begin() + std::max(begin, end),
              [&](std::uint32_t s, std::uint32_t t) { return list[s].b < list[t].b; });
    begin = std::max(begin, end);
  }
}

/// Tests the pairs in which nothing moved, without need: WorldSettings::skip_at_rest leaves this
/// out. Pairs of sleepers keep their last answer.
void World::State::test_pairs_at_rest() {
  for (std::uint32_t at = 0; at < candidates.list().size(); ++at) {
    const BoxPair pair = candidates.list()[at];
    const Bodies::Body& a = all.bodies[pair.a];
    const Bodies::Body& b = all.bodies[pair.b];
    if (is_due(pair) || (!all.is_up(pair.a) && !all.is_up(pair.b))) continue;
    ++work.shape_tests;
    note_answer(
        at, a.ask([&](const BodyShape& shape) { return shape.touches(a.pose, *b.shape, b.pose); }));
    look_for_tree(pair.a), look_for_tree(pair.b);
  }
}

/// To be called after what may have built the tree of the body's mesh: takes the mark away if so.
void World::State::look_for_tree(std::uint32_t index) {
  bool& is_marked = all.changes[index].has_unbuilt_tree;
  if (is_marked) is_marked = unbuilt.still_holds(*all.bodies[index].mesh);
}

void World::State::note_answer(std::uint32_t at, bool touches) {
  const BoxPair pair = candidates.list()[at];
  if (touches != candidates.touches(at)) (touches ? begun : ended).push_back(all.id_pair(pair));
  candidates.set_touches(at, touches);
}

bool World::State::is_apart_for_sure(std::uint32_t at) {
  const BoxPair pair = candidates.list()[at];
  const Bodies::Changes &a = all.changes[pair.a], &b = all.changes[pair.b];
  KnownGap& known = candidates.known_gap(at);
  if (a.has_other_shape || b.has_other_shape) known = {};
  if (!known.holds(a.path, b.path)) return false;
  known.note_skip();
  ++work.pairs_apart;
  return true;
}

void World::State::learn_gap(std::uint32_t at) {
  KnownGap& known = candidates.known_gap(at);
  if (!settings.skip_apart) return;
  const BoxPair pair = candidates.list()[at];
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  if (!known.wants_gap(cost_of_gap(*a.shape, *b.shape))) return;
  const double gap =
      a.ask([&](const BodyShape& shape) { return shape.gap(a.pose, *b.shape, b.pose); });
  known.set_gap(gap, all.changes[pair.a].path, all.changes[pair.b].path);
  ++work.gaps_measured;
}

void World::State::find_changes() {
  broad.update();
  is_cut_short ? end_parted_pairs() : end_pairs();
  begin_pairs();
  std::erase_if(changed, [&](std::uint32_t index) {
    const bool is_gone = !all.ids.is_live(index);
    if (is_gone) all.changes[index].has_changed = false;
    return is_gone;
  });
  for (const std::uint32_t index : changed) {
    if (all.changes[index].has_other_filter) filter_again(index);
  }
  test_changed();
  if (!settings.skip_at_rest) test_pairs_at_rest();
  for (const std::uint32_t index : changed) {
    Bodies::Changes& record = all.changes[index];
    record.has_changed = record.has_other_filter = record.has_other_shape = false;
    look_for_tree(index);
  }
  changed.clear();
  removed = 0;
}

void World::State::list_changes() {
  for (std::vector<BodyPair>* list : {&begun, &ended, &moved}) {
    if (!std::is_sorted(list->begin(), list->end())) std::sort(list->begin(), list->end());
  }
  if (is_cut_short) cancel_common(begun, ended);
  sort_contacts();
  work.pairs_at_rest =
      candidates.list().size() - work.shape_tests - work.pairs_apart - work.pairs_asleep;
  work.trees_unbuilt = unbuilt.count();
}

// Filters and shapes of a user's own may throw, and memory may be short. What had begun and ended
// until then is told by the next update, which looks at everything anew.
WorldUpdate World::update() {
  return bvh::in_standard_arithmetic([&]() -> WorldUpdate {
    State& state = *state_;
    state.check_is_free("update");
    if (state.is_cut_short) {
      state.note_everything();
    } else {
      state.begun.clear(), state.ended.clear();
    }
    state.moved.clear(), state.found.clear();
    state.work = {};
    {
      const ShapeWorkScope counting(state.work.shapes);
      const UpdatingScope updating(state.is_updating, state.is_cut_short);
      state.find_changes();
      state.list_changes();
      state.all.ids.next_round();
    }
    state.is_cut_short = false;
    return {state.begun, state.ended, state.moved, state.contacts.all(), state.work};
  });
}

WorldSnapshot World::snapshot() const {
  const State& state = *state_;
  state.check_is_updated("snapshot");
  const auto candidates = state.candidates.list();
  const auto touches = state.candidates.all_touches();
  return WorldSnapshot(std::make_shared<WorldSnapshot::State>(WorldSnapshot::State{
      state.all, {candidates.begin(), candidates.end()}, {touches.begin(), touches.end()}}));
}

void World::restore(const WorldSnapshot& snapshot) {
  bvh::in_standard_arithmetic([&] {
    state_->check_is_free("restore");
    auto fresh = std::make_unique<State>(state_->settings);
    fresh->all = snapshot.state_->all;
    for (std::uint32_t index = 0; index < fresh->all.bodies.size(); ++index) {
      if (!fresh->all.ids.is_live(index)) continue;
      const Bodies::Body& body = fresh->all.bodies[index];
      fresh->insert_box(index,
                        body.ask([&](const BodyShape& shape) { return shape.bounds(body.pose); }));
      fresh->all.changes[index].has_unbuilt_tree = fresh->unbuilt.add(body.mesh);
    }
    fresh->broad.update();
    fresh->candidates.rebuild(snapshot.state_->candidates, snapshot.state_->touches);
    state_ = std::move(fresh);
  });
}

}  // namespace graze
