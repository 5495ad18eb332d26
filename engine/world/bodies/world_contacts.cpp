// Finds which bodies touch, and their contacts, when asked for, from the poses alone.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/contacts/margin/nearness.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/shape_work.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace graze {
void World::State::check_is_updated(const char* what) const {
  if (is_updated()) return;
  throw InputError(std::string(what) + ": changes wait for an update");
}

void World::State::add_contacts(const BodyPair& pair, std::vector<BodyContact>& list) const {
  const BoxPair boxes{pair.a.index, pair.b.index};
  if (all.has_parts(boxes)) return add_contacts_of_parts(pair, list);
  const ManifoldSettings asked = all.settings(boxes);
  if (!are_plain(asked)) {
    list.push_back({pair, contacts_within(boxes, asked)});
    return;
  }
  const Bodies::Body& a = all.bodies[pair.a.index];
  const Bodies::Body& b = all.bodies[pair.b.index];
  list.push_back({pair, a.ask([&](const BodyShape& shape) {
                    return shape.contacts(a.pose, *b.shape, b.pose);
                  })});
}

bool World::State::do_touch(BoxPair pair) const {
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  return a.ask([&](const BodyShape& shape) { return shape.touches(a.pose, *b.shape, b.pose); });
}

/// Says whether the two touch, are near by their margin or their sides, or are apart.
PairAnswer::Kind World::State::relation_of(BoxPair pair) const {
  using enum PairAnswer::Kind;
  if (all.has_parts(pair)) return relation_of_parts(pair);
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

/// Returns the contacts of a pair with a margin or sides. A shape of a user's own is asked about
/// the margin, but knows no sides.
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

/// Returns relation_of() a pair with a margin or sides, and adds their contacts if they touch or
/// are near.
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
  const PairAnswer::Kind kind = relation_of(pair);
  if (kind != PairAnswer::Kind::Apart) into.add(all.id_pair(pair), contacts_within(pair, asked));
  return kind;
}

/// Says whether the two touch. If so, and if the settings ask for contacts, adds these as well.
PairAnswer::Kind World::State::meet(BoxPair pair, ContactList& into) const {
  using enum PairAnswer::Kind;
  if (!settings.contacts || !all.are_solid(pair.a, pair.b)) return relation_of(pair);
  if (all.has_parts(pair)) return meet_by_parts(pair, into);
  if (const ManifoldSettings asked = all.settings(pair); !are_plain(asked))
    return meet_within(pair, asked, into);
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  const Shape *of_a = a.shape->shape(), *of_b = b.shape->shape();
  if (of_a != nullptr && of_b != nullptr &&
      pair_method(of_a->kind(), of_b->kind()) != PairMethod::Planes) {
    // The answer of meet() of two Shapes, without allocating memory.
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
    std::sort(order.begin(), order.end(), [&](std::uint32_t s, std::uint32_t t) {
      return list[s].pair != list[t].pair ? list[s].pair < list[t].pair : s < t;
    });
    contacts.make_room_for_all(news.contacts);
    constexpr std::size_t kPart = 1024;
    workers.for_each((list.size() + kPart - 1) / kPart, [&](std::size_t part) {
      for (std::size_t i = part * kPart; i < std::min((part + 1) * kPart, list.size()); ++i)
        contacts.put(i, list[order[i]]);
    });
  }
  news.work.contacts_found = contacts.pair_count();
  news.work.contacts_skipped = news.moved.size() + news.work.pairs_near - contacts.pair_count();
}

std::vector<BodyContact> World::State::contacts_of(std::span<const BodyPair> pairs) const {
  std::vector<BodyContact> list;
  for (const BodyPair& pair : pairs) {
    if (all.are_solid(pair.a.index, pair.b.index)) add_contacts(pair, list);
  }
  return list;
}

std::vector<BodyContact> World::contacts() const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyContact> {
    state_->check_is_updated("contacts");
    return state_->contacts_of(state_->list_pairs(PairState::Either));
  });
}

std::vector<BodyContact> World::contacts(BodyId id) const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyContact> {
    const State& state = *state_;
    state.body(id, "contacts");
    state.check_is_updated("contacts");
    return state.contacts_of(state.list_pairs_of(id.index, PairState::Either));
  });
}

}  // namespace graze
