#include <graze/engine/world/body_shapes/part_pairs.h>
#include <graze/engine/world/body_shapes/users_shape.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shapes/pair_input.h>
#include <graze/engine/world/shapes/shape_work.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace graze {
namespace {

/// Returns `question(shape)` for a part, computed in the floating-point settings of the shape's
/// author.
template <typename Question>
auto ask(const PlacedPart& part, const Question& question) {
  return ask_shape(is_users_shape(*part.shape), [&] { return question(*part.shape); });
}

const Shape* known_shape(const PlacedPart& part) {
  return ask(part, [](const BodyShape& shape) { return shape.shape(); });
}

bool do_touch(const PlacedPart& a, const PlacedPart& b) {
  return ask(a, [&](const BodyShape& s) { return s.touches(a.pose, *b.shape, b.pose); });
}

}  // namespace

Aabb box_with_room(const PosedBody& body) {
  const Aabb box =
      ask_shape(is_users_shape(body.shape), [&] { return body.shape.bounds(body.pose); });
  return body.room > 0 ? grown(box, body.room) : box;
}

std::vector<PlacedPart> parts_near(const PosedBody& body, const Aabb& box) {
  if (const PartsBody* whole = as_parts(body.shape)) return whole->near(body.pose, box, body.room);
  if (!share_a_point(box_with_room(body), box)) return {};
  return {{&body.shape, body.pose, box_with_room({body.shape, body.pose}), nullptr, 0}};
}

bool visit_parts_near(const PosedBody& body, const Aabb& box,
                      const std::function<bool(const PlacedPart&)>& visit) {
  if (const PartsBody* whole = as_parts(body.shape))
    return whole->visit_near(body.pose, box, body.room, visit);
  const std::vector<PlacedPart> parts = parts_near(body, box);
  return std::all_of(parts.begin(), parts.end(), visit);
}

bool do_parts_meet(const PosedBody& a, const PlacedPart& part_a, const PosedBody& b,
                   const PlacedPart& part_b) {
  if (!a.has_filters || !b.has_filters) return true;
  if (part_a.filter == nullptr && part_b.filter == nullptr) return true;
  const Filter* of_a = part_a.filter != nullptr ? part_a.filter : a.filter ? &*a.filter : nullptr;
  const Filter* of_b = part_b.filter != nullptr ? part_b.filter : b.filter ? &*b.filter : nullptr;
  return of_a == nullptr || of_b == nullptr || lets_pass(*of_a, *of_b);
}

Nearness nearness_of(const PlacedPart& a, const PlacedPart& b, const ManifoldSettings& settings) {
  const Shape *of_a = known_shape(a), *of_b = known_shape(b);
  const bool is_plain = are_plain(settings);
  if (of_a != nullptr && of_b != nullptr) {
    if (!is_plain) return nearness({*of_a, a.pose}, {*of_b, b.pose}, settings, shape_work());
    const bool is_hit = intersect_in_boxes({*of_a, a.pose}, {*of_b, b.pose}, shape_work());
    return is_hit ? Nearness::Touching : Nearness::Apart;
  }
  if (do_touch(a, b)) return Nearness::Touching;
  if (is_plain) return Nearness::Apart;
  const Manifold found = ask(a, [&](const BodyShape& s) {
    return s.contacts_within(a.pose, *b.shape, b.pose, settings.margin);
  });
  return found.empty() ? Nearness::Apart : Nearness::Near;
}

Nearness contacts_of(const PlacedPart& a, const PlacedPart& b, const ManifoldSettings& settings,
                     Manifold& found) {
  const Shape *of_a = known_shape(a), *of_b = known_shape(b);
  const bool is_plain = are_plain(settings);
  if (of_a != nullptr && of_b != nullptr) {
    if (!is_plain)
      return contacts_within({*of_a, a.pose}, {*of_b, b.pose}, settings, shape_work(), found);
    contacts_in_boxes({*of_a, a.pose}, {*of_b, b.pose}, shape_work(), found);
    return found.empty() ? Nearness::Apart : Nearness::Touching;
  }
  const Nearness nearness = nearness_of(a, b, settings);
  found.clear();
  if (nearness == Nearness::Apart) return nearness;
  found = ask(a, [&](const BodyShape& s) {
    return is_plain ? s.contacts(a.pose, *b.shape, b.pose)
                    : s.contacts_within(a.pose, *b.shape, b.pose, settings.margin);
  });
  return nearness;
}

namespace {

/// Keeps the nearest part so far that may meet a shape and is not farther than `most`.
struct NearestPart {
  const PlacedShapeView& shape;
  double most;
  const std::function<bool(const PlacedPart&)>& may_meet;
  std::optional<PartDistance> best = {};

  void reset() { best.reset(); }
  double limit() const { return best ? best->distance.distance : most; }
  void take(const PlacedPart& part) {
    if (!may_meet(part)) return;
    const ShapeDistance found = distance(shape, {*part.shape->shape(), part.pose}, &shape_work());
    const bool is_nearer = best ? std::pair(found.distance, part.number) <
                                      std::pair(best->distance.distance, best->part)
                                : found.distance <= most;
    if (is_nearer) best = {found, part.number};
  }
};

/// Keeps the length than which no part so far is nearer. A distance counts only as far as it is
/// proved.
struct LeastGap {
  const PlacedShapeView& shape;
  double most;
  double least = std::numeric_limits<double>::infinity();

  void reset() { least = std::numeric_limits<double>::infinity(); }
  double limit() const { return std::min(least, most); }
  void take(const PlacedPart& part) {
    const ShapeDistance found = distance(shape, {*part.shape->shape(), part.pose}, &shape_work());
    least = std::min(least, found.lower_bound);
  }
};

// Looks at the parts in a box around the shape that grows until the nearest part is nearer than all
// outside can be.
template <typename Nearest>
void look_around(const PlacedShapeView& shape, const PartsBody& whole, const Pose& pose,
                 double most, Nearest& nearest) {
  const Aabb own = bounding_aabb(shape), bounds = whole.bounds(pose);
  const double widest = 4 * (width_of(bounds) + width_of(own));
  const double apart = gap_between(own, bounds).gap;
  if (apart > most) return;
  const auto ask = [&](const PlacedPart& part) {
    nearest.take(part);
    return nearest.limit();
  };
  for (double width = 0x1p-6 * whole.extent();; width *= 4) {
    const bool is_all = width >= widest || apart + width >= most;
    const double search_radius = std::min(apart + width, most);
    nearest.reset();
    whole.visit_nearest(pose, {own, search_radius, most, &shape}, std::cref(ask));
    const double limit = nearest.limit();
    if (is_all || (limit < most && limit <= search_radius)) return;
    if (limit < most) width = std::max(width, (limit - apart) / 4);
  }
}

}  // namespace

std::optional<PartDistance> nearest_part(const PlacedShapeView& shape, const PartsBody& whole,
                                         const Pose& pose, double most,
                                         const std::function<bool(const PlacedPart&)>& may_meet) {
  NearestPart nearest{shape, most, may_meet};
  look_around(shape, whole, pose, most, nearest);
  return nearest.best;
}

double least_gap(const PlacedShapeView& shape, const PartsBody& whole, const Pose& pose,
                 double most) {
  LeastGap nearest{shape, most};
  look_around(shape, whole, pose, most, nearest);
  return nearest.least;
}

}  // namespace graze
