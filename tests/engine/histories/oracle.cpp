#include "tests/engine/histories/oracle.h"

#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>

#include "tests/engine/broad_phase/box_histories.h"

namespace graze::tests {
namespace {

bool filters_pass(const Filter& a, const Filter& b) {
  if (a.group != 0 && a.group == b.group) return a.group > 0;
  return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

/// Rows and columns static, kinematic, dynamic, and sensors of any motion.
bool are_of_interest(const Oracle::Being& s, const Oracle::Being& t) {
  constexpr bool kMeets[4][4] = {
      {false, false, true, false},
      {false, false, true, true},
      {true, true, true, true},
      {false, true, true, false},
  };
  const auto row = [](const Oracle::Being& b) {
    if (b.role == Role::Sensor) return 3;
    return b.kind == BodyKind::Static ? 0 : b.kind == BodyKind::Kinematic ? 1 : 2;
  };
  return kMeets[row(s)][row(t)];
}

bool is_endless(const Shape& shape) {
  return shape.kind() == ShapeKind::HalfSpace || shape.kind() == ShapeKind::Plane;
}

}  // namespace

NamePair ordered(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

bool Oracle::is_awake(std::uint32_t name) const {
  const Being& being = beings_.at(name);
  return being.is_awake && (being.kind != BodyKind::Static || being.role == Role::Sensor);
}

bool Oracle::are_alike(std::uint32_t a, std::uint32_t b) const {
  const Being &s = beings_.at(a), &t = beings_.at(b);
  return s.shape == t.shape && s.pose.matrix() == t.pose.matrix();
}

bool Oracle::concerns_nobody(const Operation& operation) const {
  switch (operation.verb) {
    case Verb::Add:
      return has(operation.body);
    case Verb::Exclude:
    case Verb::Include:
      return !has(operation.body) || !has(operation.number) || operation.body == operation.number;
    case Verb::Remove:
    case Verb::Move:
    case Verb::MoveToo:
    case Verb::SetShape:
    case Verb::SetFilter:
    case Verb::SetMotion:
    case Verb::SetRole:
    case Verb::Sleep:
    case Verb::Wake:
      return !has(operation.body);
    default:
      return false;
  }
}

void Oracle::change(const Operation& operation) {
  const std::uint32_t name = operation.body;
  const BodySettings& settings = operation.settings;
  if (operation.verb == Verb::FilterPairs) {
    divisor_ = operation.number;
    for (const auto& [other, being] : beings_)
      changed_.insert(other);
    return;
  }
  if (operation.verb == Verb::Remove) {
    beings_.erase(name);
    changed_.erase(name);
    excluded_anew_.erase(name);
    std::erase_if(excluded_,
                  [&](const NamePair& p) { return p.first == name || p.second == name; });
    has_lost_ = true;
    return;
  }
  if (operation.verb == Verb::Exclude || operation.verb == Verb::Include) {
    const NamePair pair = ordered(name, operation.number);
    const bool is_new = operation.verb == Verb::Exclude ? excluded_.insert(pair).second
                                                        : excluded_.erase(pair) != 0;
    if (is_new) excluded_anew_.insert(name);
    return;
  }
  Being& being = beings_[name];
  switch (operation.verb) {
    case Verb::Add:
      being = {
          operation.number, operation.pose, settings.kind, settings.role, settings.filter, true, 0};
      break;
    case Verb::Move:
    case Verb::MoveToo:
      being.pose = operation.pose;
      being.is_awake = true;
      break;
    case Verb::SetShape:
      being.shape = operation.number;
      being.is_awake = true;
      break;
    case Verb::SetFilter:
      being.filter = settings.filter;
      break;
    case Verb::SetMotion:
      being.kind = settings.kind;
      break;
    case Verb::SetRole:
      being.role = settings.role;
      break;
    case Verb::Wake:
      if (!being.is_awake) changed_.insert(name);
      being.is_awake = true;
      return;
    default:
      being.is_awake = false;
      return;
  }
  being.version = ++version_;
  changed_.insert(name);
}

bool Oracle::meet(std::uint32_t a, const Being& s, std::uint32_t b, const Being& t) const {
  if (!are_of_interest(s, t) || !filters_pass(s.filter, t.filter)) return false;
  if (excluded_.contains({a, b})) return false;
  return divisor_ == 0 || (a + b) % divisor_ != 0;
}

bool Oracle::touch(std::uint32_t a, const Being& s, std::uint32_t b, const Being& t) {
  const auto [at, is_new] = answers_.try_emplace({a, b}, Answer{});
  Answer& answer = at->second;
  if (is_new || answer.version_a != s.version || answer.version_b != t.version) {
    answer = {s.version, t.version,
              intersects({palette_[s.shape], s.pose}, {palette_[t.shape], t.pose})};
  }
  return answer.touches;
}

bool Oracle::has_changed(std::uint32_t name) const {
  return changed_.contains(name) || excluded_anew_.contains(name);
}

/// One of the two changed, and one is awake; or a static one that does not sleep is what changed.
bool Oracle::is_looked_at(const NamePair& pair) const {
  const auto [a, b] = pair;
  if (!has_changed(a) && !has_changed(b)) return false;
  const auto is_up = [&](std::uint32_t name) {
    return is_awake(name) || (has_changed(name) && beings_.at(name).is_awake);
  };
  return is_up(a) || is_up(b);
}

bool Oracle::do_boxes_overlap(const Being& s, const Being& t) const {
  return test::share_point(bounding_aabb({palette_[s.shape], s.pose}),
                           bounding_aabb({palette_[t.shape], t.pose}));
}

std::vector<NamePair> Oracle::touching(const std::vector<NamePair>& before) {
  std::erase_if(answers_, [&](const auto& entry) {
    return !has(entry.first.first) || !has(entry.first.second);
  });
  std::vector<NamePair> pairs;
  for (auto s = beings_.begin(); s != beings_.end(); ++s) {
    for (auto t = std::next(s); t != beings_.end(); ++t) {
      const NamePair pair{s->first, t->first};
      if (!meet(s->first, s->second, t->first, t->second)) continue;
      const bool touches = is_looked_at(pair)
                               ? touch(s->first, s->second, t->first, t->second)
                               : std::binary_search(before.begin(), before.end(), pair) &&
                                     do_boxes_overlap(s->second, t->second);
      if (touches) pairs.push_back(pair);
    }
  }
  return pairs;
}

bool Oracle::are_solid(const NamePair& pair) const {
  return beings_.at(pair.first).role == Role::Solid && beings_.at(pair.second).role == Role::Solid;
}

Manifold Oracle::contacts(const NamePair& pair) const {
  const Shape& a = shape_of(pair.first);
  const Shape& b = shape_of(pair.second);
  if (is_endless(a) && is_endless(b)) return {};
  return find_contacts({a, beings_.at(pair.first).pose}, {b, beings_.at(pair.second).pose});
}

bool Oracle::must_be_listed(const NamePair& pair) const {
  return is_looked_at(pair) && (changed_.contains(pair.first) || changed_.contains(pair.second));
}

bool Oracle::may_be_listed(const NamePair& pair) const {
  return is_looked_at(pair);
}

void Oracle::settle() {
  changed_.clear();
  excluded_anew_.clear();
  has_lost_ = false;
}

}  // namespace graze::tests
