#include "tests/engine/special_poses/least_width.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "tests/engine/world/random_shapes.h"

namespace graze::tests {

using Eigen::Vector3d;

namespace {

struct Own {
  Vector3d middle;
  double size;
};

Own of_points(std::span<const Vector3d> points) {
  Vector3d low = points[0], high = points[0];
  for (const Vector3d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3d middle = 0.5 * low + 0.5 * high;
  double size = 0;
  for (const Vector3d& p : points)
    size = std::max(size, (p - middle).norm());
  return {middle, size};
}

std::vector<Vector3d> corners_of(const Shape& shape) {
  std::vector<Vector3d> corners;
  if (const auto* hull = shape.as<ConvexHull>()) {
    for (std::size_t i = 0; i < hull->vertex_count(); ++i)
      corners.push_back(hull->vertex(i));
  }
  return corners;
}

Own own_of(const Shape& shape) {
  const Vector3d origin(0, 0, 0);
  if (const auto* s = shape.as<Sphere>()) return {s->centre, s->radius};
  if (const auto* s = shape.as<Box>()) return {origin, s->half_extents.norm()};
  if (const auto* s = shape.as<Capsule>()) return {origin, s->radius + s->half_length};
  if (const auto* s = shape.as<Cylinder>()) return {origin, std::hypot(s->radius, s->half_height)};
  if (const auto* s = shape.as<Cone>()) return {origin, std::hypot(s->radius, s->half_height)};
  if (const auto* s = shape.as<Ellipsoid>()) return {s->centre, s->semi_axes.maxCoeff()};
  if (const auto* s = shape.as<Mesh>()) return of_points(s->vertices());
  if (shape.kind() == ShapeKind::ConvexHull) return of_points(corners_of(shape));
  return {origin, 0};
}

/// Directions in which the least width of such shapes is likely to lie.
class Special {
 public:
  explicit Special(const PlacedPair& pair) {
    add_axes(pair.pose_a);
    add_axes(pair.pose_b);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        add(pair.pose_a.linear().col(i).cross(pair.pose_b.linear().col(j)));
    }
    add(placed_middle(pair.b, pair.pose_b) - placed_middle(pair.a, pair.pose_a));
    const std::vector<Vector3d> around = directions;
    add_sides(pair.a, pair.pose_a, around);
    add_sides(pair.b, pair.pose_b, around);
  }

  std::vector<Vector3d> directions;

 private:
  void add(const Vector3d& direction) {
    const double size = direction.norm();
    if (!(size > 1e-9)) return;
    directions.emplace_back(direction / size);
    directions.emplace_back(-direction / size);
  }

  void add_axes(const Pose& pose) {
    for (int i = 0; i < 3; ++i)
      add(pose.linear().col(i));
  }

  void add_sides(const Shape& shape, const Pose& pose, const std::vector<Vector3d>& around) {
    if (const auto* cone = shape.as<Cone>()) {
      const Vector3d axis = pose.linear().col(2);
      for (const Vector3d& way : around) {
        const Vector3d aside = way - axis * axis.dot(way);
        if (aside.norm() > 1e-6) {
          add(aside.normalized() * (2 * cone->half_height) + axis * cone->radius);
        }
      }
    }
    const std::vector<Vector3d> corners = corners_of(shape);
    if (corners.size() > 8) return;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (std::size_t j = i + 1; j < corners.size(); ++j) {
        for (std::size_t k = j + 1; k < corners.size(); ++k)
          add(pose.linear() * (corners[j] - corners[i]).cross(corners[k] - corners[i]));
      }
    }
  }
};

/// Steps along the sphere that halve when none of eight ways is better.
LeastWidth refined(const PlacedPair& pair, LeastWidth best, double step) {
  for (int tries = 0; tries < 150 && step > 1e-9; ++tries) {
    const Vector3d s = best.direction.unitOrthogonal();
    const Vector3d t = best.direction.cross(s);
    const double before = best.width;
    const Vector3d from = best.direction;
    for (int k = 0; k < 8; ++k) {
      const double angle =
          k * M_PI / 4 + step;  // turned with each step: valleys have any direction
      const Vector3d tried =
          (from + (s * std::cos(angle) + t * std::sin(angle)) * step).normalized();
      const double width = width_along(pair, tried);
      if (width < best.width) best = {width, tried};
    }
    if (!(best.width < before)) step *= 0.5;
  }
  return best;
}

}  // namespace

double width_along(const PlacedPair& pair, const Vector3d& direction) {
  return reach_along(pair.a, pair.pose_a, direction) + reach_along(pair.b, pair.pose_b, -direction);
}

LeastWidth least_width(const PlacedPair& pair, std::size_t directions,
                       std::initializer_list<Vector3d> hints) {
  for (const auto& [shape, pose, sign] :
       {std::tuple(&pair.a, &pair.pose_a, 1.0), std::tuple(&pair.b, &pair.pose_b, -1.0)}) {
    if (shape->kind() != ShapeKind::HalfSpace) continue;
    const Vector3d out = pose->linear() * shape->as<HalfSpace>()->normal * sign;
    return {width_along(pair, out), out};
  }
  std::vector<LeastWidth> tried;
  const auto offer = [&](const Vector3d& d) { tried.push_back({width_along(pair, d), d}); };
  for (const Vector3d& d : Special(pair).directions)
    offer(d);
  for (const Vector3d& d : hints)
    offer(d);
  const double golden = M_PI * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < directions; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(directions);
    const double flat = std::sqrt(1 - z * z);
    const double angle = golden * static_cast<double>(i);
    offer({flat * std::cos(angle), flat * std::sin(angle), z});
  }
  const std::size_t refine = std::min<std::size_t>(tried.size(), 6);
  const auto end_of_best = tried.begin() + static_cast<std::ptrdiff_t>(refine);
  std::partial_sort(tried.begin(), end_of_best, tried.end(),
                    [](const LeastWidth& s, const LeastWidth& t) { return s.width < t.width; });
  LeastWidth best = tried[0];
  const double spacing = 2 / std::sqrt(static_cast<double>(directions) + 1);
  for (std::size_t i = 0; i < refine; ++i) {
    const LeastWidth found = refined(pair, tried[i], spacing);
    if (found.width < best.width) best = found;
  }
  return best;
}

double size_about_middle(const Shape& shape) {
  return own_of(shape).size;
}

Vector3d placed_middle(const Shape& shape, const Pose& pose) {
  return pose.linear() * own_of(shape).middle + pose.translation();
}

double scale_of(const PlacedPair& pair) {
  const auto above = [](const HalfSpace& plane, const Pose& pose, const Vector3d& point) {
    return std::abs(plane.normal.dot(pose.inverse() * point) - plane.offset);
  };
  const Vector3d at_a = placed_middle(pair.a, pair.pose_a);
  const Vector3d at_b = placed_middle(pair.b, pair.pose_b);
  double between = (at_b - at_a).norm();
  if (const auto* plane = pair.a.as<HalfSpace>()) between = above(*plane, pair.pose_a, at_b);
  if (const auto* plane = pair.b.as<HalfSpace>()) between = above(*plane, pair.pose_b, at_a);
  return size_about_middle(pair.a) + size_about_middle(pair.b) + between;
}

double smaller_size(const PlacedPair& pair) {
  const double size_a = size_about_middle(pair.a), size_b = size_about_middle(pair.b);
  if (size_a == 0 || size_b == 0) return std::max(size_a, size_b);
  return std::min(size_a, size_b);
}

}  // namespace graze::tests
