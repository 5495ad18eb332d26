// Where bodies that touch meet: found when asked for, from the poses alone.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/bodies/world_state.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace graze {

void World::State::check_is_updated(const char* what) const {
  if (changed.empty() && removed == 0 && !is_cut_short) return;
  throw InputError(std::string(what) + ": changes wait for an update");
}

BodyContact World::State::contact_of(const BodyPair& pair) const {
  const Bodies::Body& a = all.bodies[pair.a.index];
  const Bodies::Body& b = all.bodies[pair.b.index];
  return {pair,
          a.ask([&](const BodyShape& shape) { return shape.contacts(a.pose, *b.shape, b.pose); })};
}

/// Whether the two touch. If so, and if the settings ask for contacts, these are found as well.
bool World::State::test(BoxPair pair) {
  const Bodies::Body& a = all.bodies[pair.a];
  const Bodies::Body& b = all.bodies[pair.b];
  if (!settings.contacts || !all.are_solid(pair.a, pair.b))
    return a.ask([&](const BodyShape& shape) { return shape.touches(a.pose, *b.shape, b.pose); });
  const std::optional<Manifold> manifold =
      a.ask([&](const BodyShape& shape) { return shape.meet(a.pose, *b.shape, b.pose); });
  if (manifold) found.add(all.id_pair(pair), *manifold);
  return manifold.has_value();
}

void World::State::sort_contacts() {
  if (found.is_ascending()) {
    std::swap(contacts, found);
  } else {
    const std::span<const BodyContact> list = found.all();
    order.resize(list.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t s, std::uint32_t t) { return list[s].pair < list[t].pair; });
    contacts.clear();
    for (const std::uint32_t at : order)
      contacts.add(list[at]);
  }
  work.contacts_found = contacts.all().size();
  work.contacts_skipped = moved.size() - contacts.all().size();
}

std::vector<BodyContact> World::contacts() const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyContact> {
    state_->check_is_updated("contacts");
    std::vector<BodyContact> contacts;
    for (const BodyPair& pair : pairs()) {
      if (state_->all.are_solid(pair.a.index, pair.b.index))
        contacts.push_back(state_->contact_of(pair));
    }
    return contacts;
  });
}

}  // namespace graze
