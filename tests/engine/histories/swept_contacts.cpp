#include "tests/engine/histories/swept_contacts.h"

#include <graze/bvh/error.h>
#include <graze/engine/world/rigid/sliding_contact.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace graze::tests {
namespace {

using Eigen::Vector3d;

// What a world says where it knows nothing.
constexpr RigidContact kUnknown{
    .status = RigidStatus::Close, .low = 0, .high = 1, .is_out_of_budget = true};

// Metres, more than any tolerance here.
constexpr double kRoom = 0.01;

/// No point of a shape in this box ever goes farther, metres: a shift, and an arc about an axis.
double longest_travel(const RigidMotion& motion, const Aabb& box) {
  if (motion.angle() == 0) return motion.shift().norm();
  const Vector3d farthest =
      (box.max - motion.centre()).cwiseAbs().cwiseMax((box.min - motion.centre()).cwiseAbs());
  return motion.shift().norm() + std::abs(motion.angle()) * farthest.norm();
}

double widest_gap(const Aabb& s, const Aabb& t) {
  return std::max((s.min - t.max).maxCoeff(), (t.min - s.max).maxCoeff());
}

/// A body and its motion since the last update; none where that cannot be computed.
struct MovedBody {
  std::uint32_t name;
  const Oracle::Being& being;
  std::optional<RigidMotion> motion;
};

MovedBody in_motion(std::uint32_t name, const Oracle::Being& being) {
  try {
    return {name, being, RigidMotion::between(being.before.value_or(being.pose), being.pose)};
  } catch (const PoseError&) {
    return {name, being, std::nullopt};
  }
}

bool is_swept(const Oracle::Being& being) {
  return being.detection == Detection::Continuous && being.before && being.is_awake;
}

/// Where two meet that are as near as they come.
void add_meeting(const PlacedShapeView& a, const PlacedShapeView& b, BodyFirstContact& contact) {
  const ShapeDistance gap = distance(a, b);
  if (gap.distance > 0) {
    contact.normal = gap.normal, contact.point = gap.point_a / 2 + gap.point_b / 2;
    return;
  }
  if (is_endless(a.shape) && is_endless(b.shape)) return;
  const ShapeContact* deepest = nullptr;
  const Manifold manifold = find_contacts(a, b);
  for (const ShapeContact& each : manifold) {
    if (deepest == nullptr || each.depth > deepest->depth) deepest = &each;
  }
  if (deepest != nullptr) contact.normal = deepest->normal, contact.point = deepest->point;
}

class FirstContactsOfPair {
 public:
  FirstContactsOfPair(const Oracle& oracle, const MovedBody& a, const MovedBody& b,
                      const WorldSettings& settings, std::vector<NamedFirstContact>& to)
      : oracle_(oracle), a_(a), b_(b), settings_(settings), to_(to) {}

  void add_all() {
    if (!a_.motion || !b_.motion) {
      add(kUnknown, 0, 0);
      return;
    }
    const NamePair pair{a_.name, b_.name};
    for (const Piece& s : a_.being.pieces_at(a_.motion->start())) {
      for (const Piece& t : b_.being.pieces_at(b_.motion->start())) {
        if (oracle_.may_meet(pair, s, t)) add_of(s, t);
      }
    }
  }

 private:
  MovedShape in_motion(const MovedBody& body, const Piece& piece) const {
    return {oracle_.palette()[piece.shape],
            body.being.parts ? motion_of_part(*body.motion, piece.pose) : *body.motion};
  }

  BodyFirstContact& add(const RigidContact& contact, std::uint32_t part_a, std::uint32_t part_b) {
    to_.push_back({{a_.name, b_.name},
                   {.pair = {},
                    .contact = contact,
                    .is_at_start = false,
                    .normal = Vector3d::Zero(),
                    .point = Vector3d::Zero(),
                    .part_a = part_a,
                    .part_b = part_b}});
    return to_.back().contact;
  }

  void add_of(const Piece& s, const Piece& t) {
    const MovedShape a = in_motion(a_, s), b = in_motion(b_, t);
    const auto met = contact_in_motion(a, b, settings_.sweeps);
    if (met && met->status == RigidStatus::Free) return;
    BodyFirstContact& found = add(met.value_or(kUnknown), s.number, t.number);
    const double low = found.contact.low;
    const Pose at_a = a.motion.at(low), at_b = b.motion.at(low);
    if (low == 0) found.is_at_start = intersects({a.shape, at_a}, {b.shape, at_b});
    add_meeting({a.shape, at_a}, {b.shape, at_b}, found);
    to_.back().is_alike = are_alike({0, s.shape, at_a, {}}, {0, t.shape, at_b, {}});
    if (low > 0) return;
    Work work;
    const auto next = contact_after_sliding(a.shape, a.motion, b.shape, b.motion, settings_.sweeps,
                                            settings_.sliding_depth, work);
    if (!next) return;
    BodyFirstContact& later = add(next->contact, s.number, t.number);
    later.normal = next->normal, later.point = next->point;
  }

  const Oracle& oracle_;
  const MovedBody& a_;
  const MovedBody& b_;
  const WorldSettings& settings_;
  std::vector<NamedFirstContact>& to_;
};

}  // namespace

std::optional<RigidContact> contact_in_motion(const MovedShape& a, const MovedShape& b,
                                              const RigidContactSettings& settings) {
  if (!is_endless(a.shape) && !is_endless(b.shape)) {
    const Aabb box_a = bounding_aabb({a.shape, a.motion.start()});
    const Aabb box_b = bounding_aabb({b.shape, b.motion.start()});
    const double travel = longest_travel(a.motion, box_a) + longest_travel(b.motion, box_b);
    if (widest_gap(box_a, box_b) > (travel + settings.clearance) * 1.001 + kRoom)
      return RigidContact{RigidStatus::Free, 1, 1, false};
  }
  try {
    return first_contact({a.shape, a.motion}, {b.shape, b.motion}, settings);
  } catch (const PoseError&) {
    return std::nullopt;
  } catch (const UnsupportedPairError&) {
    return std::nullopt;
  }
}

/// Of what does not turn any point goes straight; a part then counts as near its own place.
RigidMotion motion_of_part(const RigidMotion& body, const Pose& start) {
  return RigidMotion(start, {.centre = body.angle() != 0 ? body.centre() : start.translation(),
                             .shift = body.shift(),
                             .axis = body.axis(),
                             .angle = body.angle()});
}

void sort_by_name(std::vector<NamedFirstContact>& contacts) {
  const auto key = [](const NamedFirstContact& each) {
    return std::tuple(each.pair, each.contact.contact.low, each.contact.part_a,
                      each.contact.part_b);
  };
  std::stable_sort(
      contacts.begin(), contacts.end(),
      [&](const NamedFirstContact& s, const NamedFirstContact& t) { return key(s) < key(t); });
}

bool are_equal(const NamedFirstContact& found, const NamedFirstContact& truth) {
  const BodyFirstContact &s = found.contact, &t = truth.contact;
  const bool is_same_place =
      s.normal == t.normal || (truth.is_alike && s.normal == Vector3d(-t.normal));
  return found.pair == truth.pair && s.part_a == t.part_a && s.part_b == t.part_b &&
         s.contact == t.contact && s.is_at_start == t.is_at_start && is_same_place &&
         s.point == t.point;
}

std::string told(const NamedFirstContact& contact) {
  const BodyFirstContact& of = contact.contact;
  return " " + std::to_string(contact.pair.first) + "/" + std::to_string(contact.pair.second) +
         ", parts " + std::to_string(of.part_a) + "/" + std::to_string(of.part_b) + ", at " +
         std::to_string(of.contact.low);
}

std::vector<NamedFirstContact> all_first_contacts(const Oracle& oracle,
                                                  const WorldSettings& settings) {
  std::vector<NamedFirstContact> all;
  std::vector<MovedBody> bodies;
  for (const auto& [name, being] : oracle.beings())
    bodies.push_back(in_motion(name, being));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const MovedBody &a = bodies[i], &b = bodies[j];
      if (!is_swept(a.being) && !is_swept(b.being)) continue;
      if (oracle.may_meet({a.name, b.name}))
        FirstContactsOfPair(oracle, a, b, settings, all).add_all();
    }
  }
  sort_by_name(all);
  return all;
}

}  // namespace graze::tests
