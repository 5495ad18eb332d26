// Rays at convex shapes in special positions, beside their definitions in numbers of 1000 bits.

#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/shape_ray.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "tests/engine/rays/line_in_shape.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::WidePoint;

constexpr double kRayTolerance = 0x1p-40;  // law 11

struct PlacedShape {
  Shape shape;
  Pose pose;
  double size;  // no point of it is further from its middle
  Vector3d middle;
  double rounding;  // of where the middle comes to lie
};

/// 1 to 1e-17 of the size, now and then much less.
double length(double size, RandomSource& source) {
  const double which = source.integer(0, 5);
  if (which < 3) return size * source.uniform(0.3, 1);
  return size * std::pow(10.0, source.uniform(which == 5 ? -30 : -17, 0));
}

Shape special_shape(ShapeKind kind, double size, RandomSource& source) {
  const double a = length(size, source), b = length(size, source), c = length(size, source);
  const Vector3d centre =
      source.integer(0, 1) == 0 ? Vector3d::Zero().eval() : (source.vector(-1, 1) * size).eval();
  switch (kind) {
    case ShapeKind::Sphere:
      return Sphere{centre, a};
    case ShapeKind::Box:
      return Box{{a, b, c}};
    case ShapeKind::Capsule:
      return Capsule{a, source.integer(0, 7) == 0 ? 0 : b};
    case ShapeKind::Cylinder:
      return Cylinder{a, b};
    case ShapeKind::Cone:
      return Cone{a, b};
    default:
      return Ellipsoid{centre, {a, b, c}};
  }
}

Vector3d centre_of(const Shape& shape) {
  if (const auto* s = shape.as<Sphere>()) return s->centre;
  if (const auto* s = shape.as<Ellipsoid>()) return s->centre;
  return Vector3d::Zero();
}

/// Half the box around the shape, about its centre.
Vector3d half_box(const Shape& shape) {
  Vector3d half;
  for (int k = 0; k < 3; ++k)
    half[k] = tests::reach_along(shape, Vector3d::Unit(k)) - centre_of(shape)[k];
  return half;
}

PlacedShape special_placed(ShapeKind kind, RandomSource& source) {
  const double size = source.integer(0, 2) == 0 ? std::exp2(source.integer(-200, 200)) : 1;
  const Shape shape = special_shape(kind, size, source);
  Pose pose = Pose::Identity();
  if (source.integer(0, 2) == 0) pose = tests::random_pose(3 * size, source);
  const Vector3d centre = centre_of(shape);
  const double moved = centre.cwiseAbs().maxCoeff() + pose.translation().cwiseAbs().maxCoeff();
  return {shape, pose, half_box(shape).norm(), place(pose, centre), 0x10p-53 * moved};
}

/// Of the shape's own frame: corners, points of edges, axes, rims, the middle, any.
Vector3d special_point(const Shape& shape, RandomSource& source) {
  const Vector3d half = half_box(shape);
  Vector3d share = source.lattice_point(-1, 1);
  const double which = source.integer(0, 4);
  if (which == 0) share = source.vector(-1, 1);
  if (which == 1) {  // on the rim of a round one
    const double angle = source.uniform(0, 6.3);
    share = {std::cos(angle), std::sin(angle), source.integer(-1, 1)};
  }
  if (which == 2) {  // on the side of a cone
    const double angle = source.uniform(0, 6.3), w = source.uniform(0, 1);
    share = {w * std::cos(angle), w * std::sin(angle), 1 - 2 * w};
  }
  if (which == 3) share = source.vector(-1, 1).normalized();
  return centre_of(shape) + share.cwiseProduct(half);
}

Vector3d special_direction(const PlacedShape& placed, RandomSource& source) {
  const double which = source.integer(0, 5);
  if (which == 0) return Vector3d::Unit(static_cast<int>(source.integer(0, 2)));
  if (which == 1) return placed.pose.linear().col(static_cast<int>(source.integer(0, 2)));
  if (which == 2) {  // from one special point to another: along sides and axes
    const Vector3d way = placed.pose.linear() * (special_point(placed.shape, source) -
                                                 special_point(placed.shape, source));
    if (way.stableNorm() > 0) return way.stableNormalized();
  }
  if (which == 3) return source.lattice_point(1, 2).normalized();
  return source.vector(-1, 1).normalized();
}

Ray special_ray(const PlacedShape& placed, RandomSource& source) {
  Vector3d at = place(placed.pose, special_point(placed.shape, source));
  if (source.integer(0, 2) > 0)
    at += source.vector(-1, 1) * (placed.size * std::pow(10.0, source.uniform(-16, 0)));
  Vector3d direction = special_direction(placed, source);
  if (source.integer(0, 1) == 0) direction = -direction;
  if (source.integer(0, 3) == 0)
    direction += source.vector(-1, 1) * std::pow(10.0, source.uniform(-16, -1));
  const double which = source.integer(0, 9);
  const double before = which == 0 ? 0 : which == 1 ? 1e6 : source.uniform(-0.5, 4);
  return {at - direction * (before * placed.size), direction};
}

/// The least distance of the ray from the shape: it is convex along the ray.
double distance_of_ray(const PlacedShape& placed, const WidePoint& o, const WidePoint& d,
                       double reach) {
  const auto at = [&](double s) {
    WidePoint p = o;
    for (std::size_t k = 0; k < 3; ++k)
      p.at[k] += d.at[k] * mpf_class(s, tests::kBits);
    return tests::distance_to(placed.shape, p);
  };
  double low = 0, high = reach, least = std::min(at(low), at(high));
  for (int i = 0; i < 130 && least > 0; ++i) {
    const double first = low + (high - low) * 0.45, second = low + (high - low) * 0.55;
    const double of_first = at(first), of_second = at(second);
    least = std::min({least, of_first, of_second});
    (of_first < of_second ? high : low) = of_first < of_second ? second : first;
  }
  return least;
}

/// Whether the line hits, and so do lines that are moved by that much to all sides.
bool hits_when_moved(const PlacedShape& placed, const Ray& ray, double by) {
  const WidePoint d = tests::direction_into(placed.pose, ray.direction);
  const Vector3d unit = ray.direction.normalized();
  const Vector3d e = unit.unitOrthogonal(), f = unit.cross(e);
  for (int i = -1; i < 12; ++i) {
    WidePoint o = tests::point_into(placed.pose, ray.origin);
    if (i >= 0) {
      const Vector3d way = (e * std::cos(i * M_PI / 6) + f * std::sin(i * M_PI / 6)) * (1.04 * by);
      const WidePoint moved = tests::direction_into(placed.pose, way);
      for (std::size_t k = 0; k < 3; ++k)
        o.at[k] += moved.at[k];
    }
    if (!tests::stretch_in(placed.shape, o, d)) return false;
  }
  return true;
}

/// Whether all that is no further than that from the point is in the shape.
bool is_deep(const PlacedShape& placed, const WidePoint& p, double by) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double sign : {-1.0, 1.0}) {
      WidePoint moved = p;
      moved.at[k] += mpf_class(1.8 * by * sign, tests::kBits);
      if (tests::distance_to(placed.shape, moved) > 0) return false;
    }
  }
  return true;
}

void expect_right(const PlacedShape& placed, const Ray& ray) {
  const auto hit = cast_ray({placed.shape, placed.pose}, ray);
  const double away = (ray.origin - placed.middle).norm();
  const double tolerance = kRayTolerance * (placed.size + away) + placed.rounding;
  const Vector3d unit = ray.direction.normalized();
  const WidePoint o = tests::point_into(placed.pose, ray.origin);
  const WidePoint d = tests::direction_into(placed.pose, unit);
  const double outside = tests::distance_to(placed.shape, o);
  const auto truth = tests::stretch_in(placed.shape, o, d);
  if (!hit) {
    // Law 11, of faces that are elsewhere; and of a line that is moved, however thin the shape is.
    if (!truth || truth->exit <= 0) return;
    EXPECT_FALSE(is_deep(placed, o, tolerance)) << "begins inside and misses";
    if (truth->enter > 0 && outside > tolerance) {
      EXPECT_FALSE(hits_when_moved(placed, ray, tolerance)) << "misses";
    }
    return;
  }
  EXPECT_NEAR(hit->normal.norm(), 1, 1e-12);
  if (hit->distance == 0) {
    EXPECT_LE(outside, tolerance) << "begins outside";
    return;
  }
  EXPECT_LE(hit->normal.dot(unit), 1e-9);
  const WidePoint p = tests::point_into(placed.pose, hit->point);
  EXPECT_LE(tests::distance_to(placed.shape, p), tolerance) << "the point is beside the shape";
  EXPECT_LE((hit->point - (ray.origin + unit * hit->distance)).norm(), tolerance);
  const Vector3d n = placed.pose.linear().transpose() * hit->normal;
  const Vector3d from_centre(mpf_class(p.at[0] - centre_of(placed.shape)[0]).get_d(),
                             mpf_class(p.at[1] - centre_of(placed.shape)[1]).get_d(),
                             mpf_class(p.at[2] - centre_of(placed.shape)[2]).get_d());
  const double reach = tests::reach_along(placed.shape, n) - n.dot(centre_of(placed.shape));
  EXPECT_GE(n.dot(from_centre), reach - 2 * tolerance) << "the normal is of another point";
  const double far = 2 * (away + placed.size);
  EXPECT_LE(distance_of_ray(placed, o, d, far), tolerance) << "the ray is beside the shape";
  EXPECT_FALSE(is_deep(placed, o, tolerance)) << "begins inside and hits further on";
}

int rays_tried(ShapeKind kind, int count, std::uint64_t seed) {
  SCOPED_TRACE(name_of(kind));
  RandomSource source(seed);
  int hits = 0;
  for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
    const PlacedShape placed = special_placed(kind, source);
    for (int i = 0; i < 4 && !testing::Test::HasFailure(); ++i) {
      const Ray ray = special_ray(placed, source);
      const Vector3d half = half_box(placed.shape);
      SCOPED_TRACE(testing::Message()
                   << "shape " << n << " of half " << half.transpose() << ", ray " << i << " from "
                   << placed.pose.inverse() * ray.origin << " along "
                   << placed.pose.linear().transpose() * ray.direction);
      expect_right(placed, ray);
      hits += cast_ray({placed.shape, placed.pose}, ray).has_value();
    }
  }
  return hits;
}

constexpr ShapeKind kKinds[] = {ShapeKind::Sphere,   ShapeKind::Box,  ShapeKind::Capsule,
                                ShapeKind::Cylinder, ShapeKind::Cone, ShapeKind::Ellipsoid};

// Found by the rays below, each of them wrong once.

TEST(ConvexRayNormal, OfACapsuleThatIsAllButABallIsTheBalls) {
  RandomSource source(3);
  for (int n = 0; n < 1000; ++n) {
    const double half_length = n % 3 == 0 ? 0 : std::pow(10.0, source.uniform(-20, -14));
    const double angle = source.uniform(0, 6.3);  // entered where its ends meet
    const Vector3d target(std::cos(angle), std::sin(angle), 0);
    const Vector3d from = target * 1.2 + Vector3d(0, 0, source.uniform(-3, 3));
    const auto hit = cast_ray({Capsule{1, half_length}, Pose::Identity()}, {from, target - from});
    ASSERT_TRUE(hit) << n;
    ASSERT_NEAR((hit->normal - hit->point).norm(), 0, 1e-12) << n;
  }
}

// Along a line that touches its side, or an end, or both at once, rounding may turn a normal to the
// way that the ray goes, the more so the thinner the capsule is.
TEST(ConvexRayNormal, OfACapsuleThatIsGrazedIsTheSurfaces) {
  RandomSource source(5);
  int hits = 0;
  for (int n = 0; n < 20000; ++n) {
    const Capsule capsule{std::pow(10.0, source.uniform(-7, 0)), 1};
    const double angle = source.uniform(0, 6.3), along = n % 3 == 0 ? 1 : source.uniform(-1, 1);
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    const Vector3d way = n % 4 == 0
                             ? Vector3d(0, 0, 1)
                             : Vector3d(-out.y(), out.x(), n % 4 == 1 ? 0 : source.uniform(-1, 1));
    const Pose pose = tests::random_pose(0.1, source);
    const Vector3d target = out * capsule.radius + Vector3d(0, 0, along);
    const auto hit = cast_ray({capsule, pose}, {pose * (target - 4 * way), pose.linear() * way});
    if (!hit) continue;
    ++hits;
    const Vector3d own = pose.inverse() * hit->point;
    const Vector3d from_axis = own - Vector3d(0, 0, std::clamp(own.z(), -1.0, 1.0));
    const Vector3d surfaces = pose.linear() * from_axis.normalized();
    ASSERT_LT((hit->normal - surfaces).norm(), 1e-3) << n << " radius " << capsule.radius;
    ASSERT_LE(hit->normal.dot(pose.linear() * way), 1e-15) << n;
  }
  EXPECT_GT(hits, 5000);
}

TEST(ConvexRayNormal, OfAFlatEllipsoidIsAgainstTheRay) {
  RandomSource source(4);
  for (int n = 0; n < 1000; ++n) {
    const double thin = std::pow(10.0, source.uniform(-30, -9));
    const double angle = source.uniform(0, 6.3), off = std::pow(10.0, source.uniform(-9, 0));
    const Vector3d target(std::cos(angle) * (1 - off), std::sin(angle) * 0.5 * (1 - off), 0);
    const Vector3d from{source.uniform(-1, 1), source.uniform(-1, 1), 1};
    const auto hit =
        cast_ray({Ellipsoid{{0, 0, 0}, {1, 0.5, thin}}, Pose::Identity()}, {from, target - from});
    ASSERT_TRUE(hit) << n;
    ASSERT_NEAR(hit->normal.z(), 1, 2 * thin / std::sqrt(off)) << n;
    ASSERT_NEAR((hit->point - target).norm(), 0, 4 * thin + 1e-14) << n;
  }
}

TEST(ConvexRay, FlatConesEndAtTheirRims) {
  for (const double height : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-30}) {
    for (const double off : {1e-2, 1e-4, 1e-6, 1e-9, 1e-11}) {
      const Vector3d way(-0.3, 0.2, -0.9);
      const auto ray = [&](double rho) {
        const Vector3d on_base(0.6 * rho, 0.8 * rho, -height);
        return Ray{on_base - 2 * way, way};
      };
      EXPECT_TRUE(cast_ray({Cone{1, height}, Pose::Identity()}, ray(1 - off)))
          << height << " " << off;
      if (off > 1e-2 * height) {
        EXPECT_EQ(cast_ray({Cone{1, height}, Pose::Identity()}, ray(1 + off + height)).has_value(),
                  false)
            << height << " " << off;
      }
    }
  }
}

TEST(ConvexRayNormal, AtAnApexIsOfTheSideTheRayComesFrom) {
  const auto hit =
      cast_ray({Cone{1e-20, 1}, Pose::Identity()}, {{-0.8, -1.6, 0.2}, {0.4, 0.8, 0.4}});
  ASSERT_TRUE(hit);
  EXPECT_LT(hit->normal.head<2>().dot(Eigen::Vector2d(1, 2)), 0);
  EXPECT_GE(hit->normal.z(), 0);
}

// A line parallel to a generator, in the plane that touches the cone along that: it lies outside
// all along, but for the generator itself.
TEST(ConvexRayCone, InATangentPlaneBesideTheGeneratorMisses) {
  const double radii[] = {0.5, 1, 2, 3}, heights[] = {0.5, 1, 2};
  for (const double radius : radii) {
    for (const double height : heights) {
      const Shape cone = Cone{radius, height};
      for (int side = 0; side < 4; ++side) {
        const Vector3d outward[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
        const Vector3d& out = outward[side];
        const Vector3d across(-out.y(), out.x(), 0);
        const Vector3d down = radius * out - 2 * height * Vector3d::UnitZ();  // from apex to rim
        const Vector3d apex = height * Vector3d::UnitZ();
        for (const double beside : {0.25, -0.5, 0x1p-20, 4.0}) {
          for (const double from : {-1.0, 0.0, 0.25, 0.5, 1.0, 2.0}) {
            const Vector3d origin = apex + from * down + beside * radius * across;
            EXPECT_FALSE(cast_ray({cone}, {origin, down})) << radius << " " << height;
            EXPECT_FALSE(cast_ray({cone}, {origin, -down})) << radius << " " << height;
          }
        }
      }
    }
  }
}

class ConvexRaySpecial : public testing::TestWithParam<ShapeKind> {};
TEST_P(ConvexRaySpecial, IsTheDefinitionsInSpecialPositions) {
  EXPECT_GT(rays_tried(GetParam(), 300, 1), 180);
}
INSTANTIATE_TEST_SUITE_P(Kinds, ConvexRaySpecial, testing::ValuesIn(kKinds));

class ConvexRaySlow : public testing::TestWithParam<ShapeKind> {};
TEST_P(ConvexRaySlow, IsTheDefinitionsInSpecialPositions) {
  EXPECT_GT(rays_tried(GetParam(), 20000, 2), 12000);
}
INSTANTIATE_TEST_SUITE_P(Kinds, ConvexRaySlow, testing::ValuesIn(kKinds));

}  // namespace
}  // namespace graze
