#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/volume_query.h>
#include <graze/engine/world/contacts/sides/body_side.h>
#include <graze/engine/world/shapes/placed_core.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace graze {

using narrowphase::Core;
using narrowphase::CoreKind;
using narrowphase::Vec3;

namespace {

// Triangles nearer to a point than this share of the coordinates go through it.
constexpr double kThrough = 1e-9;
double tolerance_of(double size) {
  return std::max(kThrough * size, 0x1p-1000);
}

// The nearest points of a body and a surface are each known to kTouchTolerance of the scale. If
// they are 128 times as far apart, their direction is known to 2^-6. Points inside the body are as
// clear of the surface, so that they are on the body's side, wherever its nearest point was found.
constexpr double kClear = 128 * kTouchTolerance;

// Where only a point that is inside for certain is asked, rounding is all that counts. By law 7 the
// point of a surface nearest to a given point is off by 2 units of rounding of the coordinates,
// 2^-51 of them. A point that is 2^-44 of them away is seen in its direction to 2^-6.
constexpr double kRounded = 0x1p-44;

/// Returns the directions from a point that a triangle through it covers, as the angle between
/// them. A corner or an edge no farther from the point than `tolerance` goes through it.
double angle_at(const Triangle& triangle, const Vec3& point, double tolerance) {
  const Vec3 corner[3] = {to_vec3(triangle.a) - point, to_vec3(triangle.b) - point,
                          to_vec3(triangle.c) - point};
  for (int k = 0; k < 3; ++k) {
    if (length(corner[k]) > tolerance) continue;
    const Vec3 one = corner[(k + 1) % 3] - corner[k], other = corner[(k + 2) % 3] - corner[k];
    return std::atan2(length(cross(one, other)), dot(one, other));
  }
  for (int k = 0; k < 3; ++k) {
    const Vec3 along = unit_or(corner[(k + 1) % 3] - corner[k], {0, 0, 0});
    if (length(cross(along, corner[k])) <= tolerance) return std::numbers::pi;
  }
  return 2 * std::numbers::pi;
}

/// Returns a bound of the coordinates of a placed shape, up to a factor of 2.
double largest_coordinate(const PlacedShapeView& placed) {
  if (const Mesh* mesh = placed.shape.as<Mesh>()) {
    const std::array<double, 3> most = largest_coordinates(placed.pose, mesh->bounds());
    return std::max({most[0], most[1], most[2]});
  }
  const Eigen::Vector3d middle = middle_of(placed.shape, placed.pose);
  const Core core = core_of(placed.shape, placed.pose, middle);
  return largest(to_vec3(middle)) + core.bounding_radius + core.radius;
}

/// A surface with fronts and backs, seen from points that are not on it.
class Surface {
 public:
  /// No coordinate of the surface and of points is greater than `scale`, metres.
  Surface(const PlacedMeshView& mesh, double scale, Work& work)
      : mesh_(mesh), scale_(scale), work_(work) {}

  /// True if a point is behind, whose nearest point on the surface is given: the sum of the normals
  /// around that point, each by the angle that its triangle has there, decides, whatever the
  /// tessellation. Baerentzen and Aanaes, "Signed distance computation using the angle weighted
  /// pseudonormal", IEEE Transactions on Visualization and Computer Graphics 11, 2005.
  bool is_behind(const Eigen::Vector3d& nearest, const Vec3& to_point) const {
    double tolerance = tolerance_of(largest(to_vec3(nearest)) + length(to_point));
    TriangleList around = find_triangles(mesh_, Sphere{nearest, tolerance}, {}, &work_);
    if (around.empty()) {
      tolerance = tolerance_of(scale_);
      around = find_triangles(mesh_, Sphere{nearest, tolerance}, {}, &work_);
    }
    Vec3 front{0, 0, 0};
    for (const std::uint32_t index : around.triangles) {
      const Triangle placed = narrowphase::place(mesh_.pose, mesh_.mesh.triangle(index));
      const Vec3 corner = to_vec3(placed.a);
      const Vec3 normal =
          unit_or(cross(to_vec3(placed.b) - corner, to_vec3(placed.c) - corner), {0, 0, 0});
      front = front + normal * angle_at(placed, to_vec3(nearest), tolerance);
    }
    return dot(front, to_point) < 0;
  }

  /// Says whether a point is behind, if it is farther from the surface than that share of the
  /// scale.
  std::optional<bool> is_behind(const Vec3& point, double share) const {
    const NearestPoint nearest = nearest_point(mesh_, to_eigen(point), &work_);
    if (nearest.distance <= share * scale_) return std::nullopt;
    return is_behind(nearest.point, point - to_vec3(nearest.point));
  }

 private:
  const PlacedMeshView& mesh_;
  double scale_;
  Work& work_;
};

/// A convex body does not go through the surface. So it is on the side of any of its points, which
/// lie between its nearest point and an inner one. The first that is clear of the surface decides.
std::optional<bool> is_convex_behind(const PlacedShapeView& body, const Vec3& nearest,
                                     const Surface& surface) {
  const Vec3 inner = to_vec3(inner_point(body));
  for (double share = 0x1p-16; share < 1; share *= 4) {
    const Vec3 point = nearest + (inner - nearest) * share;
    if (const std::optional<bool> found = surface.is_behind(point, kClear)) return found;
  }
  return surface.is_behind(inner, kRounded);
}

/// A closed mesh is on the side of any point that it encloses. Such points are sought on both sides
/// of its triangles around the nearest point, as it may be inside out.
std::optional<bool> is_solid_behind(const PlacedMeshView& body, const Vec3& nearest, double scale,
                                    const Surface& surface, Work& work) {
  const Sphere around{to_eigen(nearest), tolerance_of(scale)};
  for (const std::uint32_t index : find_triangles(body, around, {}, &work).triangles) {
    const Triangle placed = narrowphase::place(body.pose, body.mesh.triangle(index));
    const Vec3 a = to_vec3(placed.a), b = to_vec3(placed.b), c = to_vec3(placed.c);
    const Vec3 to_middle = (a - nearest + (b - nearest) + (c - nearest)) * (1. / 3);
    const Vec3 normal = unit_or(cross(b - a, c - a), {0, 0, 0});
    for (double share = 0x1p-12; share <= 0x1p-4; share *= 16) {
      for (const double side : {-1., 1.}) {
        const double height = 0.25 * side * share * length(to_middle);
        const Vec3 point = nearest + to_middle * share + normal * height;
        if (!contains(body, to_eigen(point), &work)) continue;
        if (const std::optional<bool> found = surface.is_behind(point, kRounded)) return found;
      }
    }
  }
  return std::nullopt;
}

/// A mesh that is not closed is on the side of the corners of its nearest triangle, if all of them
/// are on one side of the plane of the triangle that is nearest to it.
std::optional<bool> is_surface_behind(const PlacedMeshView& body, const PlacedMeshView& mesh,
                                      Work& work) {
  const TrianglePair pair = distance(body, mesh, {}, &work).pair;
  const Triangle plane = narrowphase::place(mesh.pose, mesh.mesh.triangle(pair.b));
  const Triangle other = narrowphase::place(body.pose, body.mesh.triangle(pair.a));
  bool is_below = false, is_above = false;
  for (const Eigen::Vector3d* corner : {&other.a, &other.b, &other.c}) {
    const narrowphase::Sign sign =
        narrowphase::orientation_3d(plane.a.data(), plane.b.data(), plane.c.data(), corner->data());
    is_below = is_below || sign == narrowphase::Sign::Negative;
    is_above = is_above || sign == narrowphase::Sign::Positive;
  }
  if (is_below == is_above) return std::nullopt;
  return is_below;
}

}  // namespace

Eigen::Vector3d inner_point(const PlacedShapeView& body) {
  Eigen::Vector3d middle = middle_of(body.shape, body.pose);
  const Core core = core_of(body.shape, body.pose, middle);
  if (core.kind != CoreKind::Points) return middle;
  Vec3 sum{0, 0, 0};
  for (std::size_t i = 0; i < core.point_count; ++i)
    sum = sum + core.points[i] * (1 / static_cast<double>(core.point_count));
  return in_world(turned(core, sum), middle);
}

bool is_behind(const PlacedShapeView& body, const PlacedMeshView& mesh,
               const ShapeDistance& nearest, Work& work) {
  const Vec3 point = to_vec3(nearest.point_a);
  const double scale = largest_coordinate(body) + largest_coordinate({mesh.mesh, mesh.pose});
  const Surface surface(mesh, scale, work);
  if (nearest.distance > kClear * scale)
    return surface.is_behind(nearest.point_b, point - to_vec3(nearest.point_b));
  std::optional<bool> found;
  const Mesh* body_mesh = body.shape.as<Mesh>();
  if (body_mesh == nullptr) {
    found = is_convex_behind(body, point, surface);
  } else if (body_mesh->topology().is_closed) {
    found = is_solid_behind({*body_mesh, body.pose}, point, scale, surface, work);
  } else {
    found = is_surface_behind({*body_mesh, body.pose}, mesh, work);
  }
  return found ? *found : surface.is_behind(nearest.point_b, -to_vec3(nearest.normal));
}

}  // namespace graze
