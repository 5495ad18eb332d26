// Tests the pairs in which something changed. The questions change nothing, so that several threads
// can ask them; the world takes note of the answers in the order of the pairs.

#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/shapes/quick_gap.h>
#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>

namespace graze {
namespace {

/// Bodies are fetched so many pairs ahead of their test.
constexpr std::size_t kAhead = 4;

/// The length of the part of the list of candidates that a thread goes through in one go.
constexpr std::size_t kPartOfList = 8192;

GapCost cost_of_gap(const BodyShape& a, const BodyShape& b) {
  const Shape *s = a.shape(), *t = b.shape();
  const bool is_quick =
      s != nullptr && t != nullptr && is_gap_quick(pair_method(s->kind(), t->kind()));
  return is_quick ? kQuickGap : kMeasuredGap;
}

/// Returns the cost of a test, as PairBatches counts it.
std::uint32_t cost_of_test(const Bodies::Changes& a, const Bodies::Changes& b) {
  constexpr std::uint32_t kOfMeshes = 16, kWithMesh = 4, kOther = 1;
  if (a.is_for_caller || b.is_for_caller) return 0;
  if (a.is_mesh && b.is_mesh) return kOfMeshes;
  return a.is_mesh || b.is_mesh ? kWithMesh : kOther;
}

}  // namespace

/// Tests all pairs of changed bodies. If many have changed it goes through all pairs, which costs
/// less than searching for partners.
void World::State::test_changed() {
  constexpr std::size_t kMany = 8;
  if (std::max(candidates.list().size(), all.bodies.size()) > kMany * changed.size()) {
    list_due_partners();
    test_in_order(PairQuestion::Changed, 0);
  } else {
    list_due_pairs();
    test_in_order(PairQuestion::Changed, kAhead);
  }
}

/// Lists in `order` the pairs of changed bodies that no known gap keeps apart, and fetches their
/// bodies. A pair of two changed ones is listed once.
void World::State::list_due_partners() {
  constexpr std::size_t kPart = 128;
  const std::size_t size = threads > 1 ? kPart : changed.size();
  const std::size_t parts = size == 0 ? 0 : (changed.size() + size - 1) / size;
  if (searches.size() < parts) searches.resize(parts);
  workers.for_each(parts, [&](std::size_t part) {
    const std::size_t first = part * size;
    search_partners(std::span(changed).subspan(first, std::min(size, changed.size() - first)),
                    searches[part]);
  });
  order.clear();
  for (const PartnerSearch& search : std::span(searches).first(parts)) {
    order.insert(order.end(), search.due.begin(), search.due.end());
    news.work.pairs_apart += search.found.size() - search.due.size();
  }
}

/// Searches the pairs of some changed bodies. The data of pairs may lie anywhere in memory: each
/// step of the lookup prefetches for the next.
void World::State::search_partners(std::span<const std::uint32_t> bodies, PartnerSearch& search) {
  search.asked.clear(), search.found.clear(), search.due.clear();
  for (const std::uint32_t index : bodies) {
    const std::uint32_t box = all.bodies[index].box;
    search.partners.clear();
    broad.find_overlapping(broad.box(broad.id(box)), search.partners);
    for (const std::uint32_t partner : search.partners) {
      if (partner == box) continue;
      search.asked.push_back({index, partner});
      hwy::Prefetch(&body_of_box[partner]);
    }
  }
  for (BoxPair& each : search.asked) {
    each.b = body_of_box[each.b];
    hwy::Prefetch(&all.changes[each.b]);
    candidates.prefetch(ordered_pair(each.a, each.b));
  }
  for (const BoxPair& each : search.asked) {
    if (all.changes[each.b].has_changed && each.b < each.a) continue;
    const std::uint32_t at = candidates.position(ordered_pair(each.a, each.b));
    if (at == CandidatePairs::kNowhere) continue;
    search.found.push_back(at);
    candidates.prefetch(at);
  }
  for (const std::uint32_t at : search.found) {
    if (is_apart_for_sure(at)) continue;
    search.due.push_back(at);
    prefetch(candidates.list()[at]);
  }
}

/// Prefetches the bodies of a pair, which may lie anywhere in memory.
void World::State::prefetch(BoxPair pair) const {
  for (const std::uint32_t index : {pair.a, pair.b}) {
    const char* body = reinterpret_cast<const char*>(&all.bodies[index]);
    constexpr std::size_t kLine = 64;
    for (std::size_t at = 0; at < sizeof(Bodies::Body); at += kLine)
      hwy::Prefetch(body + at);
  }
}

bool World::State::has_changed_body(BoxPair pair) const {
  return all.changes[pair.a].has_changed || all.changes[pair.b].has_changed;
}

/// Lists in `order` the pairs that no known gap keeps apart, ascending by their bodies, so that the
/// results need no sorting. It is a counting sort by the first body; then the few pairs of each
/// body are sorted by the second.
void World::State::list_due_pairs() {
  const std::span<const BoxPair> list = candidates.list();
  const std::size_t parts = (list.size() + kPartOfList - 1) / kPartOfList;
  due.resize(list.size());
  due_parts.resize(parts);
  workers.for_each(parts, [&](std::size_t part) { list_due_part(part); });
  const auto for_each_due = [&](const auto& visit) {
    for (std::size_t part = 0; part < parts; ++part) {
      for (std::size_t i = part * kPartOfList; i < part * kPartOfList + due_parts[part].due; ++i)
        visit(due[i]);
    }
  };
  for (const DuePart& part : due_parts)
    news.work.pairs_apart += part.apart;
  first_pair.assign(all.bodies.size() + 1, 0);
  for_each_due([&](std::uint32_t at) { ++first_pair[list[at].a + 1]; });
  std::partial_sum(first_pair.begin(), first_pair.end(), first_pair.begin());
  order.resize(first_pair.back());
  for_each_due([&](std::uint32_t at) { order[first_pair[list[at].a]++] = at; });
  // Now each body's place is where its pairs end.
  constexpr std::size_t kBodies = 2048;
  const std::size_t bodies = all.bodies.size();
  workers.for_each((bodies + kBodies - 1) / kBodies, [&](std::size_t part) {
    std::uint32_t begin = part == 0 ? 0 : first_pair[part * kBodies - 1];
    for (std::size_t body = part * kBodies; body < std::min((part + 1) * kBodies, bodies); ++body) {
      const std::uint32_t end = first_pair[body];
      std::sort(order.begin() + begin, order.begin() + end,
                [&](std::uint32_t s, std::uint32_t t) { return list[s].b < list[t].b; });
      begin = end;
    }
  });
}

/// Lists the due pairs of one part of the list, at the beginning of its part of `due`.
void World::State::list_due_part(std::size_t part) {
  const std::span<const BoxPair> list = candidates.list();
  const std::size_t end = std::min((part + 1) * kPartOfList, list.size());
  std::uint32_t* const begin = due.data() + part * kPartOfList;
  std::uint32_t* next = begin;
  std::uint32_t apart = 0;
  for (std::size_t i = part * kPartOfList; i < end; ++i) {
    const auto at = static_cast<std::uint32_t>(i);
    if (!has_changed_body(list[at])) continue;
    if (is_apart_for_sure(at)) {
      ++apart;
    } else {
      *next++ = at;
    }
  }
  due_parts[part] = {static_cast<std::uint32_t>(next - begin), apart};
}

/// Tests the pairs in which nothing moved, without need: WorldSettings::skip_at_rest leaves this
/// out. Pairs of sleepers keep their last answer.
void World::State::test_pairs_at_rest() {
  const std::span<const BoxPair> list = candidates.list();
  order.clear();
  for (std::uint32_t at = 0; at < list.size(); ++at) {
    if (!has_changed_body(list[at]) && is_anyone_up(list[at])) order.push_back(at);
  }
  test_in_order(PairQuestion::AtRest, kAhead);
}

/// Asks all pairs in `order`, and takes note of the answers.
void World::State::test_in_order(PairQuestion question, std::size_t ahead) {
  if (threads > 1 && are_worth_sharing()) return test_in_batches(question);
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (ahead != 0) prefetch_ahead(i, ahead);
    const PairAnswer answer = answer_of(order[i], question, news.contacts);
    tell(order[i], question, answer, news);
    note_answer(order[i], question, answer);
    const BoxPair pair = candidates.list()[order[i]];
    look_for_tree(pair.a), look_for_tree(pair.b);
  }
}

void World::State::prefetch_ahead(std::size_t i, std::size_t ahead) const {
  if (i + ahead < order.size()) prefetch(candidates.list()[order[i + ahead]]);
}

/// Puts the pairs into batches. True if these take long enough for more than one thread.
bool World::State::are_worth_sharing() {
  batches.clear();
  for (const std::uint32_t at : order) {
    const BoxPair pair = candidates.list()[at];
    batches.add(cost_of_test(all.changes[pair.a], all.changes[pair.b]));
  }
  return batches.are_worth_sharing();
}

/// Asks the pairs in `order` on all threads, and takes note of the answers.
void World::State::test_in_batches(PairQuestion question) {
  batches.ask_all(workers, threads, [&](std::uint32_t i, PairBatch& batch) -> PairAnswer {
    prefetch_ahead(i, kAhead);
    const BoxPair pair = candidates.list()[order[i]];
    const Bodies::Changes &a = all.changes[pair.a], &b = all.changes[pair.b];
    if (a.is_for_caller || b.is_for_caller) return {.kind = PairAnswer::Kind::ForCaller};
    const PairAnswer answer = answer_of(order[i], question, batch.news.contacts);
    tell(order[i], question, answer, batch.news);
    batch.has_mark |= a.has_unbuilt_tree || b.has_unbuilt_tree;
    return answer;
  });
  batches.are_all_answered() ? note_answers_of_batches(question) : note_answers_in_turn(question);
}

/// Takes note of all answers, on all threads, too. Contacts are copied first, which may need
/// memory: if that fails the world has taken note of no answer. After that only oneTBB may fail,
/// and this thread does what that left out.
void World::State::note_answers_of_batches(PairQuestion question) {
  const std::span<PairBatch> list = batches.batches();
  constexpr std::size_t kTogether = 16;
  const std::size_t parts = (list.size() + kTogether - 1) / kTogether;
  const auto part_of_list = [&](std::size_t part) {
    const std::size_t first = part * kTogether;
    return list.subspan(first, std::min(kTogether, list.size() - first));
  };
  batches.make_room_in(news.contacts);
  workers.for_each(parts, [&](std::size_t part) {
    for (const PairBatch& batch : part_of_list(part))
      put_contacts(batch, news.contacts);
  });
  batches.make_room_in(news);
  const auto note = [&](std::size_t part) noexcept {
    for (const PairBatch& batch : part_of_list(part)) {
      put_pairs(batch, news);
      for (std::uint32_t i = batch.first; i < batch.end; ++i)
        note_answer(order[i], question, batches.answer(i));
    }
  };
  try {
    workers.for_each(parts, note);
  } catch (const std::bad_alloc&) {
    for (std::size_t part = 0; part < parts; ++part)
      note(part);
  }
  for (const PairBatch& batch : list) {
    news.work.shape_tests += batch.news.work.shape_tests;
    news.work.pairs_asleep += batch.news.work.pairs_asleep;
    news.work.gaps_measured += batch.news.work.gaps_measured;
    news.work.pairs_near += batch.news.work.pairs_near;
    news.work.shapes += batch.news.work.shapes;
    for (std::uint32_t i = batch.first; batch.has_mark && i < batch.end; ++i) {
      const BoxPair pair = candidates.list()[order[i]];
      look_for_tree(pair.a), look_for_tree(pair.b);
    }
  }
}

/// Takes note of answers one by one. Pairs that only the caller's thread may ask are asked when
/// their turn comes; where one throws, the world has taken note of those before it.
void World::State::note_answers_in_turn(PairQuestion question) {
  for (PairBatch& batch : batches.batches()) {
    for (std::uint32_t i = batch.first; i < batch.end; ++i) {
      batches.check(i);
      PairAnswer answer = batches.answer(i);
      if (answer.kind == PairAnswer::Kind::ForCaller)
        answer = answer_of(order[i], question, batch.news.contacts);
      tell(order[i], question, answer, news);
      note_answer(order[i], question, answer);
      const BoxPair pair = candidates.list()[order[i]];
      look_for_tree(pair.a), look_for_tree(pair.b);
    }
    news.work.shapes += batch.news.work.shapes;
  }
  batches.make_room_in(news.contacts);
  for (const PairBatch& batch : batches.batches())
    put_contacts(batch, news.contacts);
}

/// Returns the answer about a pair. It changes nothing, so that pairs may be asked at once, and in
/// any order.
PairAnswer World::State::answer_of(std::uint32_t at, PairQuestion question,
                                   ContactList& into) const {
  using enum PairAnswer::Kind;
  const BoxPair pair = candidates.list()[at];
  if (!is_anyone_up(pair)) return {.kind = Asleep};
  if (question == PairQuestion::AtRest) return {.kind = relation_of(pair)};
  PairAnswer answer{.kind = meet(pair, into)};
  if (answer.is_near()) return answer;
  answer.known_gap = candidates.known_gap(at);
  answer.has_measured = learn_gap(pair, answer.known_gap);
  return answer;
}

/// Returns what is left of a gap until a pair is within its margin or thickness by distance(). That
/// is off by kTouchTolerance of the scale, which is at most 6 times the sum of the sizes and
/// coordinates below, and 12 times after a motion that is less than the gap.
static double lower_difference(double gap, double room, const Bodies::Body& a,
                               const Bodies::Body& b) {
  double size = gap + room;
  for (const Bodies::Body* body : {&a, &b}) {
    for (int k = 12; k < 15; ++k)
      size += std::abs(body->pose.data()[k]);
    size += body->ask([](const BodyShape& shape) { return shape.bounding_radius(); });
  }
  return std::max((gap - room) - 16 * kTouchTolerance * size, 0.0);
}

/// Measures the gap of a pair that was found apart, if that is worth it. True if it was measured.
bool World::State::learn_gap(BoxPair pair, KnownGap& known) const {
  if (!settings.skip_apart) return false;
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  if (!known.wants_gap(cost_of_gap(*a.shape, *b.shape))) return false;
  const double gap =
      a.ask([&](const BodyShape& shape) { return shape.gap(a.pose, *b.shape, b.pose); });
  const double room = a.room() + b.room();
  known.set_gap(room == 0 ? gap : lower_difference(gap, room, a, b), all.changes[pair.a].path,
                all.changes[pair.b].path);
  return true;
}

/// Adds the news of a pair and its answer. Changes nothing else.
void World::State::tell(std::uint32_t at, PairQuestion question, const PairAnswer& answer,
                        PairNews& to) const {
  if (answer.kind == PairAnswer::Kind::Asleep) {
    ++to.work.pairs_asleep;
    return;
  }
  ++to.work.shape_tests;
  to.work.gaps_measured += answer.has_measured;
  const BoxPair pair = candidates.list()[at];
  const bool do_touch = answer.kind == PairAnswer::Kind::Touching;
  if (do_touch && question == PairQuestion::Changed) to.moved.push_back(all.id_pair(pair));
  to.work.pairs_near += answer.kind == PairAnswer::Kind::Near && question == PairQuestion::Changed;
  const bool is_near = answer.is_near() && all.margin(pair) > 0;
  const bool has_other_nearness = is_near != candidates.is_near(at);
  std::vector<BodyPair>& near = is_near ? to.begun_near : to.ended_near;
  if (has_other_nearness) make_room_in(near, 1);  // or a pair could be listed twice
  if (do_touch != candidates.touches(at))
    (do_touch ? to.begun : to.ended).push_back(all.id_pair(pair));
  if (has_other_nearness) near.push_back(all.id_pair(pair));
}

/// Takes note of the answer about a pair. Several threads may do so for different pairs at once.
void World::State::note_answer(std::uint32_t at, PairQuestion question, const PairAnswer& answer) {
  if (answer.kind == PairAnswer::Kind::Asleep) return;
  if (question == PairQuestion::Changed) candidates.known_gap(at) = answer.known_gap;
  const bool is_near = answer.is_near() && all.margin(candidates.list()[at]) > 0;
  candidates.set(at, answer.kind == PairAnswer::Kind::Touching, is_near);
}

bool World::State::is_apart_for_sure(std::uint32_t at) {
  const BoxPair pair = candidates.list()[at];
  const Bodies::Changes &a = all.changes[pair.a], &b = all.changes[pair.b];
  KnownGap& known = candidates.known_gap(at);
  if (a.has_other_shape || b.has_other_shape) known = {};
  if (!known.holds(a.path, b.path)) return false;
  known.note_skip();
  return true;
}

}  // namespace graze
