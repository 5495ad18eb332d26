#include "tests/engine/histories/contestant.h"

#include <stdexcept>

namespace graze::tests {

void Contestant::tell(const Operation& operation) {
  const std::uint32_t name = operation.body;
  const BodyId id = operation.verb == Verb::Add || !ids.contains(name) ? BodyId{} : ids.at(name);
  const BodySettings& settings = operation.settings;
  switch (operation.verb) {
    case Verb::Add: {
      BodySettings own = settings;
      own.user_data = name;
      const BodyId added = world.add({palette[operation.number], operation.pose}, own);
      for (const auto& [other, there] : ids)
        expect(there != added, title + ": an id was given out twice");
      ids[name] = added;
      names[added] = name;
      return;
    }
    case Verb::Remove:
      world.remove(id);
      ids.erase(name);
      expect(!world.contains(id), title + ": a removed body is still there");
      return;
    case Verb::SetShape:
      if (fault == Fault::DeafToShapes) return;
      return world.set_shape(id, palette[operation.number]);
    case Verb::SetFilter:
      if (fault == Fault::DeafToFilters) return;
      return world.set_filter(id, settings.filter);
    case Verb::SetMotion:
      return world.set_kind(id, settings.kind);
    case Verb::SetRole:
      return world.set_role(id, settings.role);
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
      return;
    case Verb::Restore:
      world.restore(*saved);
      ids = saved_ids;
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
