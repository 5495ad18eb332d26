// Which bodies touch, and where they meet: found when asked for, from the poses alone.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/contacts/margin/nearness.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/shape_work.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace graze {
namespace {

PairAnswer::Kind kind_of(Nearness nearness) {
  using enum PairAnswer::Kind;
  if (nearness == Nearness::Apart) return Apart;
  return nearness == Nearness::Near ? Near : Touching;
}

}  // namespace

void World::State::check_is_updated(const char* what) const {
  if (changed.empty() && removed == 0 && !is_cut_short) return;
  throw InputError(std::string(what) + ": changes wait for an update");
}

BodyContact World::State::contact_of(const BodyPair& pair) const {
  const BoxPair boxes{pair.a.index, pair.b.index};
  const ManifoldSettings asked = all.settings(boxes);
  if (!are_plain(asked)) return {pair, contacts_within(boxes, asked)};
  const Bodies::Body& a = all.bodies[pair.a.index];
  const Bodies::Body& b = all.bodies[pair.b.index];
  return {pair,
          a.ask([&](const BodyShape& shape) { return shape.contacts(a.pose, *b.shape, b.pose); })};
}

bool World::State::do_touch(BoxPair pair) const {
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  return a.ask([&](const BodyShape& shape) { return shape.touches(a.pose, *b.shape, b.pose); });
}

/// How the two stand to each other, to their margin and to their sides.
PairAnswer::Kind World::State::stand(BoxPair pair) const {
  using enum PairAnswer::Kind;
  const ManifoldSettings asked = all.settings(pair);
  if (are_plain(asked)) return do_touch(pair) ? Touching : Apart;
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  const Shape *of_a = a.shape->shape(), *of_b = b.shape->shape();
  if (of_a != nullptr && of_b != nullptr)
    return kind_of(nearness({*of_a, a.pose}, {*of_b, b.pose}, asked, shape_work()));
  if (do_touch(pair)) return Touching;
  return contacts_within(pair, asked).empty() ? Apart : Near;
}

/// Of shapes of a user's own what they say of the margin: they know nothing of sides.
Manifold World::State::contacts_within(BoxPair pair, const ManifoldSettings& asked) const {
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  const Shape *of_a = a.shape->shape(), *of_b = b.shape->shape();
  if (of_a == nullptr || of_b == nullptr) {
    return a.ask([&](const BodyShape& shape) {
      return shape.contacts_within(a.pose, *b.shape, b.pose, asked.margin);
    });
  }
  Manifold found;
  if (pair_method(of_a->kind(), of_b->kind()) != PairMethod::Planes)
    graze::contacts_within({*of_a, a.pose}, {*of_b, b.pose}, asked, shape_work(), found);
  return found;
}

/// The same. If they touch or are near, and if the settings ask for contacts, these are found, too.
PairAnswer::Kind World::State::meet_within(BoxPair pair, const ManifoldSettings& asked,
                                           ContactList& into) const {
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  const Shape *of_a = a.shape->shape(), *of_b = b.shape->shape();
  if (of_a != nullptr && of_b != nullptr &&
      pair_method(of_a->kind(), of_b->kind()) != PairMethod::Planes) {
    static thread_local Manifold found;  // without memory of its own
    const Nearness nearness =
        graze::contacts_within({*of_a, a.pose}, {*of_b, b.pose}, asked, shape_work(), found);
    if (nearness != Nearness::Apart) into.add(all.id_pair(pair), found);
    return kind_of(nearness);
  }
  const PairAnswer::Kind kind = stand(pair);
  if (kind != PairAnswer::Kind::Apart) into.add(all.id_pair(pair), contacts_within(pair, asked));
  return kind;
}

/// Whether they touch. If so, and if the settings ask for contacts, these are found as well.
PairAnswer::Kind World::State::meet(BoxPair pair, ContactList& into) const {
  using enum PairAnswer::Kind;
  if (!settings.contacts || !all.are_solid(pair.a, pair.b)) return stand(pair);
  if (const ManifoldSettings asked = all.settings(pair); !are_plain(asked))
    return meet_within(pair, asked, into);
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  const Shape *of_a = a.shape->shape(), *of_b = b.shape->shape();
  if (of_a != nullptr && of_b != nullptr &&
      pair_method(of_a->kind(), of_b->kind()) != PairMethod::Planes) {
    // What meet() of two Shapes says, without memory of its own.
    static thread_local Manifold found;
    contacts_in_boxes({*of_a, a.pose}, {*of_b, b.pose}, shape_work(), found);
    if (!found.empty()) into.add(all.id_pair(pair), found);
    return found.empty() ? Apart : Touching;
  }
  const std::optional<Manifold> manifold =
      a.ask([&](const BodyShape& shape) { return shape.meet(a.pose, *b.shape, b.pose); });
  if (manifold) into.add(all.id_pair(pair), *manifold);
  return manifold.has_value() ? Touching : Apart;
}

void World::State::sort_contacts() {
  if (news.contacts.is_ascending()) {
    std::swap(contacts, news.contacts);
  } else {
    const std::span<const BodyContact> list = news.contacts.all();
    order.resize(list.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t s, std::uint32_t t) { return list[s].pair < list[t].pair; });
    contacts.make_room(list.size());
    constexpr std::size_t kPart = 1024;
    workers.for_each((list.size() + kPart - 1) / kPart, [&](std::size_t part) {
      for (std::size_t i = part * kPart; i < std::min((part + 1) * kPart, list.size()); ++i)
        contacts.put(i, list[order[i]]);
    });
  }
  news.work.contacts_found = contacts.all().size();
  news.work.contacts_skipped = news.moved.size() + news.work.pairs_near - contacts.all().size();
}

/// Those of bodies that are there and of which `is_asked_for(at)` is true, in ascending order.
template <typename IsAskedFor>
std::vector<BodyPair> World::State::list_pairs(const IsAskedFor& is_asked_for) const {
  std::vector<BodyPair> pairs;
  for (std::uint32_t at = 0; at < candidates.list().size(); ++at) {
    const BoxPair pair = candidates.list()[at];
    if (is_asked_for(at) && all.ids.is_live(pair.a) && all.ids.is_live(pair.b))
      pairs.push_back(all.id_pair(pair));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<BodyPair> World::pairs() const {
  return state_->list_pairs([&](std::uint32_t at) { return state_->candidates.touches(at); });
}

std::vector<BodyPair> World::near_pairs() const {
  return state_->list_pairs([&](std::uint32_t at) { return state_->candidates.is_near(at); });
}

std::vector<BodyContact> World::contacts() const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyContact> {
    state_->check_is_updated("contacts");
    std::vector<BodyContact> contacts;
    const CandidatePairs& candidates = state_->candidates;
    for (const BodyPair& pair : state_->list_pairs(
             [&](std::uint32_t at) { return candidates.touches(at) || candidates.is_near(at); })) {
      if (state_->all.are_solid(pair.a.index, pair.b.index))
        contacts.push_back(state_->contact_of(pair));
    }
    return contacts;
  });
}

}  // namespace graze
