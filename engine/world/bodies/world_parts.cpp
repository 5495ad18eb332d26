// Tests pairs of bodies of which one is a compound, part by part.

#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/body_shapes/part_pairs.h>

#include <algorithm>

namespace graze {

PosedBody World::State::posed(std::uint32_t index) const {
  const Bodies::Body& body = all.bodies[index];
  return {*body.shape, body.pose, body.room(), body.filter};
}

/// Calls `visit(part_a, part_b)` for the parts that may meet, until it returns false.
template <typename Visit>
void World::State::for_parts_of(BoxPair pair, const Visit& visit) const {
  for_part_pairs(posed(pair.a), posed(pair.b), visit);
}

PairAnswer::Kind World::State::relation_of_parts(BoxPair pair) const {
  const ManifoldSettings asked = all.settings(pair);
  PairAnswer::Kind nearest = PairAnswer::Kind::Apart;
  for_parts_of(pair, [&](const PlacedPart& s, const PlacedPart& t) {
    nearest = std::max(nearest, kind_of(nearness_of(s, t, asked)));
    return nearest != PairAnswer::Kind::Touching;
  });
  return nearest;
}

/// Returns the relation of the two nearest parts, and adds the contacts of all parts.
PairAnswer::Kind World::State::meet_by_parts(BoxPair pair, ContactList& into) const {
  const ManifoldSettings asked = all.settings(pair);
  const BodyPair ids = all.id_pair(pair);
  PairAnswer::Kind nearest = PairAnswer::Kind::Apart;
  Manifold found;
  for_parts_of(pair, [&](const PlacedPart& s, const PlacedPart& t) {
    const PairAnswer::Kind kind = kind_of(graze::contacts_of(s, t, asked, found));
    found.set_parts(s.number, t.number);
    if (kind != PairAnswer::Kind::Apart) into.add(ids, found);
    nearest = std::max(nearest, kind);
    return true;
  });
  return nearest;
}

void World::State::add_contacts_of_parts(const BodyPair& pair,
                                         std::vector<BodyContact>& list) const {
  const BoxPair boxes{pair.a.index, pair.b.index};
  const ManifoldSettings asked = all.settings(boxes);
  Manifold found;
  for_parts_of(boxes, [&](const PlacedPart& s, const PlacedPart& t) {
    if (graze::contacts_of(s, t, asked, found) == Nearness::Apart) return true;
    found.set_parts(s.number, t.number);
    list.push_back({pair, found});
    return true;
  });
}

}  // namespace graze
