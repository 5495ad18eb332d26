#include <graze/engine/world/contacts/contact_regions.h>

#include <algorithm>
#include <numeric>

namespace graze {

using narrowphase::Vec3;

namespace {

// Lengths below this share of the body's size do not count as obstacles.
constexpr double kNegligible = 1e-9;

// An exit along an arc is known to kFacingTolerance = 1e-7 of the body's size, and its direction to
// less than a thousandth (enclosure.cpp derives it). So edges in one line or plane may have exits
// that differ by that much, though all of them are the same. The shallower one, which is taken
// first, must not clear the others: each may hold another part of the region.
constexpr double kSameExitDepth = 1e-6;
constexpr double kSameExitCosine = 1 - 5e-7;

bool is_shorter(const TouchedTriangle& s, const TouchedTriangle& t) {
  const double of_s = s.parting.exit.depth, of_t = t.parting.exit.depth;
  return of_s != of_t ? of_s < of_t : s.parting.triangle < t.parting.triangle;
}

bool is_taken_before(const TouchedTriangle& s, const TouchedTriangle& t) {
  return s.rank != t.rank ? s.rank < t.rank : s.parting.triangle < t.parting.triangle;
}

}  // namespace

const TouchedTriangle& speaker_of(std::span<const TouchedTriangle> members) {
  const TouchedTriangle* speaker = &members.back();
  for (const TouchedTriangle& member : members)
    if (member.parting.feature == LeftFeature::Face) speaker = &member;
  return *speaker;
}

void ContactRegions::start(std::vector<TouchedTriangle>& touched, double size) {
  std::sort(touched.begin(), touched.end(), is_taken_before);
  clearance_.start(kNegligible * size);
  negligible_ = kSameExitDepth * size;
  directions_.clear();
}

bool ContactRegions::is_known(const Vec3& direction) const {
  return std::any_of(directions_.begin(), directions_.end(),
                     [&](const Vec3& known) { return is_one_direction(known, direction); });
}

std::optional<std::uint32_t> ContactRegions::number_as_deep(const LocalParting& parting) const {
  const narrowphase::Exit& exit = parting.exit;
  if (parting.feature == LeftFeature::Face) return std::nullopt;  // these exits are exact
  if (!clearance_.satisfies({exit.direction, exit.depth - negligible_})) return std::nullopt;
  const auto at = std::max_element(directions_.begin(), directions_.end(),
                                   [&](const Vec3& one, const Vec3& other) {
                                     return dot(one, exit.direction) < dot(other, exit.direction);
                                   });
  if (at == directions_.end() || dot(*at, exit.direction) <= kSameExitCosine) return std::nullopt;
  return static_cast<std::uint32_t>(at - directions_.begin());
}

std::uint32_t ContactRegions::number_of(const Vec3& direction) {
  const auto at = std::find_if(directions_.begin(), directions_.end(), [&](const Vec3& known) {
    return is_one_direction(known, direction);
  });
  const auto number = static_cast<std::uint32_t>(at - directions_.begin());
  if (at == directions_.end()) directions_.push_back(direction);
  return number;
}

std::uint32_t ContactRegions::root_of(std::uint32_t member) {
  while (parent_[member] != member)
    member = parent_[member] = parent_[parent_[member]];
  return member;
}

/// Members of one direction that share a corner are in one region, whose root is its first member.
std::uint32_t ContactRegions::connect(std::vector<TouchedTriangle>& touched,
                                      const FacingFeatures& features) {
  parent_.resize(touched.size());
  std::iota(parent_.begin(), parent_.end(), 0u);
  corners_.clear();
  for (std::uint32_t i = 0; i < touched.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = features.vertex(touched[i].parting.triangle, k);
      corners_.push_back({touched[i].direction, vertex, i});
    }
  }
  std::sort(corners_.begin(), corners_.end(), [](const CornerOf& s, const CornerOf& t) {
    if (s.direction != t.direction) return s.direction < t.direction;
    return s.vertex != t.vertex ? s.vertex < t.vertex : s.member < t.member;
  });
  for (std::size_t i = 1; i < corners_.size(); ++i) {
    const CornerOf &s = corners_[i - 1], &t = corners_[i];
    if (s.direction != t.direction || s.vertex != t.vertex) continue;
    const std::uint32_t of_s = root_of(s.member), of_t = root_of(t.member);
    parent_[std::max(of_s, of_t)] = std::min(of_s, of_t);
  }
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < touched.size(); ++i) {
    const std::uint32_t root = root_of(i);
    touched[i].region = root == i ? count++ : touched[root].region;
  }
  std::sort(touched.begin(), touched.end(), [](const TouchedTriangle& s, const TouchedTriangle& t) {
    return s.region != t.region ? s.region < t.region : is_shorter(s, t);
  });
  return count;
}

}  // namespace graze
