#include "tests/engine/histories/contestant.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace graze::tests {
namespace {

auto place_of(const NamedContacts& named) {
  return std::tuple(named.pair, named.contacts.part_a, named.contacts.part_b);
}

}  // namespace

/// Two of one shape in one place are the same two either way: there is nothing to mirror.
std::vector<NamedContacts> Contestant::named(std::span<const BodyContact> contacts,
                                             const Oracle& oracle) const {
  const auto key = [](const BodyContact& contact) {
    return std::tuple(contact.pair, contact.manifold.part_a(), contact.manifold.part_b());
  };
  for (std::size_t i = 1; i < contacts.size(); ++i)
    expect(key(contacts[i - 1]) < key(contacts[i]), title + ": contacts are out of order");
  std::vector<NamedContacts> all;
  for (const BodyContact& contact : contacts) {
    const std::uint32_t a = names.at(contact.pair.a), b = names.at(contact.pair.b);
    all.push_back(
        {ordered(a, b), {contact.manifold.part_a(), contact.manifold.part_b(), contact.manifold}});
    PartContacts& own = all.back().contacts;
    own.manifold.set_parts(0, 0);
    if (a < b) continue;
    std::swap(own.part_a, own.part_b);
    if (oracle.are_alike(all.back().pair, own.part_a, own.part_b)) continue;
    for (std::size_t i = 0; i < own.manifold.size(); ++i) {
      ShapeContact& point = own.manifold[i];
      std::swap(point.point_a, point.point_b);
      point.normal *= -1;
      std::swap(point.feature.a, point.feature.b);
      std::swap(point.material_a, point.material_b);
    }
  }
  std::sort(all.begin(), all.end(),
            [](const auto& s, const auto& t) { return place_of(s) < place_of(t); });
  return all;
}

std::vector<NamedFirstContact> Contestant::named(std::span<const BodyFirstContact> contacts) const {
  std::vector<NamedFirstContact> all;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    BodyFirstContact own = contacts[i];
    expect(own.pair.a < own.pair.b, title + ": a first contact is out of order");
    if (i > 0) {
      const BodyFirstContact& last = contacts[i - 1];
      expect(std::tie(last.pair, last.contact.low) <= std::tie(own.pair, own.contact.low),
             title + ": first contacts are out of order");
    }
    const std::uint32_t a = names.at(own.pair.a), b = names.at(own.pair.b);
    if (a > b) {
      std::swap(own.part_a, own.part_b);
      own.normal = -own.normal;
    }
    all.push_back({ordered(a, b), own});
  }
  sort_by_name(all);
  return all;
}

/// Of a body of that name from here on.
std::shared_ptr<const BodyShape> Contestant::shape_for(std::uint32_t name, std::uint32_t number) {
  wholes.erase(name);
  if (number < palette.size()) return share(palette[number]);
  const Whole whole = whole_of(plans.at(number - palette.size()), palette);
  wholes.emplace(name, whole);
  return shared(whole);
}

void Contestant::tell(const Operation& operation) {
  const std::uint32_t name = operation.body;
  const BodyId id = operation.verb == Verb::Add || !ids.contains(name) ? BodyId{} : ids.at(name);
  const BodySettings& settings = operation.settings;
  switch (operation.verb) {
    case Verb::Add: {
      BodySettings own = settings;
      own.user_data = name;
      const BodyId added = world.add({shape_for(name, operation.number), operation.pose}, own);
      for (const auto& [other, there] : ids)
        expect(there != added, title + ": an id was given out twice");
      ids[name] = added;
      names[added] = name;
      return;
    }
    case Verb::Remove:
      world.remove(id);
      ids.erase(name);
      wholes.erase(name);
      expect(!world.contains(id), title + ": a removed body is still there");
      return;
    case Verb::SetShape:
      if (fault == Fault::DeafToShapes) return;
      return world.set_shape(id, shape_for(name, operation.number));
    case Verb::AddPart:
    case Verb::ReplacePart:
    case Verb::MovePart:
    case Verb::RemovePart:
    case Verb::SetPart:
    case Verb::FillVoxels:
    case Verb::ClearVoxels:
      if (fault == Fault::DeafToParts) return;
      change(wholes.at(name), operation, palette);
      return world.set_shape(id, shared(wholes.at(name)));
    case Verb::SetFilter:
      if (fault == Fault::DeafToFilters) return;
      return world.set_filter(id, settings.filter);
    case Verb::SetMotion:
      return world.set_kind(id, settings.kind);
    case Verb::SetRole:
      return world.set_role(id, settings.role);
    case Verb::SetMargin:
      if (fault == Fault::DeafToMargins) return;
      return world.set_margin(id, operation.values[0]);
    case Verb::SetDetection:
      if (fault == Fault::DeafToDetection) return;
      return world.set_detection(id, settings.detection);
    case Verb::Sleep:
      if (fault == Fault::DeafToSleep) return;
      return world.sleep(id);
    case Verb::Wake:
      return world.wake(id);
    case Verb::Exclude:
      return world.exclude(id, ids.at(operation.number));
    case Verb::Include:
      return world.include(id, ids.at(operation.number));
    case Verb::FilterPairs:
      if (operation.number == 0) return world.set_pair_filter({});
      return world.set_pair_filter([this, divisor = operation.number](BodyId a, BodyId b) {
        return (names.at(a) + names.at(b)) % divisor != 0;
      });
    case Verb::Save:
      saved = world.snapshot();
      saved_ids = ids;
      saved_wholes = wholes;
      return;
    case Verb::Restore:
      world.restore(*saved);
      ids = saved_ids;
      wholes = saved_wholes;
      return;
    default:
      throw std::logic_error("not an operation on a world");
  }
}

void Contestant::move(std::span<const Operation> moves) {
  std::vector<BodyId> moved;
  std::vector<Pose> poses;
  for (const Operation& operation : moves) {
    moved.push_back(ids.at(operation.body));
    poses.push_back(operation.pose);
  }
  if (moved.size() == 1) return world.move(moved[0], poses[0]);
  world.move(moved, poses);
}

/// Those that came last come first.
void Contestant::flush() {
  for (auto next = waiting.rbegin(); next != waiting.rend(); ++next) {
    if (next->verb == Verb::Add) tell(*next);
  }
  for (const Operation& operation : waiting) {
    const bool is_move = operation.verb == Verb::Move || operation.verb == Verb::MoveToo;
    if (is_move) move({&operation, 1});
    if (!is_move && operation.verb != Verb::Add) tell(operation);
  }
  waiting.clear();
}

}  // namespace graze::tests
