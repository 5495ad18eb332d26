#include <graze/engine/world/shapes/mesh_descent.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/engine/world/shapes/quick_gap.h>
#include <graze/narrowphase/convex/core/segments.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze {
namespace {

using narrowphase::Core;
using narrowphase::Vec3;

// In what follows dev is kMaxRotationDeviation, to which all poses keep, now and later; D is the
// distance between the frames' origins now, and the scale is D and both bounding radii. While paths
// add up to less than a gap, which is at most D, the origins are less than 2 D apart.
//
// Tests differ from the distance of R x + t, whose points the paths are about, by less than 64 dev
// of the scale:
// - Balls: not at all but for rounding.
// - A ball and a box: law 3 reads the box within 4 dev of its bounding radius of its image, now and
//   later, and the length of R^T v is within 1.6 dev of that of v, which is at most the scale.
// - Two boxes: obb_slack.h. The slack is below 18 dev of the sum of all half extents, which is
//   below 1.74 of the bounding radii, and the test takes A's frame for B's axes: 3.1 dev of 2 D.
// Rounding: differences of origins are off by u of all coordinates, what three products and sums
// make of them and of the sizes by less than 20 u of the scale.
constexpr double kReadingsOfTests = 64 * kMaxRotationDeviation;
constexpr double kRoundings = 0x40p-53;

Vec3 origin_of(const Pose& pose) {
  const double* m = pose.data();  // column-major 4x4
  return {m[12], m[13], m[14]};
}

Vec3 axis_of(const Pose& pose, int k) {
  const double* m = pose.data();
  return {m[4 * k], m[4 * k + 1], m[4 * k + 2]};
}

double apart_as_balls(const Sphere& a, const Vec3& at_a, const Sphere& b, const Vec3& at_b) {
  return length(at_b - at_a) - (a.radius + b.radius);
}

double apart_as_ball_and_box(const Sphere& ball, const Vec3& at, const Box& box, const Pose& pose) {
  const Vec3 from_box = at - origin_of(pose);
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double past = std::abs(dot(axis_of(pose, k), from_box)) - box.half_extents.data()[k];
    if (past > 0) square += past * past;
  }
  return std::sqrt(square) - ball.radius;
}

/// Returns the gap beside the faces of A. Where A turns, B is swept past its faces by as much as
/// B's points are farther from A's origin than A's own: so B's farthest point decides.
double gap_beside_faces(const Box& box_a, const BoundedShape& a, const Box& box_b,
                        const BoundedShape& b, double margin) {
  const Vec3 between = origin_of(b.pose) - origin_of(a.pose);
  const double* half_b = box_b.half_extents.data();
  double apart = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = axis_of(a.pose, i);
    double radius = box_a.half_extents.data()[i];
    for (int j = 0; j < 3; ++j)
      radius += half_b[j] * std::abs(dot(axis, axis_of(b.pose, j)));
    apart = std::max(apart, std::abs(dot(axis, between)) - radius);
  }
  const double sweep = std::max(1.0, (length(between) + b.bounding_radius) / a.bounding_radius);
  return (apart - margin) / (sweep * (1 + 4 * kMaxRotationDeviation));
}

}  // namespace

bool is_gap_quick(PairMethod method) {
  using enum PairMethod;
  return method == ExactSpheres || method == ExactSphereBox || method == BoxAxes ||
         method == MeshVolume;
}

// Two boxes. Beside a face of A, whose outward axis is a: f = |a . T| - h - (the projected radius
// of B along a). When A and B move, T by dT, a by da, |da| <= |dR_A|, the first term loses at most
// |dT| + |da| |T|, the last gains at most (|da| + |dR_B|) r_B, each to a factor 1 + 2 dev. With the
// paths P = |dt| + |dR| r, r the bounding radius, all that is at most P_B + P_A max(1, (D + r_B) /
// r_A). While f is more than the margin the same face shows the test that the two are apart.
double quick_gap(const BoundedShape& a, const BoundedShape& b) {
  const Vec3 origin_a = origin_of(a.pose), origin_b = origin_of(b.pose);
  const double scale = length(origin_b - origin_a) + (a.bounding_radius + b.bounding_radius);
  const double margin =
      kReadingsOfTests * scale + kRoundings * ((largest(origin_a) + largest(origin_b)) + scale);
  const auto *ball_a = a.shape.as<Sphere>(), *ball_b = b.shape.as<Sphere>();
  const auto *box_a = a.shape.as<Box>(), *box_b = b.shape.as<Box>();
  const auto middle = [](const BoundedShape& s) { return to_vec3(middle_of(s.shape, s.pose)); };
  double gap = 0;
  if (ball_a != nullptr && ball_b != nullptr) {
    gap = apart_as_balls(*ball_a, middle(a), *ball_b, middle(b)) - margin;
  } else if (ball_a != nullptr && box_b != nullptr) {
    gap = apart_as_ball_and_box(*ball_a, middle(a), *box_b, b.pose) - margin;
  } else if (box_a != nullptr && ball_b != nullptr) {
    gap = apart_as_ball_and_box(*ball_b, middle(b), *box_a, a.pose) - margin;
  } else if (box_a != nullptr && box_b != nullptr) {
    gap = std::max(gap_beside_faces(*box_a, a, *box_b, b, margin),
                   gap_beside_faces(*box_b, b, *box_a, a, margin));
  }
  return std::max(gap, 0.0);
}

namespace {

/// The largest gap of a triangle from a ball or a box along any direction tried; 0 if there is
/// none.
class Beyond {
 public:
  Beyond(const Core& core, const Core& triangle) : core_(core) {
    for (int i = 0; i < 3; ++i)
      corner_[i] = triangle.corner[i] - core.at;
    offer(unit_or(cross(corner_[1] - corner_[0], corner_[2] - corner_[0]), {}));
    offer(unit_or(narrowphase::nearest_on_triangle(triangle, core.at) - core.at, {}));
    if (core.kind != narrowphase::CoreKind::Box) return;
    for (const Vec3& axis : core.axis)
      offer(axis * (1 - kMaxRotationDeviation));
  }
  double most() const { return most_; }

 private:
  /// Tries a direction, of a length of at most 1.
  void offer(const Vec3& axis) {
    const double a = dot(corner_[0], axis), b = dot(corner_[1], axis), c = dot(corner_[2], axis);
    const double low = std::min(a, std::min(b, c)), high = std::max(a, std::max(b, c));
    const Vec3& half = core_.half;  // 0 for a ball
    const double radius = (std::abs(dot(core_.axis[0], axis)) * half.x +
                           std::abs(dot(core_.axis[1], axis)) * half.y) +
                          (std::abs(dot(core_.axis[2], axis)) * half.z + core_.radius);
    most_ = std::max(most_, std::max(low, -high) - radius);
  }

  const Core& core_;
  Vec3 corner_[3];
  double most_ = 0;
};

}  // namespace

// Triangles that are skipped are in boxes that are further away than the bound.
double mesh_distance_bound(const PlacedShapeView& a, const PlacedShapeView& b, Work& work) {
  const PlacedMeshView mesh{*b.shape.as<Mesh>(), b.pose};
  const Eigen::Vector3d origin = middle_of(a.shape, a.pose);
  const Core core = core_of(a.shape, a.pose, origin);
  MeshDescent descent(mesh, core, origin, work);
  double bound = std::numeric_limits<double>::infinity();
  descent.for_each_within([&] { return bound; },
                          [&](std::uint32_t index) {
                            bound = std::min(bound, Beyond(core, descent.triangle(index)).most());
                            return bound > 0 ? bvh::Walk::Continue : bvh::Walk::Stop;
                          });
  return bound;
}

}  // namespace graze
