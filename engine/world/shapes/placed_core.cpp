#include <graze/engine/world/shapes/hull_data.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/convex/core/hull.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <cmath>

namespace graze {

using narrowphase::Core;
using narrowphase::CoreKind;
using narrowphase::Vec3;

namespace {

Vec3 column(const Pose& pose, int k) {
  const double* m = pose.data();  // column-major 4x4
  return {m[4 * k], m[4 * k + 1], m[4 * k + 2]};
}

Core turned_by(const Pose& pose, CoreKind kind) {
  Core core;
  core.kind = kind;
  for (int k = 0; k < 3; ++k)
    core.axis[k] = column(pose, k);
  return core;
}

// Lengths grow by less than this where a pose deviates from a rotation, and by rounding.
constexpr double kStretch = 1 + 4 * kMaxRotationDeviation;

class CoreOf {
 public:
  CoreOf(const Pose& pose, const Vec3& at) : pose_(pose), at_(at) {}

  Core operator()(const Sphere& sphere) const {
    Core core = at(CoreKind::Point, 0);
    core.radius = sphere.radius;
    return core;
  }
  Core operator()(const Box& box) const {
    Core core = at(CoreKind::Box, length(to_vec3(box.half_extents)));
    core.half = to_vec3(box.half_extents);
    return core;
  }
  Core operator()(const Capsule& capsule) const {
    if (capsule.half_length == 0) return (*this)(Sphere{{0, 0, 0}, capsule.radius});
    Core core = at(CoreKind::Segment, capsule.half_length);
    core.half.z = capsule.half_length;
    core.radius = capsule.radius;
    return core;
  }
  Core operator()(const Cylinder& cylinder) const {
    return round(CoreKind::Cylinder, cylinder.radius, cylinder.half_height);
  }
  Core operator()(const Cone& cone) const {
    return round(CoreKind::Cone, cone.radius, cone.half_height);
  }
  Core operator()(const Ellipsoid& ellipsoid) const {
    Core core = at(CoreKind::Ellipsoid, largest(to_vec3(ellipsoid.semi_axes)));
    core.half = to_vec3(ellipsoid.semi_axes);
    return core;
  }
  Core operator()(const ConvexHull& hull) const {
    const narrowphase::Hull& data = data_of(hull);
    Core core = at(CoreKind::Points, data.bounding_radius);
    core.hull = &data;
    core.points = data.corners.data();
    core.point_count = data.corners.size();
    return core;
  }
  Core operator()(const HalfSpace&) const { throw InputError("half-space: it has no core"); }
  Core operator()(const graze::Plane&) const { throw InputError("plane: it has no core"); }
  Core operator()(const Mesh&) const { throw InputError("mesh: it has no core"); }
  Core operator()(const HeightField&) const { throw InputError("height field: it has no core"); }

 private:
  Core at(CoreKind kind, double bounding_radius) const {
    Core core = turned_by(pose_, kind);
    core.at = at_;
    core.bounding_radius = bounding_radius * kStretch;
    return core;
  }
  Core round(CoreKind kind, double radius, double half_height) const {
    Core core = at(kind, length(Vec3{radius, 0, half_height}));
    core.half = {radius, 0, half_height};
    return core;
  }

  const Pose& pose_;
  Vec3 at_;
};

}  // namespace

bool is_convex_core(ShapeKind kind) {
  using enum ShapeKind;
  return kind != HalfSpace && kind != Plane && kind != Mesh && kind != HeightField;
}

Eigen::Vector3d middle_of(const Shape& shape, const Pose& pose) {
  if (const auto* sphere = shape.as<Sphere>()) return narrowphase::place(pose, sphere->centre);
  if (const auto* ellipsoid = shape.as<Ellipsoid>())
    return narrowphase::place(pose, ellipsoid->centre);
  if (const auto* hull = shape.as<ConvexHull>())
    return narrowphase::place(pose, to_eigen(data_of(*hull).middle));
  const double* m = pose.data();
  return {m[12], m[13], m[14]};
}

Core core_of(const Shape& shape, const Pose& pose, const Eigen::Vector3d& origin) {
  const Vec3 at = to_vec3(middle_of(shape, pose)) - to_vec3(origin);
  return std::visit(CoreOf(pose, at), shape.value());
}

Core core_of(const Triangle& placed, const Eigen::Vector3d& origin) {
  Core core;
  core.kind = CoreKind::Triangle;
  const Vec3 o = to_vec3(origin);
  core.corner[0] = to_vec3(placed.a) - o;
  core.corner[1] = to_vec3(placed.b) - o;
  core.corner[2] = to_vec3(placed.c) - o;
  core.at = core.corner[0];
  const double b = length(core.corner[1] - core.at);
  const double c = length(core.corner[2] - core.at);
  core.bounding_radius = b > c ? b : c;
  return core;
}

// The plane goes through o = R (offset n) + t. The coordinates of o are off by 5 u of the sizes of
// what is summed up, and its dot product of 3 terms with a unit vector by as much again.
PlacedHalfSpace placed_half_space(const HalfSpace& half_space, const Pose& pose,
                                  const Eigen::Vector3d& origin) {
  const Core turn = turned_by(pose, CoreKind::Point);
  const Vec3 normal = unit_or(narrowphase::turned(turn, to_vec3(half_space.normal)), {0, 0, 1});
  const double* m = pose.data();
  const Vec3 from_origin = Vec3{m[12], m[13], m[14]} - to_vec3(origin);
  const double shift = dot(normal, from_origin);
  const double size = std::abs(half_space.offset) + 2 * largest(from_origin);
  return {normal, half_space.offset + shift, 0x20p-53 * size};
}

}  // namespace graze
