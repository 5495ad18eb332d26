#include <graze/bvh/error.h>
#include <graze/engine/compare/judge/rational/rational_box.h>
#include <graze/engine/compare/judge/rational/volume_error.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>

#include <algorithm>
#include <cmath>

namespace graze::compare {
namespace {

/// Returns the error of a ball and something at a distance from its centre.
VolumeError ball_error(const mpq_class& squared_distance, const mpq_class& radius) {
  return {squared_distance <= radius * radius, root_error(radius, squared_distance)};
}

VolumeError error_of(const Sphere& a, const Sphere& b) {
  const RationalPoint offset = minus(exactly(a.centre), exactly(b.centre));
  return ball_error(dot(offset, offset), mpq_class(a.radius) + mpq_class(b.radius));
}

VolumeError error_of(const Sphere& ball, const Aabb& box) {
  mpq_class square = 0;
  std::optional<mpq_class> to_face;  // the way to a face from inside
  for (int axis = 0; axis < 3; ++axis) {
    const mpq_class c = ball.centre[axis];
    const mpq_class below = mpq_class(box.min[axis]) - c;
    const mpq_class above = c - mpq_class(box.max[axis]);
    const mpq_class outside = std::max<mpq_class>({below, above, 0});
    square += outside * outside;
    const mpq_class inside = std::min<mpq_class>(-below, -above);
    if (!to_face || inside < *to_face) to_face = inside;
  }
  if (square > 0) return ball_error(square, ball.radius);
  return {true, mpq_class(mpq_class(ball.radius) + *to_face).get_d()};
}

Sphere in_frame(const Sphere& ball, const Obb& box) {
  return {narrowphase::point_into_frame(ball.centre, box.pose), ball.radius};
}

Aabb frame_box(const Obb& box) {
  return {-box.half_extents, box.half_extents};
}

template <typename A>
VolumeError box_error(const A& a, const RationalBox& b) {
  const std::optional<mpq_class> overlap = squared_overlap(a, b);
  if (overlap) return {true, rounded_root(*overlap)};
  return {false, rounded_root(squared_gap(a, b))};
}

/// Returns the box by both readings of a pose.
std::vector<RationalBox> readings_of(const CaseShape& shape) {
  if (const auto* box = std::get_if<Aabb>(&shape)) return {exactly(*box)};
  if (const auto* box = std::get_if<Obb>(&shape)) return {exactly(*box), exactly_by_frame(*box)};
  return {};
}

}  // namespace

VolumeError volume_error(const Triangle& triangle, const CaseShape& volume) {
  if (const auto* box = std::get_if<Aabb>(&volume))
    return box_error(exactly(triangle), exactly(*box));
  if (const auto* box = std::get_if<Obb>(&volume)) {
    return box_error(exactly(narrowphase::into_frame(triangle, box->pose)),
                     exactly(frame_box(*box)));
  }
  const auto& ball = std::get<Sphere>(volume);
  const Triangle centre{ball.centre, ball.centre, ball.centre};
  return ball_error(squared_distance(exactly(triangle), exactly(centre)), ball.radius);
}

std::optional<VolumeError> volume_error(const CaseShape& shape_a, const CaseShape& shape_b) {
  const auto* ball_a = std::get_if<Sphere>(&shape_a);
  const auto* ball_b = std::get_if<Sphere>(&shape_b);
  if (ball_a != nullptr && ball_b != nullptr) return error_of(*ball_a, *ball_b);
  if (ball_a != nullptr || ball_b != nullptr) {
    const Sphere& ball = ball_a != nullptr ? *ball_a : *ball_b;
    const CaseShape& other = ball_a != nullptr ? shape_b : shape_a;
    if (const auto* box = std::get_if<Aabb>(&other)) return error_of(ball, *box);
    const auto* box = std::get_if<Obb>(&other);
    if (box == nullptr) return std::nullopt;
    return error_of(in_frame(ball, *box), frame_box(*box));
  }
  std::optional<VolumeError> result;
  for (const RationalBox& a : readings_of(shape_a)) {
    for (const RationalBox& b : readings_of(shape_b)) {
      const VolumeError error = box_error(a, b);
      if (result && result->is_hit != error.is_hit) return std::nullopt;
      if (!result) result = error;
    }
  }
  return result;
}

bool is_conservative(const CaseShape& shape_a, const CaseShape& shape_b) {
  const bool has_obb = std::holds_alternative<Obb>(shape_a) || std::holds_alternative<Obb>(shape_b);
  const auto is_box = [](const CaseShape& shape) {
    return std::holds_alternative<Obb>(shape) || std::holds_alternative<Aabb>(shape);
  };
  return has_obb && is_box(shape_a) && is_box(shape_b);
}

double largest_coordinate(const CaseShape& volume) {
  if (const auto* box = std::get_if<Aabb>(&volume))
    return std::max(box->min.cwiseAbs().maxCoeff(), box->max.cwiseAbs().maxCoeff());
  if (const auto* box = std::get_if<Obb>(&volume)) {
    const Eigen::Vector3d projected_radii = box->pose.linear().cwiseAbs() * box->half_extents;
    return (box->pose.translation().cwiseAbs() + projected_radii).maxCoeff();
  }
  const auto* ball = std::get_if<Sphere>(&volume);
  return ball == nullptr ? 0 : ball->centre.cwiseAbs().maxCoeff() + ball->radius;
}

}  // namespace graze::compare
