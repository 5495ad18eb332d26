// What queries say of two worlds of one scene.

#include <graze/engine/print.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "tests/engine/compounds/twins.h"

namespace graze::tests {
namespace {

/// No body of these tests reaches farther from its origin, metres, nor does a triangle of a field.
constexpr double kLargestBody = 16;

}  // namespace

BodyId Twins::part_id(Named named) const {
  for (const auto& [part, id] : bodies_[named.first].parts) {
    if (part == named.second) return id;
  }
  ADD_FAILURE() << "no part " << named.second << " of body " << named.first;
  return {};
}

// The lower bound of the distance to a mesh depends on its tree, in its last bits: a search that
// converged has it within kTouchTolerance of the scale, which is that of the shape and a triangle.
// Of two meshes that meet the points of any triangles are named.
bool Twins::is_same(const BodyDistance& found, const ShapeDistance& wanted,
                    const Shape& asked) const {
  const ShapeDistance& whole = found.distance;
  if (!is_field(found.id.index)) return whole == wanted;
  if (asked.kind() == ShapeKind::Mesh && whole.distance == 0) return wanted.distance == 0;
  ShapeDistance same = whole;
  same.lower_bound = wanted.lower_bound;
  const double off = kTouchTolerance * (whole.distance + 2 * kLargestBody);
  return same == wanted && (whole.status == PairStatus::NotConverged ||
                            std::abs(whole.lower_bound - wanted.lower_bound) <= 2 * off);
}

/// The first of its parts that a cast comes to, by the number of each body.
std::map<std::uint32_t, PartContact> Twins::casts_at_parts(const Shape& shape,
                                                           const RigidMotion& motion) const {
  std::map<std::uint32_t, PartContact> first;
  for (const BodyCast& found : parts_.cast_all({shape, motion})) {
    const auto [body, part] = name(found.id);
    const auto [at, is_new] = first.try_emplace(body, found.contact, part);
    if (!is_new && found.contact.low == at->second.first.low && part < at->second.second)
      at->second = {found.contact, part};
  }
  return first;
}

std::size_t Twins::ask(const Shape& shape, const Pose& pose, double clearance) {
  std::vector<std::uint32_t> touching, wanted;
  for (const BodyId id : whole_.find_touching({shape, pose}))
    touching.push_back(id.index);
  for (const BodyId id : parts_.find_touching({shape, pose}))
    wanted.push_back(name(id).first);
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  EXPECT_EQ(touching, wanted);

  std::map<std::uint32_t, std::pair<ShapeDistance, std::uint32_t>> nearest;
  for (const BodyDistance& found : parts_.find_within({shape, pose}, clearance)) {
    const auto [body, part] = name(found.id);
    const auto [at, is_new] = nearest.try_emplace(body, found.distance, part);
    const auto& [distance, number] = at->second;
    if (is_new || found.distance.distance > distance.distance) continue;
    if (found.distance.distance < distance.distance || part < number)
      at->second = {found.distance, part};
  }
  const std::vector<BodyDistance> within = whole_.find_within({shape, pose}, clearance);
  EXPECT_EQ(within.size(), nearest.size());
  for (const BodyDistance& found : within) {
    const auto known = nearest.find(found.id.index);
    EXPECT_TRUE(known != nearest.end() && known->second.second == found.part &&
                is_same(found, known->second.first, shape))
        << found << (known == nearest.end() ? "" : testing::PrintToString(known->second));
  }
  const auto closest = whole_.find_closest({shape, pose});
  const auto closest_part = parts_.find_closest({shape, pose});
  EXPECT_EQ(closest.has_value(), closest_part.has_value());
  if (closest && closest_part) {
    EXPECT_EQ(closest->distance.distance, closest_part->distance.distance);
  }
  return touching.size() + within.size();
}

std::size_t Twins::cast_ray(const Ray& ray) {
  std::map<std::uint32_t, std::pair<RayHit, std::uint32_t>> first;
  for (const BodyRayHit& found : parts_.cast_ray_all(ray)) {
    const auto [body, part] = name(found.id);
    const auto [at, is_new] = first.try_emplace(body, found.hit, part);
    if (!is_new && found.hit.distance == at->second.first.distance && part < at->second.second)
      at->second = {found.hit, part};
  }
  const std::vector<BodyRayHit> hits = whole_.cast_ray_all(ray);
  EXPECT_EQ(hits.size(), first.size());
  for (const BodyRayHit& found : hits) {
    EXPECT_TRUE(first.contains(found.id.index) &&
                (first.at(found.id.index) == std::pair{found.hit, found.part}));
  }
  const std::optional<BodyRayHit> hit = whole_.cast_ray(ray);
  EXPECT_EQ(hit.has_value(), !hits.empty());
  if (hit && !hits.empty()) {
    EXPECT_EQ(*hit, hits[0]);
  }
  return hits.size();
}

std::size_t Twins::cast(const Shape& shape, const RigidMotion& motion) {
  const std::vector<BodyCast> casts = whole_.cast_all({shape, motion});
  std::map<std::uint32_t, PartContact> first = casts_at_parts(shape, motion);
  EXPECT_EQ(casts.size(), first.size());
  for (const BodyCast& found : casts) {
    EXPECT_TRUE(first.contains(found.id.index) &&
                (first.at(found.id.index) == std::pair(found.contact, found.part)))
        << found.id.index << " " << found.part;
  }
  return casts.size();
}

// A part rests where it is, a body of its own is a motion about the origin: so the lengths that
// their tolerances are a share of differ. Those of a motion sum to no more than 22 times the
// farthest of its places, centres and shifts (sum_of_lengths() of motion_checks.h: sqrt(3) (2 + 8)
// for what moves, sqrt(3) for what rests, and twice how far each reaches), and a tolerance is 2^-28
// of these (shape_motion.h): below 2^-23 of the farthest. Then law 14 says of either world that at
// its time the two are no farther apart than that, and that it is not later than a witness of the
// other's.
std::size_t Twins::cast_far(const Shape& shape, const RigidMotion& motion) {
  const std::vector<BodyCast> casts = whole_.cast_all({shape, motion});
  std::map<std::uint32_t, PartContact> rest = casts_at_parts(shape, motion);
  const double farthest = motion.start().translation().norm() + motion.centre().norm() +
                          motion.shift().norm() + kLargestBody;
  const double tolerance = std::max(RigidContactSettings{}.tolerance, 0x1p-23 * farthest);
  const auto expect_near = [&](std::uint32_t body, const PartContact& at) {
    const BodyId id = part_id({body, at.second});
    const ShapeDistance apart =
        distance({*parts_.shape(id).shape(), parts_.pose(id)}, {shape, motion.at(at.first.low)});
    EXPECT_LE(apart.lower_bound, tolerance) << body << " " << at.second;
  };
  for (const BodyCast& found : casts) {
    const PartContact of_whole{found.contact, found.part};
    const auto known = rest.find(found.id.index);
    if (known == rest.end()) {
      EXPECT_NE(found.contact.status, RigidStatus::Hit) << found.id.index;
      expect_near(found.id.index, of_whole);
      continue;
    }
    const PartContact of_parts = known->second;
    rest.erase(known);
    if (!is_compound(found.id.index)) {
      EXPECT_TRUE(of_whole == of_parts) << found.id.index;
      continue;
    }
    EXPECT_LE(of_whole.first.low, of_parts.first.high);
    EXPECT_LE(of_parts.first.low, of_whole.first.high);
    expect_near(found.id.index, of_whole);
    expect_near(found.id.index, of_parts);
  }
  for (const auto& [body, at] : rest) {
    EXPECT_NE(at.first.status, RigidStatus::Hit) << body;
    expect_near(body, at);
  }
  return casts.size();
}

}  // namespace graze::tests
