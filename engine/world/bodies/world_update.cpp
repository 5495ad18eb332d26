// Updates a world: finds which pairs are candidates now, and has those tested in which something
// changed.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/shapes/shape_work.h>
#include <graze/narrowphase/volumes/aabb_overlap.h>

#include <algorithm>
#include <exception>
#include <iterator>

namespace graze {

bool lets_pass(const Filter& a, const Filter& b) {
  if (a.group != 0 && a.group == b.group) return a.group > 0;
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

namespace {

/// True if bodies of these roles and kinds can form a pair at all.
bool can_meet(const Bodies::Body& s, const Bodies::Body& t) {
  if (s.role == Role::Sensor && t.role == Role::Sensor) return false;
  if (s.role == Role::Sensor) return t.kind != BodyKind::Static;
  if (t.role == Role::Sensor) return s.kind != BodyKind::Static;
  return s.kind == BodyKind::Dynamic || t.kind == BodyKind::Dynamic;
}

/// Marks the time of an update, and notes if it ends by an exception. The pairs that it has found
/// begun and ended then stay listed.
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

}  // namespace

bool Bodies::may_meet(std::uint32_t a, std::uint32_t b) const {
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
  const BodyPair pair = all.id_pair(candidates.list()[at]);
  if (candidates.is_near(at)) make_room_in(news.ended_near, 1);  // or a pair could end twice
  if (candidates.touches(at)) news.ended.push_back(pair);
  if (candidates.is_near(at)) news.ended_near.push_back(pair);
  candidates.remove(at);
}

void World::State::end_pairs() {
  for (const BoxPair& boxes : broad.ended()) {
    const std::uint32_t at =
        candidates.position(ordered_pair(body_of_box[boxes.a], body_of_box[boxes.b]));
    if (at != CandidatePairs::kNowhere) end(at);
  }
}

/// Ends pairs whose boxes have parted, after an update that was cut short, when the broad phase's
/// lists may be lost: it tests for every candidate whether its boxes still overlap. filter_again()
/// finds the pairs that began.
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
    if (all.may_meet(pair.a, pair.b)) {
      candidates.add(pair);
    } else {
      ++news.work.pairs_filtered;
      if (all.pair_filter) journal.tell(PairChange::Refused, pair.a, pair.b);
    }
  }
}

/// Lists the bodies whose boxes overlap that of a body, ascending, without the body itself.
void World::State::list_partners(std::uint32_t index) {
  partners.clear();
  const std::uint32_t box = all.bodies[index].box;
  broad.find_overlapping(broad.box(broad.id(box)), partners);
  std::erase(partners, box);
  for (std::uint32_t& partner : partners)
    partner = body_of_box[partner];
  std::sort(partners.begin(), partners.end());
}

/// Adds and ends pairs of a body whose filter changed. If the filters of both bodies changed, the
/// one with the smaller index adds the pair, so that it is added once.
void World::State::filter_again(std::uint32_t index) {
  list_partners(index);
  for (const std::uint32_t partner : partners) {
    if (all.changes[partner].has_other_filter && partner < index) continue;
    const BoxPair pair = ordered_pair(index, partner);
    const std::uint32_t at = candidates.position(pair);
    const bool may_meet = all.may_meet(index, partner);
    if (may_meet && at == CandidatePairs::kNowhere) candidates.add(pair);
    if (!may_meet && at != CandidatePairs::kNowhere) end(at);
    news.work.pairs_filtered += !may_meet;
    if (!may_meet && all.pair_filter) journal.tell(PairChange::Refused, pair.a, pair.b);
  }
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
  note_island_changes();
  for (const std::uint32_t index : changed) {
    Bodies::Changes& record = all.changes[index];
    record.has_changed = record.has_other_filter = record.has_other_shape = false;
    look_for_tree(index);
  }
  changed.clear();
  removed = 0;
}

void World::State::sort_news() {
  for (std::vector<BodyPair>* list :
       {&news.begun, &news.ended, &news.begun_near, &news.ended_near, &news.moved}) {
    if (!std::is_sorted(list->begin(), list->end())) std::sort(list->begin(), list->end());
  }
  if (is_cut_short) {
    cancel_common(news.begun, news.ended);
    cancel_common(news.begun_near, news.ended_near);
  }
  sort_contacts();
  WorldWork& work = news.work;
  work.pairs_at_rest =
      candidates.list().size() - work.shape_tests - work.pairs_apart - work.pairs_asleep;
  work.trees_unbuilt = unbuilt.count();
}

// Public functions do their work in in_standard_arithmetic(), which makes the CPU round as all
// error bounds assume while it calls the function that it is given.

// Filters and shapes of a user's own may throw, and memory may be short. The next update, which
// looks at everything anew, then lists the pairs that had begun and ended until then.
WorldUpdate World::update() {
  return bvh::in_standard_arithmetic([&]() -> WorldUpdate {
    State& state = *state_;
    state.check_is_free("update");
    if (state.is_cut_short) {
      state.note_everything();
      state.news.clear_all_but_changes();
    } else {
      state.news.clear();
    }
    {
      const ShapeWorkScope counting(state.news.work.shapes);
      const UpdatingScope updating(state.is_updating, state.is_cut_short);
      state.find_changes();
      state.find_first_contacts();
      state.sort_news();
      state.all.ids.prepare_round();  // after keep_up_islands() nothing may throw
      state.keep_up_islands();
      state.all.ids.next_round();
    }
    const bool follows_failure = std::exchange(state.is_cut_short, false);
    state.movers.clear();
    const PairNews& news = state.news;
    const WorldUpdate update{news.begun, news.ended,      news.moved,      state.contacts.all(),
                             news.work,  news.begun_near, news.ended_near, news.first_contacts};
    if (state.journal.is_taken()) [[unlikely]]
      state.journal.journal()->note_update(update, follows_failure);
    return update;
  });
}

WorldSnapshot World::snapshot() const {
  const State& state = *state_;
  state.check_is_updated("snapshot");
  const auto candidates = state.candidates.list();
  const auto states = state.candidates.all_states();
  return WorldSnapshot(std::make_shared<WorldSnapshot::State>(WorldSnapshot::State{
      state.all, {candidates.begin(), candidates.end()}, {states.begin(), states.end()}}));
}

void World::restore(const WorldSnapshot& snapshot) {
  bvh::in_standard_arithmetic([&] {
    state_->check_is_free("restore");
    auto fresh = std::make_unique<State>(state_->settings);
    fresh->all = snapshot.state_->all;
    for (std::uint32_t index = 0; index < fresh->all.bodies.size(); ++index) {
      if (!fresh->all.ids.is_live(index)) continue;
      const Bodies::Body& body = fresh->all.bodies[index];
      const Aabb box = body.ask([&](const BodyShape& shape) { return shape.bounds(body.pose); });
      fresh->insert_box(index, body.room() > 0 ? grown(box, body.room()) : box);
      fresh->all.changes[index].has_unbuilt_tree = fresh->unbuilt.add(body.mesh);
      if (body.detection == Detection::Continuous) fresh->movers.add_swept();
    }
    fresh->broad.update();
    fresh->candidates.rebuild(snapshot.state_->candidates, snapshot.state_->states);
    fresh->rebuild_islands();
    fresh->journal = std::move(state_->journal);
    state_ = std::move(fresh);
    if (state_->journal.is_taken())
      state_->journal.journal()->note_restored({state_->settings, state_->all,
                                                state_->candidates.list(),
                                                state_->candidates.all_states()});
  });
}

/// True if bodies have been added and nothing else has happened, so that they may count as added
/// now.
bool WorldJournalAccess::has_only_come(const World::State& state) {
  const auto& all = state.all;
  bool is_first_of_all = true;
  for (std::uint32_t index = 0; index < all.ids.live_count(); ++index)
    is_first_of_all = is_first_of_all && all.ids.is_live(index) && all.ids.generation(index) == 1 &&
                      all.changes[index].has_changed && state.movers.find(index) == nullptr;
  return is_first_of_all && state.removed == 0 && !state.is_cut_short &&
         state.candidates.list().empty();
}

void WorldJournalAccess::attach(World& world, std::shared_ptr<WorldJournal> journal) {
  World::State& state = *world.state_;
  state.check_is_free("record");
  if (!has_only_come(state)) state.check_is_updated("record");
  if (state.journal.is_taken() && state.journal.journal()->is_open())
    throw InputError("record: the world is being recorded already");
  state.journal.take(std::move(journal));
}

WorldContents WorldJournalAccess::contents(const World& world) {
  const World::State& state = *world.state_;
  return {state.settings, state.all, state.candidates.list(), state.candidates.all_states(),
          state.is_updated()};
}

}  // namespace graze
