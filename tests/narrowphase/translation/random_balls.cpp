#include "tests/narrowphase/translation/random_balls.h"

#include <array>
#include <cmath>

#include "tests/narrowphase/translation/random_casts.h"

namespace graze::tests {
namespace {

int any_of(RandomSource& source, int count) {
  return static_cast<int>(source.integer(0, count - 1));
}

BallQuery with_ball(const CastQuery& query, double radius) {
  return {query.a, {query.b.a, radius}, query.displacement};
}

/// Right triangles with whole sides.
constexpr std::array<std::array<int, 3>, 4> kWholeSides{
    {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {0, 7, 7}}};

/// A ball that touches a corner, an edge or the face of a triangle in passing, exactly, or just
/// does, or just does not.
BallQuery tangent(RandomSource& source) {
  const auto& sides = kWholeSides[static_cast<std::size_t>(any_of(source, 4))];
  const int x = static_cast<int>(source.integer(2, 9));
  BallQuery query{{{0, 0, 0}, {-3, 1, -2}, {-2, -2, -5}},
                  {{1.0 * -x, 1.0 * sides[0], 1.0 * sides[1]}, 1.0 * sides[2]},
                  {3.0 * x, 0, 0}};
  switch (any_of(source, 3)) {
    case 0:
      break;
    case 1:  // an edge at right angles to the way
      query.triangle = {{0, -20, 0}, {0, 20, 0}, {0, 1, -7}};
      query.ball.centre = {1.0 * -x, 1, 1.0 * sides[2]};
      break;
    default:  // a face along the way
      query.triangle = {{0, -2, 0}, {9, -2, 0}, {9, 11, 0}};
      query.ball.centre = {-20, 1, 1.0 * sides[2]};
      query.displacement = {40, 0, 0};
  }
  const int by = any_of(source, 4);
  if (by == 1) query.ball.radius = std::nextafter(query.ball.radius, 0);
  if (by == 2) query.ball.radius = std::nextafter(query.ball.radius, 100);
  if (by == 3) query.displacement.y() = std::ldexp(source.uniform(-1, 1), -60);
  const double scale = any_of(source, 2) != 0 ? 1 : 1.0 / 3;
  for (Eigen::Vector3d* p : {&query.triangle.a, &query.triangle.b, &query.triangle.c,
                             &query.ball.centre, &query.displacement})
    *p *= scale;
  query.ball.radius *= scale;
  return query;
}

/// Any, with a radius that is nearly the least distance from a corner.
BallQuery grazing(RandomSource& source) {
  CastQuery query = random_cast(0, source);
  const Eigen::Vector3d& d = query.displacement;
  const Eigen::Vector3d to_corner = query.a.b - query.b.a;
  const double radius = (to_corner - to_corner.dot(d) / d.squaredNorm() * d).norm();
  const double more = source.uniform(-1, 1);
  return with_ball(query, radius * (1 + std::ldexp(more, -any_of(source, 54))));
}

/// A ball that rests on a corner, an edge or the face, or is in it, at first.
BallQuery resting(RandomSource& source) {
  const auto& sides = kWholeSides[static_cast<std::size_t>(any_of(source, 4))];
  const Triangle triangle{{0, 0, 0}, {40, 0, 0}, {0, 40, 0}};
  const Eigen::Vector3d face(5, 6, sides[2]), edge(7, -sides[0], sides[1]),
      corner(-sides[0], 0, sides[1]);
  const Eigen::Vector3d centres[3] = {face, edge, corner};
  BallQuery query{
      triangle, {centres[any_of(source, 3)], 1.0 * sides[2]}, source.lattice_point(-2, 2)};
  if (any_of(source, 4) == 0) query.ball.radius = std::nextafter(query.ball.radius, 100);
  if (any_of(source, 4) == 0) query.ball.radius = std::nextafter(query.ball.radius, 0);
  return query;
}

double* coordinate_of(BallQuery& query, int point, int axis) {
  Eigen::Vector3d* points[5] = {&query.triangle.a, &query.triangle.b, &query.triangle.c,
                                &query.ball.centre, &query.displacement};
  return points[point]->data() + axis;
}

double double_of_any_size(RandomSource& source) {
  const double size = source.uniform_at_scale(0.5, 1, -1073, 1023);
  return source.integer(0, 1) != 0 ? size : -size;
}

BallQuery scaled(BallQuery query, int exponent) {
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 3; ++k)
      *coordinate_of(query, i, k) = std::ldexp(*coordinate_of(query, i, k), exponent);
  }
  query.ball.radius = std::ldexp(query.ball.radius, exponent);
  return query;
}

}  // namespace

const char* name_of_ball_kind(int kind) {
  if (kind <= 10) return name_of_cast_kind(kind);
  static constexpr const char* kNames[] = {
      "points",       "tangent",      "grazing",        "resting",   "large and small balls",
      "small floors", "all of 2^900", "all of 2^-1060", "any double"};
  return kNames[kind - 11];
}

BallQuery random_ball_query(int kind, RandomSource& source) {
  const bool is_on_lattice = kind == 2 || kind == 3 || kind == 5 || kind == 7;
  if (kind <= 10) {
    const CastQuery query = random_cast(kind, source);
    return with_ball(query, is_on_lattice ? 0.5 * static_cast<double>(source.integer(0, 4))
                                          : source.uniform(0, 0.6));
  }
  switch (kind) {
    case 11:
      return with_ball(random_cast(any_of(source, 11), source), 0);
    case 12:
      return tangent(source);
    case 13:
      return grazing(source);
    case 14:
      return resting(source);
    case 15: {
      BallQuery query = with_ball(random_cast(0, source), 0);
      query.ball.radius = std::ldexp(1.0, static_cast<int>(source.integer(-60, 40)));
      query.ball.centre -= 1.1 * query.ball.radius * source.vector(-1, 1);
      query.displacement *= 1 + query.ball.radius;
      return query;
    }
    case 16: {
      const CastQuery cast = random_cast(any_of(source, 2), source);
      BallQuery query = with_ball(cast, source.uniform(0, 1));
      const int exponent = static_cast<int>(source.integer(-80, -20));
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k)
          *coordinate_of(query, i, k) = std::ldexp(*coordinate_of(query, i, k), exponent);
      }
      return query;
    }
    case 17:
      return scaled(random_ball_query(any_of(source, 16), source), 900);
    case 18:
      return scaled(random_ball_query(any_of(source, 16), source), -1060);
    default: {
      const CastQuery cast = random_cast(0, source);
      BallQuery query = with_ball(cast, source.uniform(0, 1));
      for (int i = 0; i < 5; ++i) {
        for (int k = 0; k < 3; ++k) {
          if (source.integer(0, 3) == 0) *coordinate_of(query, i, k) = double_of_any_size(source);
        }
      }
      if (source.integer(0, 1) == 0) query.ball.radius = std::abs(double_of_any_size(source));
      return query;
    }
  }
}

}  // namespace graze::tests
