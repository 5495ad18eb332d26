// Finds which bodies of two worlds, or of one, touch or are near each other.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/world/bodies/nearest_bodies.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/voxel_map.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>

namespace graze {
namespace {

bool is_nearer(const BodyPairDistance& s, const BodyPairDistance& t) {
  return std::tie(s.distance.distance, s.a, s.b) < std::tie(t.distance.distance, t.a, t.b);
}

/// True if two posed bodies, or any two parts of them that may meet, share a point.
bool do_touch(const PosedBody& a, const PosedBody& b) {
  bool is_hit = false;
  for_part_pairs(a, b, [&](const PlacedPart& s, const PlacedPart& t) {
    is_hit = nearness_of(s, t, {}) == Nearness::Touching;
    return !is_hit;
  });
  return is_hit;
}

const Shape& known_shape(const BodyShape& shape, BodyId id) {
  const Shape* known =
      ask_shape(is_users_shape(shape), [&]() -> const Shape* { return shape.shape(); });
  if (known != nullptr) return *known;
  throw UnsupportedPairError(
      "distance to the body with index " + std::to_string(id.index) + ": its shape is a user's own",
      {.element = "body", .index = id.index});
}

/// Finds the nearest two parts, or bodies without parts, that are not farther apart than `most`,
/// the first of equals. Pairs whose boxes are farther apart than the nearest so far need not be
/// measured, because distance() is never less than the distance of boxes.
class NearestParts {
 public:
  NearestParts(const PosedBody& a, BodyId id_a, const PosedBody& b, BodyId id_b)
      : a_(a),
        b_(b),
        whole_a_(as_parts(a.shape)),
        whole_b_(as_parts(b.shape)),
        id_a_(id_a),
        id_b_(id_b) {}

  /// Goes through the parts of one body, nearest first, and searches the other for the part nearest
  /// to each; before that, for the part nearest to a branch of the first or to a block of its
  /// voxels.
  std::optional<BodyPairDistance> find(double most) {
    most_ = std::min(most, kLargestDistance);
    const bool is_a_gone_through = whole_b_ == nullptr || voxel_map_of(a_.shape) != nullptr ||
                                   voxel_map_of(b_.shape) == nullptr;
    if (whole_a_ == nullptr) {
      ask_part_of_a({&a_.shape, a_.pose, box_with_room(a_), nullptr, 0});
    } else if (is_a_gone_through) {
      go_through(*whole_a_, a_, b_, [&](const PlacedPart& part) { ask_part_of_a(part); });
    } else {
      go_through(*whole_b_, b_, a_, [&](const PlacedPart& part) { ask_part_of_b(part); });
    }
    return best_;
  }

 private:
  double limit() const { return best_ ? std::min(best_->distance.distance, most_) : most_; }

  /// Goes through parts as nearest_part() does: parts in a growing box around the other. The parts
  /// of the other that are near a branch or block are searched before anything in that is.
  template <typename Ask>
  void go_through(const PartsBody& whole, const PosedBody& own, const PosedBody& other,
                  const Ask& ask_part) {
    const Aabb around = box_with_room({other.shape, other.pose}), box = whole.bounds(own.pose);
    const double apart = gap_between(box, around).gap;
    if (apart > most_) return;
    const std::function<double(const PlacedShapeView&, double)> gap_to_box =
        [&](const PlacedShapeView& placed, double limit) {
          return least_gap(placed, *as_parts(other.shape), other.pose, limit);
        };
    PartSeeker seeker{around, 0, most_};
    if (as_parts(other.shape) != nullptr) seeker.gap_to_box = &gap_to_box;
    const double widest = 4 * (width_of(box) + width_of(around));
    const auto ask = [&](const PlacedPart& part) {
      ask_part(part);
      return limit();
    };
    for (double width = 0x1p-6 * whole.extent();; width *= 4) {
      seeker.search_radius = std::min(apart + width, most_);
      const bool is_all = width >= widest || seeker.search_radius >= most_;
      best_.reset();
      whole.visit_nearest(own.pose, seeker, std::cref(ask));
      if (is_all || limit() <= seeker.search_radius) return;
      if (best_) width = std::max(width, (limit() - apart) / 4);
    }
  }

  /// True if a part of A comes after a part that touches B, so that none of its pairs is the first.
  bool is_late(const PlacedPart& part) const {
    return best_ && best_->distance.distance == 0 && part.number > best_->part_a;
  }

  /// Measures a part of A, or all of it, and the nearest part of B.
  void ask_part_of_a(const PlacedPart& part) {
    if (is_late(part)) return;
    const Shape& shape = known_shape(*part.shape, id_a_);
    if (whole_b_ == nullptr) {
      const PlacedPart alone{&b_.shape, b_.pose, {}, nullptr, 0};
      if (!do_parts_meet(a_, part, b_, alone)) return;
      take(distance({shape, part.pose}, {known_shape(b_.shape, id_b_), b_.pose}), part.number, 0);
      return;
    }
    const auto nearest =
        nearest_part({shape, part.pose}, *whole_b_, b_.pose, limit(),
                     [&](const PlacedPart& other) { return do_parts_meet(a_, part, b_, other); });
    if (nearest) take(nearest->distance, part.number, nearest->part);
  }

  /// Measures a part of B and the nearest part of A. A distance is the same to the last bit when it
  /// is asked for the other way round (law 4).
  void ask_part_of_b(const PlacedPart& part) {
    const PlacedShapeView placed{*part.shape->shape(), part.pose};
    const auto nearest =
        nearest_part(placed, *whole_a_, a_.pose, limit(), [&](const PlacedPart& other) {
          return !is_late(other) && do_parts_meet(a_, other, b_, part);
        });
    if (!nearest || !is_first(nearest->distance.distance, nearest->part, part.number)) return;
    const PlacedPart of_a = whole_a_->placed(a_.pose, nearest->part);
    take(distance({*of_a.shape->shape(), of_a.pose}, placed), of_a.number, part.number);
  }

  /// True if the distance is the least so far, and the pair the first of equals.
  bool is_first(double distance, std::uint32_t part_a, std::uint32_t part_b) const {
    if (distance > most_) return false;
    return !best_ || std::tuple(distance, part_a, part_b) <
                         std::tuple(best_->distance.distance, best_->part_a, best_->part_b);
  }

  void take(const ShapeDistance& found, std::uint32_t part_a, std::uint32_t part_b) {
    if (is_first(found.distance, part_a, part_b)) best_ = {id_a_, id_b_, found, part_a, part_b};
  }

  const PosedBody& a_;
  const PosedBody& b_;
  const PartsBody* whole_a_;
  const PartsBody* whole_b_;
  BodyId id_a_;
  BodyId id_b_;
  double most_ = kLargestDistance;
  std::optional<BodyPairDistance> best_;
};

}  // namespace

/// The bodies of another world, each in its pose in the world of A.
class World::OtherBodies {
 public:
  OtherBodies(const State& state, const PlacedWorldView& other, const WorldPairSettings& settings)
      : state_(state), other_(*other.world.state_), pose_(other.pose), settings_(settings) {
    check_pose(other.pose, "pose of the other world");
  }

  /// Calls `visit(index, posed, box, query)` for each body that is asked for, ascending: `query`
  /// says which bodies of A it may meet.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (std::uint32_t index = 0; index < other_.all.bodies.size(); ++index) {
      if (!other_.all.ids.is_live(index)) continue;
      const Bodies::Body& body = other_.all.bodies[index];
      if (settings_.role && *settings_.role != body.role) continue;
      const Pose pose = placed_part(pose_, body.pose);
      const Aabb box =
          bounds_of(*body.shape, body.is_users, pose, 0, "pose of a body of the other world");
      std::optional<Filter> filter;
      if (settings_.has_filters) filter = body.filter;
      visit(index, PosedBody{*body.shape, pose, 0, filter, settings_.has_filters}, box,
            BodyQuerySettings{.filter = filter, .role = settings_.role});
    }
  }

  /// Returns a body of A, without its room.
  PosedBody own(std::uint32_t index) const {
    const Bodies::Body& body = state_.all.bodies[index];
    std::optional<Filter> filter;
    if (settings_.has_filters) filter = body.filter;
    return {*body.shape, body.pose, 0, filter, settings_.has_filters};
  }

  BodyId id(std::uint32_t index) const { return other_.all.id(index); }

 private:
  const State& state_;
  const State& other_;
  const Pose& pose_;
  const WorldPairSettings& settings_;
};

std::vector<WorldBodyPair> World::find_touching(const PlacedWorldView& other,
                                                const WorldPairSettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<WorldBodyPair> {
    std::vector<WorldBodyPair> touching;
    const OtherBodies bodies(*state_, other, settings);
    bodies.for_each([&](std::uint32_t index, const PosedBody& posed, const Aabb& box,
                        const BodyQuerySettings& query) {
      for (const std::uint32_t own : state_->find_bodies(box, query)) {
        if (do_touch(bodies.own(own), posed))
          touching.push_back({state_->all.id(own), bodies.id(index)});
      }
    });
    std::sort(touching.begin(), touching.end());
    return touching;
  });
}

std::vector<BodyPairDistance> World::find_within(const PlacedWorldView& other, double clearance,
                                                 const WorldPairSettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::vector<BodyPairDistance> {
    if (!(clearance >= 0 && clearance <= kLargestDistance))
      throw InputError("find_within: the clearance is " + bvh::number_text(clearance) +
                       ", but must be finite and not negative");
    std::vector<BodyPairDistance> near;
    const OtherBodies bodies(*state_, other, settings);
    bodies.for_each([&](std::uint32_t index, const PosedBody& posed, const Aabb& box,
                        const BodyQuerySettings& query) {
      for (const std::uint32_t own : state_->find_bodies(grown(box, clearance), query)) {
        const PosedBody a = bodies.own(own);
        const auto found =
            NearestParts(a, state_->all.id(own), posed, bodies.id(index)).find(clearance);
        if (found) near.push_back(*found);
      }
    });
    std::sort(near.begin(), near.end(), [](const BodyPairDistance& s, const BodyPairDistance& t) {
      return std::tie(s.a, s.b) < std::tie(t.a, t.b);
    });
    return near;
  });
}

std::optional<BodyPairDistance> World::find_closest(const PlacedWorldView& other,
                                                    const WorldPairSettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::optional<BodyPairDistance> {
    std::optional<BodyPairDistance> best;
    const auto least = [&] { return best ? best->distance.distance : kBeyondAll; };
    const OtherBodies bodies(*state_, other, settings);
    bodies.for_each([&](std::uint32_t index, const PosedBody& posed, const Aabb& box,
                        const BodyQuerySettings& query) {
      if (!state_->asks_for_any(query)) return;
      state_->for_nearest({box, posed.pose}, query, least(), [&](std::uint32_t own) {
        const PosedBody a = bodies.own(own);
        const auto found =
            NearestParts(a, state_->all.id(own), posed, bodies.id(index)).find(least());
        if (found && (!best || is_nearer(*found, *best))) best = found;
        return least();
      });
    });
    return best;
  });
}

std::optional<BodyPairDistance> World::find_closest_pair(const WorldPairSettings& settings) const {
  return bvh::in_standard_arithmetic([&]() -> std::optional<BodyPairDistance> {
    const Bodies& all = state_->all;
    std::optional<BodyPairDistance> best;
    const auto least = [&] { return best ? best->distance.distance : kBeyondAll; };
    const auto posed = [&](std::uint32_t index) {
      const Bodies::Body& body = all.bodies[index];
      std::optional<Filter> filter;
      if (settings.has_filters) filter = body.filter;
      return PosedBody{*body.shape, body.pose, 0, filter, settings.has_filters};
    };
    for (std::uint32_t index = 0; index < all.bodies.size(); ++index) {
      if (!all.ids.is_live(index)) continue;
      const BodyQuerySettings query{.filter = {}, .role = settings.role};
      if (!state_->is_asked_for(index, query)) continue;
      const PosedBody a = posed(index);
      const Aabb box = box_with_room(a);
      state_->for_nearest({box, a.pose}, query, least(), [&](std::uint32_t other) {
        if (other <= index || !(settings.has_filters ? all.may_meet(index, other) : true))
          return least();
        const PosedBody b = posed(other);
        const auto found = NearestParts(a, all.id(index), b, all.id(other)).find(least());
        if (found && (!best || is_nearer(*found, *best))) best = found;
        return least();
      });
    }
    return best;
  });
}

}  // namespace graze
