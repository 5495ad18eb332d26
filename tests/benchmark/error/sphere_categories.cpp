#include "tests/benchmark/error/sphere_categories.h"

#include <tests/oracle/sampler.h>

#include <cmath>
#include <iterator>
#include <string>

#include "tests/narrowphase/volumes/rational_spheres.h"

namespace graze::benchmark {
namespace {

using Eigen::Vector3d;
using oracle::Grid;
using oracle::Sampler;

/// A ball beside a point that it may touch: what both questions are made of. The other shape holds
/// that point, and nothing of it is nearer to the ball's centre.
struct Beside {
  Vector3d point;
  Vector3d out;  ///< the ball's centre is at point + out
  double radius;
};

Vector3d along(Sampler& s, double reach) {
  return reach * s.point();
}

// The way out has this length only up to rounding.
Beside touching_by_rounding(Sampler& s) {
  const Vector3d out = along(s, 1);
  const double length = out.norm();
  return {s.point(), out, s.nudged(length, 2)};
}

/// Integer ways of integer lengths: rounding has no excuse but the factor of ulps.
Beside touching_on_lattice(Sampler& s) {
  static constexpr double kWays[][4] = {{1, 2, 2, 3}, {2, 3, 6, 7},  {1, 4, 8, 9},
                                        {4, 4, 7, 9}, {2, 6, 9, 11}, {6, 6, 7, 11}};
  const double* way = kWays[s.integer(0, std::size(kWays) - 1)];
  const double times = s.integer(1, 5);
  Vector3d out;
  for (int i = 0; i < 3; ++i)
    out[i] = times * way[i] * s.sign();
  const double radius = times * way[3];
  return {s.whole_point(9), out, s.one_in(3) ? s.nudged(radius, 1) : radius};
}

Beside far_from_origin(Sampler& s) {
  Beside beside = touching_by_rounding(s);
  beside.point += 1e6 * s.point();
  return beside;
}

Beside small_and_large(Sampler& s) {
  const double size = s.magnitude(-40, 40);
  const Vector3d out = along(s, size);
  const double length = out.norm();
  return {s.point(), out, s.nudged(length, 2)};
}

template <int exponent>
Beside scaled(Sampler& s) {
  Beside beside = s.one_in(2) ? touching_on_lattice(s) : touching_by_rounding(s);
  beside.point *= std::ldexp(1, exponent);
  beside.out *= std::ldexp(1, exponent);
  beside.radius = std::ldexp(beside.radius, exponent);
  return beside;
}

struct Kind {
  const char* name;
  Beside (*make)(Sampler& sampler);  ///< none for volumes anywhere
  Grid grid;
};

constexpr Kind kKinds[] = {{"random", nullptr, Grid::Double},
                           {"random_float", nullptr, Grid::Float},
                           {"touching_by_rounding", touching_by_rounding, Grid::Double},
                           {"touching_by_rounding_float", touching_by_rounding, Grid::Float},
                           {"touching_on_lattice", touching_on_lattice, Grid::Double},
                           {"touching_on_lattice_float", touching_on_lattice, Grid::Float},
                           {"far_from_origin", far_from_origin, Grid::Double},
                           {"far_from_origin_float", far_from_origin, Grid::Float},
                           {"small_and_large", small_and_large, Grid::Double},
                           {"small_and_large_float", small_and_large, Grid::Float},
                           {"tiny", scaled<-560>, Grid::Double},
                           {"huge", scaled<500>, Grid::Double}};

Vector3d on_grid(const Vector3d& p, Grid grid) {
  return {oracle::on_grid(p.x(), grid), oracle::on_grid(p.y(), grid), oracle::on_grid(p.z(), grid)};
}

Sphere on_grid(const Sphere& sphere, Grid grid) {
  return {on_grid(sphere.centre, grid), oracle::on_grid(sphere.radius, grid)};
}

Sphere anywhere(Sampler& s) {
  const Vector3d centre = s.point();
  return {centre, s.unit() / 2};
}

/// The corner of the box towards the ball is the point; now and then a face or an edge is.
SphereAndBox box_beside(Sampler& s, const Beside& beside) {
  Aabb box{beside.point, beside.point};
  const double size = beside.out.cwiseAbs().maxCoeff();
  Vector3d out = beside.out;
  for (int i = 0; i < 3; ++i) {
    if (s.one_in(4)) {  // the ball is beside the middle of the box along this axis
      box.min[i] -= size;
      box.max[i] += size;
      out[i] = 0;
      continue;
    }
    (out[i] > 0 ? box.min[i] : box.max[i]) -= out[i] > 0 ? 2 * size : -2 * size;
  }
  const double radius = out == beside.out ? beside.radius : std::abs(s.nudged(out.norm(), 2));
  return {{beside.point + out, radius}, box};
}

/// The other ball reaches from the point backwards, its radius a power of two times the first's.
SpherePair ball_beside(Sampler& s, const Beside& beside) {
  const double factor = s.integer(1, 4);
  return {{beside.point + beside.out, beside.radius},
          {beside.point - factor * beside.out, factor * beside.radius}};
}

SphereAndBox sphere_and_box(const Kind& kind, Sampler& s) {
  if (kind.make != nullptr) return box_beside(s, kind.make(s));
  const Sphere sphere = anywhere(s);
  const Vector3d corner = s.point();
  const Vector3d size{s.unit() / 2, s.unit() / 2, s.unit() / 2};
  return {sphere, {corner, corner + size}};
}

SpherePair sphere_pair(const Kind& kind, Sampler& s) {
  if (kind.make != nullptr) return ball_beside(s, kind.make(s));
  const Sphere a = anywhere(s);
  return {a, anywhere(s)};
}

template <typename Element, typename Make, typename Truth>
Category<Element> drawn(const Kind& kind, const char* question, const Sizes& sizes,
                        const Make& make, const Truth& truth) {
  const std::string name = kind.name;
  Category<Element> category{
      name, name.starts_with("random"), kind.grid == Grid::Float, {}, {}, sizes.elements};
  for (std::size_t i = 0; i < sizes.elements; ++i) {
    Sampler sampler(question + name, i, kind.grid);
    const Element element = make(kind, sampler);
    category.elements.push_back(element);
    category.truth.push_back(truth(element));
  }
  return category;
}

}  // namespace

std::size_t sphere_category_count() {
  return std::size(kKinds);
}

Category<SphereAndBox> sphere_box_category(std::size_t index, const Sizes& sizes) {
  const auto make = [](const Kind& kind, Sampler& s) {
    const SphereAndBox pair = sphere_and_box(kind, s);
    return SphereAndBox{on_grid(pair.sphere, kind.grid),
                        {on_grid(pair.box.min, kind.grid), on_grid(pair.box.max, kind.grid)}};
  };
  return drawn<SphereAndBox>(
      kKinds[index], "sphere and box: ", sizes, make,
      [](const SphereAndBox& pair) { return oracle::overlap(pair.sphere, pair.box); });
}

Category<SpherePair> sphere_pair_category(std::size_t index, const Sizes& sizes) {
  const auto make = [](const Kind& kind, Sampler& s) {
    const SpherePair pair = sphere_pair(kind, s);
    return SpherePair{on_grid(pair.a, kind.grid), on_grid(pair.b, kind.grid)};
  };
  return drawn<SpherePair>(kKinds[index], "sphere and sphere: ", sizes, make,
                           [](const SpherePair& pair) { return oracle::overlap(pair.a, pair.b); });
}

}  // namespace graze::benchmark
