#include <graze/bvh/error.h>
#include <graze/narrowphase/triangle_ray.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "tests/narrowphase/derived/rational_triangles.h"
#include "tests/narrowphase/simd_targets.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using oracle::RationalPoint;

mpq_class dot(const RationalPoint& p, const RationalPoint& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
RationalPoint cross(const RationalPoint& p, const RationalPoint& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
RationalPoint minus(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

/// Where a ray that is in no triangle's plane meets it, by Cramer's rule; `is_in_plane` otherwise.
struct RationalHit {
  bool is_in_plane = false;
  std::optional<mpq_class> at;
};

RationalHit crossing(const Triangle& t, const Ray& ray) {
  const RationalPoint a = oracle::exactly(t.a), d = oracle::exactly(ray.direction);
  const RationalPoint u = minus(oracle::exactly(t.b), a), v = minus(oracle::exactly(t.c), a);
  const RationalPoint w = minus(oracle::exactly(ray.origin), a);
  const mpq_class det = dot(cross(d, v), u);
  if (det == 0) return {true, std::nullopt};
  const mpq_class s = dot(cross(d, v), w) / det, r = dot(cross(w, u), d) / det;
  const mpq_class at = dot(cross(w, u), v) / det;
  if (s < 0 || r < 0 || s + r > 1 || at < 0) return {};
  return {false, at};
}

/// Exactly: |value - root of square| is at most that share of the root.
void expect_root(double value, const mpq_class& square, double share) {
  const mpq_class v(value), low(1 - share), high(1 + share);
  EXPECT_TRUE(v * v >= square * low * low) << value;
  EXPECT_TRUE(v * v <= square * high * high) << value;
}

void expect_value(const TriangleRayHit& hit, const Ray& ray, const mpq_class& at) {
  const RationalPoint d = oracle::exactly(ray.direction), o = oracle::exactly(ray.origin);
  expect_root(hit.distance, at * at * dot(d, d), 4 * 0x1p-52);
  const double largest = std::max(hit.distance, ray.origin.cwiseAbs().maxCoeff());
  const RationalPoint p{o[0] + at * d[0], o[1] + at * d[1], o[2] + at * d[2]};
  EXPECT_TRUE(oracle::are_within(p, hit.point, mpq_class(4 * 0x1p-52) * largest + 0x1p-1074));
}

void expect_normal(const TriangleRayHit& hit, const Triangle& t, const Ray& ray) {
  const RationalPoint a = oracle::exactly(t.a);
  RationalPoint n = cross(minus(oracle::exactly(t.b), a), minus(oracle::exactly(t.c), a));
  if (dot(n, oracle::exactly(ray.direction)) > 0) n = {-n[0], -n[1], -n[2]};
  const mpq_class nn = dot(n, n);
  for (std::size_t k = 0; k < 3; ++k) {
    // |m - n_k / |n|| <= 8 u, squared where both have one sign.
    const mpq_class m(hit.normal[static_cast<int>(k)]), bound(8 * 0x1p-53);
    const auto square = [](const mpq_class& x) -> mpq_class { return x * abs(x); };
    EXPECT_TRUE(square(m - bound) * nn <= square(n[k])) << hit.normal;
    EXPECT_TRUE(square(m + bound) * nn >= square(n[k])) << hit.normal;
  }
}

TEST(TriangleRay, AgreesWithRationalArithmeticOnRandomTriangles) {
  RandomSource source(1);
  int hits = 0, misses = 0;
  for (int n = 0; n < 15000; ++n) {
    const double scale = std::exp2(n % 5 == 0 ? source.uniform(-320, 320) : source.uniform(-8, 8));
    const double thin = std::exp2(n % 3 == 0 ? source.uniform(-60, 0) : 0);
    Triangle t{source.vector(-1, 1) * scale, source.vector(-1, 1) * scale, {}};
    t.c = t.a + (t.b - t.a) * source.uniform(-1, 2) + source.vector(-1, 1) * scale * thin;
    const double r = source.uniform(0, 1), s = source.uniform(-0.1, 1.1);
    const Vector3d target = t.a + r * ((1 - s) * (t.b - t.a) + s * (t.c - t.a));
    Ray ray{source.vector(-2, 2) * scale * (n % 7 == 0 ? 1e6 : 1), {}};
    ray.direction = (target - ray.origin) * std::exp2(source.uniform(-300, 300));
    const RationalHit expected = crossing(t, ray);
    if (expected.is_in_plane) continue;
    const auto hit = cast_ray(t, ray);
    ASSERT_EQ(hit.has_value(), expected.at.has_value()) << n;
    ++(hit ? hits : misses);
    if (!hit) continue;
    expect_value(*hit, ray, *expected.at);
    expect_normal(*hit, t, ray);
    ASSERT_FALSE(HasFailure()) << n;
  }
  EXPECT_GT(hits, 2000);
  EXPECT_GT(misses, 2000);
}

/// Corners, edges, planes and triangles without area are all met: a ray as a segment to a point
/// that is exact, clipped by half-spaces.
TEST(TriangleRay, AgreesWithRationalClippingOnALattice) {
  RandomSource source(2);
  int in_plane = 0, in_plane_hits = 0, hits = 0;
  for (int n = 0; n < 25000; ++n) {
    const int size = n % 2 == 0 ? 1 : 3;
    Triangle t{source.lattice_point(-size, size), source.lattice_point(-size, size),
               source.lattice_point(-size, size)};
    Ray ray{source.lattice_point(-size, size), source.lattice_point(-2, 2)};
    if (ray.direction.isZero()) continue;
    const Vector3d end = ray.origin + 16 * ray.direction;  // beyond all triangles
    const auto corners = oracle::rational_intersection(t, Triangle{ray.origin, end, end});
    const auto hit = cast_ray(t, ray);
    ASSERT_EQ(hit.has_value(), !corners.empty()) << n;
    const bool is_flat = crossing(t, ray).is_in_plane;
    in_plane += is_flat, in_plane_hits += is_flat && hit, hits += hit.has_value();
    if (!hit) continue;
    const RationalPoint d = oracle::exactly(ray.direction), o = oracle::exactly(ray.origin);
    std::optional<mpq_class> first;
    for (const RationalPoint& corner : corners) {
      const mpq_class at = dot(minus(corner, o), d) / dot(d, d);
      if (!first || at < *first) first = at;
    }
    expect_value(*hit, ray, *first);
    if (is_flat) {
      EXPECT_NEAR((hit->normal + ray.direction.normalized()).norm(), 0, 1e-15);
    } else {
      expect_normal(*hit, t, ray);
    }
    for (int k = 0; k < 2; ++k) {  // the order of vertices changes nothing
      std::swap(k == 0 ? t.a : t.b, t.c);
      const auto again = cast_ray(t, ray);
      ASSERT_TRUE(again.has_value());
      EXPECT_NEAR(again->distance, hit->distance, 4 * 0x1p-52 * hit->distance);
    }
    ASSERT_FALSE(HasFailure()) << n;
  }
  EXPECT_GT(hits, 3000);
  EXPECT_GT(in_plane_hits, 400);
  EXPECT_GT(in_plane - in_plane_hits, 1000);
}

TEST(TriangleRay, EndsAtItsLargestDistance) {
  const Triangle t{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
  EXPECT_TRUE(cast_ray(t, {{1, 1, 0}, {0, 0, 5}, 2}));
  EXPECT_FALSE(cast_ray(t, {{1, 1, 0}, {0, 0, 5}, std::nextafter(2, 0)}));
  EXPECT_TRUE(cast_ray(t, {{1, 1, 2}, {0, 0, 5}, 0}));
  const auto huge = cast_ray({{0, 0, 1e308}, {1, 0, 1e308}, {0, 1, 1e308}},
                             {{0.25, 0.25, -1e308}, {0, 0, 1e-300}});
  ASSERT_TRUE(huge);
  EXPECT_EQ(huge->distance, std::numeric_limits<double>::infinity());
  EXPECT_EQ(huge->point, Vector3d(0.25, 0.25, 1e308));
}

std::uint64_t bits_of(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

/// A face across an axis, from both sides: its normal has no other component, and no zero of it a
/// sign that would tell how it was computed.
TEST(TriangleRay, NormalsOfFacesAcrossAxesAreTheAxes) {
  RandomSource source(11);
  std::size_t hits = 0;
  for (int n = 0; n < 2000; ++n) {
    const int axis = n % 3;
    Triangle t{source.lattice_point(-4, 4), source.lattice_point(-4, 4),
               source.lattice_point(-4, 4)};
    for (Vector3d* corner : {&t.a, &t.b, &t.c})
      (*corner)[axis] = 1;
    Vector3d origin = source.lattice_point(-4, 4);
    origin[axis] = n % 2 == 0 ? 3 : -2;
    const auto hit = cast_ray(t, {origin, (t.a + t.b + t.c) / 3 - origin});
    if (!hit || (t.b - t.a).cross(t.c - t.a).isZero(0)) continue;
    ++hits;
    for (int k = 0; k < 3; ++k) {
      const double expected = k != axis ? 0.0 : (n % 2 == 0 ? 1.0 : -1.0);
      EXPECT_EQ(bits_of(hit->normal[k]), bits_of(expected)) << n;
    }
  }
  EXPECT_GT(hits, 1000u);
}

TEST(Law8TriangleRay, ValuesAreTheSameBitsOnEachSimdTarget) {
  std::vector<std::uint64_t> first;
  for (const std::int64_t target : narrowphase::simd_targets()) {
    narrowphase::force_simd_target(target);
    RandomSource source(12);
    std::vector<std::uint64_t> bits;
    for (int n = 0; n < 20000; ++n) {
      const bool is_lattice = n % 2 == 0;
      const auto point = [&] {
        return is_lattice ? source.lattice_point(-3, 3) : source.vector(-1, 1);
      };
      Triangle t{point(), point(), point()};
      Vector3d origin = point();
      // Needles, and rays nearly in their planes: products that cancel up to where no rounding
      // serves.
      const double share = std::exp2(-source.uniform(0, 60));
      if (n % 8 >= 4) t.c = t.a + source.uniform(0, 1) * (t.b - t.a) + share * (t.c - t.a);
      if (n % 8 >= 6) origin = t.a + 3 * (t.b - t.c) + std::sqrt(share) * (origin - t.a);
      const auto hit = cast_ray(t, {origin, (t.a + t.b + t.c) / 3 - origin + 1e-3 * point()});
      if (!hit) continue;
      bits.push_back(bits_of(hit->distance));
      for (int k = 0; k < 3; ++k) {
        bits.push_back(bits_of(hit->point[k]));
        bits.push_back(bits_of(hit->normal[k]));
      }
    }
    EXPECT_GT(bits.size(), 7 * 10000u);
    if (first.empty()) first = bits;
    EXPECT_EQ(bits, first) << hwy::TargetName(target);
  }
  narrowphase::force_simd_target(0);
}

/// What is no number must not pass, and what is hardly one must.
TEST(Law10TriangleRay, TakesWhatIsHardlyARay) {
  const Triangle t{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  const double least = 0x1p-1074, most = std::numeric_limits<double>::max();
  EXPECT_TRUE(cast_ray(t, {{0, 0, 1}, {0, 0, -least}}));
  EXPECT_TRUE(cast_ray(t, {{0, 0, 1}, {0, -0.0, -most}}));
  EXPECT_TRUE(cast_ray(t, {{0, 0, 0}, {0, 0, 1}, -0.0}));
  EXPECT_FALSE(cast_ray(t, {{0, 0, 1}, {0, 0, -1}, least}));
  EXPECT_FALSE(cast_ray(t, {{0, 0, -most}, {0, 0, -1}, std::numeric_limits<double>::infinity()}));
  EXPECT_THROW(cast_ray(t, {{0, 0, 1}, {0, 0, -0.0}}), InputError);
  EXPECT_THROW(cast_ray(t, {{0, 0, 1}, {0, 0, -1}, -least}), InputError);
  EXPECT_THROW(cast_ray(t, {{0, 0, 1}, {0, 0, -1}, -HUGE_VAL}), InputError);
  EXPECT_THROW(cast_ray(t, {{0, 0, 1}, {0, 0, -HUGE_VAL}}), InputError);
  EXPECT_THROW(cast_ray(t, {{0, 0, 1}, {0, 0, -std::nan("")}}), InputError);
}

TEST(Law10TriangleRay, RefusesWhatIsNoRay) {
  const Triangle t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const double nan = std::nan("");
  EXPECT_THROW(cast_ray(t, {{0, 0, 0}, {0, 0, 0}}), InputError);
  EXPECT_THROW(cast_ray(t, {{0, nan, 0}, {0, 0, 1}}), InputError);
  EXPECT_THROW(cast_ray(t, {{0, 0, 0}, {0, HUGE_VAL, 1}}), InputError);
  EXPECT_THROW(cast_ray(t, {{0, 0, 0}, {0, 0, 1}, -1}), InputError);
  EXPECT_THROW(cast_ray(t, {{0, 0, 0}, {0, 0, 1}, nan}), InputError);
  EXPECT_THROW(cast_ray({{0, 0, 0}, {1, 0, nan}, {0, 1, 0}}, {{0, 0, 0}, {0, 0, 1}}), InputError);
}

}  // namespace
}  // namespace graze
