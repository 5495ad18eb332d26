#include "tests/engine/histories/oracle.h"

#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/grown_box.h>

#include <algorithm>
#include <stdexcept>

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

}  // namespace

bool is_endless(const Shape& shape) {
  return shape.kind() == ShapeKind::HalfSpace || shape.kind() == ShapeKind::Plane;
}

NamePair ordered(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

bool Oracle::is_awake(std::uint32_t name) const {
  const Being& being = beings_.at(name);
  return being.is_awake && (being.kind != BodyKind::Static || being.role == Role::Sensor);
}

bool Oracle::are_alike(const NamePair& pair, std::uint32_t part_a, std::uint32_t part_b) const {
  const auto piece = [](const Being& being, std::uint32_t part) {
    return *std::find_if(being.pieces.begin(), being.pieces.end(),
                         [&](const Piece& each) { return each.number == part; });
  };
  return tests::are_alike(piece(beings_.at(pair.first), part_a),
                          piece(beings_.at(pair.second), part_b));
}

std::vector<Piece> Oracle::Being::pieces_at(const Pose& at) const {
  return parts ? parts->pieces(at) : std::vector<Piece>{{0, shape, at, std::nullopt}};
}

/// Of parts what their body says without a world.
Aabb Oracle::box_of(std::uint32_t name) const {
  const Being& being = beings_.at(name);
  if (!being.parts) return bounding_aabb(placed(being.pieces[0]));
  const Aabb box = being.parts->together(palette_)->bounds(being.pose);
  for (const Piece& piece : being.pieces) {
    const Aabb own = bounding_aabb(placed(piece));
    const bool is_within =
        (box.min.array() <= own.min.array()).all() && (own.max.array() <= box.max.array()).all();
    if (!is_within) throw std::runtime_error("the box of a body does not hold those of its parts");
  }
  return box;
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
    case Verb::SetMargin:
    case Verb::SetDetection:
      return !has(operation.body);
    case Verb::AddPart:
    case Verb::ReplacePart:
    case Verb::MovePart:
    case Verb::RemovePart:
    case Verb::SetPart:
    case Verb::FillVoxels:
    case Verb::ClearVoxels: {
      const auto found = beings_.find(operation.body);
      return found == beings_.end() || !found->second.parts ||
             !found->second.parts->takes(operation, palette_);
    }
    default:
      return false;
  }
}

void Oracle::remove(std::uint32_t name) {
  set_detection(beings_.at(name), Detection::Discrete);
  beings_.erase(name);
  changed_.erase(name);
  excluded_anew_.erase(name);
  std::erase_if(excluded_, [&](const NamePair& p) { return p.first == name || p.second == name; });
  has_lost_ = true;
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
  if (operation.verb == Verb::Remove) return remove(name);
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
      being = {.pose = operation.pose,
               .kind = settings.kind,
               .role = settings.role,
               .filter = settings.filter};
      take_shape(being, operation.number);
      break;
    case Verb::Move:
    case Verb::MoveToo:
      if (!being.before && is_anyone_swept()) being.before = being.pose;
      being.pose = operation.pose;
      being.is_awake = true;
      break;
    case Verb::SetShape:
      take_shape(being, operation.number);
      being.is_awake = true;
      break;
    case Verb::AddPart:
    case Verb::ReplacePart:
    case Verb::MovePart:
    case Verb::RemovePart:
    case Verb::SetPart:
    case Verb::FillVoxels:
    case Verb::ClearVoxels:
      being.parts->change(operation);
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
    case Verb::SetMargin:
      being.margin = operation.values[0];
      break;
    case Verb::SetDetection:
      set_detection(being, settings.detection);
      return;
    case Verb::Wake:
      if (!being.is_awake) changed_.insert(name);
      being.is_awake = true;
      return;
    default:
      being.is_awake = false;
      return;
  }
  being.pieces = being.pieces_at(being.pose);
  being.version = ++version_;
  changed_.insert(name);
}

bool Oracle::is_anyone_swept() const {
  return std::any_of(beings_.begin(), beings_.end(), [](const auto& entry) {
    return entry.second.detection == Detection::Continuous;
  });
}

/// What others did before the first one is swept, or when nobody is any more, is no motion of
/// theirs.
void Oracle::set_detection(Being& being, Detection detection) {
  if (detection == Detection::Continuous) being.before.reset();
  being.detection = detection;
  if (is_anyone_swept()) return;
  for (auto& [name, each] : beings_)
    each.before.reset();
}

void Oracle::take_shape(Being& being, std::uint32_t number) const {
  being.shape = number;
  being.parts.reset();
  if (number >= palette_.size()) being.parts.emplace(plans_.at(number - palette_.size()));
}

bool Oracle::may_meet(const NamePair& pair) const {
  const Being &s = beings_.at(pair.first), &t = beings_.at(pair.second);
  if (!are_of_interest(s, t) || !filters_pass(s.filter, t.filter)) return false;
  if (excluded_.contains(pair)) return false;
  return divisor_ == 0 || (pair.first + pair.second) % divisor_ != 0;
}

/// Each has its own filter, or else its body's.
bool Oracle::may_meet(const NamePair& pair, const Piece& s, const Piece& t) const {
  return filters_pass(s.filter.value_or(beings_.at(pair.first).filter),
                      t.filter.value_or(beings_.at(pair.second).filter));
}

double Oracle::margin(const NamePair& pair) const {
  return beings_.at(pair.first).margin + beings_.at(pair.second).margin;
}

Oracle::Answer Oracle::answer_of_pieces(const NamePair& pair) const {
  const double most = margin(pair);
  Answer answer{beings_.at(pair.first).version, beings_.at(pair.second).version, false, false};
  for (const Piece& s : pieces_of(pair.first)) {
    for (const Piece& t : pieces_of(pair.second)) {
      if (!may_meet(pair, s, t)) continue;
      answer.touches = answer.touches || intersects(placed(s), placed(t));
      if (most == 0 || answer.is_near) continue;
      const ShapeDistance gap = distance(placed(s), placed(t));
      answer.is_near =
          (gap.status == PairStatus::Converged ? gap.distance : gap.lower_bound) <= most;
    }
  }
  answer.is_near = answer.is_near || (answer.touches && most > 0);
  return answer;
}

const Oracle::Answer& Oracle::answer(const NamePair& pair) {
  const Being &s = beings_.at(pair.first), &t = beings_.at(pair.second);
  const auto [at, is_new] = answers_.try_emplace(pair, Answer{});
  Answer& answer = at->second;
  if (is_new || answer.version_a != s.version || answer.version_b != t.version)
    answer = answer_of_pieces(pair);
  return answer;
}

bool Oracle::do_boxes_meet(const NamePair& pair) const {
  const auto box = [&](std::uint32_t name) {
    const double margin = beings_.at(name).margin;
    return margin > 0 ? grown(box_of(name), margin) : box_of(name);
  };
  return test::share_point(box(pair.first), box(pair.second));
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

Oracle::Lists Oracle::lists(const Lists& before) {
  std::erase_if(answers_, [&](const auto& entry) {
    return !has(entry.first.first) || !has(entry.first.second);
  });
  const auto stands = [](const std::vector<NamePair>& list, const NamePair& pair) {
    return std::binary_search(list.begin(), list.end(), pair);
  };
  Lists now;
  for (auto s = beings_.begin(); s != beings_.end(); ++s) {
    for (auto t = std::next(s); t != beings_.end(); ++t) {
      const NamePair pair{s->first, t->first};
      if (!may_meet(pair)) continue;
      bool touches = stands(before.touching, pair), is_near = stands(before.near, pair);
      if (is_looked_at(pair)) {
        touches = answer(pair).touches, is_near = answer(pair).is_near;
      } else if (touches || is_near) {
        const bool is_there = do_boxes_meet(pair);
        touches = touches && is_there, is_near = is_near && is_there;
      }
      if (touches) now.touching.push_back(pair);
      if (is_near) now.near.push_back(pair);
    }
  }
  return now;
}

bool Oracle::are_solid(const NamePair& pair) const {
  return beings_.at(pair.first).role == Role::Solid && beings_.at(pair.second).role == Role::Solid;
}

std::vector<PartContacts> Oracle::contacts(const NamePair& pair) const {
  std::vector<PartContacts> all;
  const bool have_parts = beings_.at(pair.first).parts || beings_.at(pair.second).parts;
  for (const Piece& s : pieces_of(pair.first)) {
    for (const Piece& t : pieces_of(pair.second)) {
      if (!may_meet(pair, s, t)) continue;
      PartContacts next{s.number, t.number, {}};
      const bool are_endless = is_endless(palette_[s.shape]) && is_endless(palette_[t.shape]);
      if (!are_endless)
        next.manifold = find_contacts(placed(s), placed(t), {.margin = margin(pair)});
      if (!have_parts || !next.manifold.empty()) all.push_back(std::move(next));
    }
  }
  return all;
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
  for (auto& [name, being] : beings_)
    being.before.reset();
}

}  // namespace graze::tests
