#include "tests/bvh/fit/point_sets.h"

#include <cmath>

#include "tests/shapes/random_source.h"

namespace graze::tests {
namespace {

Points random_points(std::size_t count, const Eigen::Vector3d& size, RandomSource& source) {
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(source.vector(-1, 1).cwiseProduct(size));
  return points;
}

Points lattice_points(std::size_t count, int extent, RandomSource& source) {
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(source.lattice_point(-extent, extent));
  return points;
}

Points on_sphere(std::size_t count, RandomSource& source) {
  Points points = random_points(count, {1, 1, 1}, source);
  for (Eigen::Vector3d& point : points)
    point /= point.norm();
  return points;
}

Points on_circle(std::size_t count) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    points.push_back({0.6 * c, s, 0.8 * c});
  }
  return points;
}

Points on_line(std::size_t count, RandomSource& source) {
  Points points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(source.uniform(-1, 1) * Eigen::Vector3d{1, 2, -3});
  return points;
}

Points repeated(const Points& points, int times) {
  Points result;
  for (int i = 0; i < times; ++i)
    result.insert(result.end(), points.begin(), points.end());
  return result;
}

}  // namespace

Points scaled(Points points, double factor) {
  for (Eigen::Vector3d& point : points)
    point *= factor;
  return points;
}

Points moved(Points points, const Eigen::Vector3d& offset) {
  for (Eigen::Vector3d& point : points)
    point += offset;
  return points;
}

std::vector<PointSet> plain_sets() {
  RandomSource source(1);
  std::vector<PointSet> sets{
      {"origin", {{0, 0, 0}}},
      {"point", {{0.1, 0.2, 0.3}}},
      {"pair", {{0.1, 0.2, 0.3}, {-0.7, 0.4, 0.9}}},
      {"coincident", repeated({{0.1, 0.2, 0.3}}, 7)},
      {"triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
      {"obtuse", {{0, 0, 0}, {1, 0, 0}, {0.5, 0.1, 0.01}}},
      {"tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}},
      {"cube",
       repeated(
           {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
           3)},
      {"needle", {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}, {0.25, 0, 1e-12}}},
      {"nearly one",
       {{1, 1, 1}, {std::nextafter(1.0, 2.0), 1, 1}, {1, std::nextafter(1.0, 0.0), 1}}},
  };
  sets.push_back({"ball", random_points(200, {1, 1, 1}, source)});
  sets.push_back({"slab", random_points(100, {1, 0.7, 1e-6}, source)});
  sets.push_back({"flat", random_points(100, {1, 0, 0.3}, source)});
  sets.push_back({"lattice", lattice_points(150, 2, source)});
  sets.push_back({"straight", on_line(40, source)});
  sets.push_back({"sphere", on_sphere(300, source)});
  sets.push_back({"circle", on_circle(100)});
  sets.push_back({"twice", repeated(on_sphere(30, source), 2)});
  return sets;
}

std::vector<PointSet> hard_sets() {
  std::vector<PointSet> sets;
  const auto append = [&](const PointSet& set, const char* how, Points points) {
    sets.push_back({set.name + how, std::move(points)});
  };
  for (const PointSet& set : plain_sets()) {
    append(set, "", set.points);
    append(set, " at 1e9", moved(set.points, {1e9, -2e9, 3e9}));
    append(set, " at 1e17", moved(set.points, {1e17, 3e16, -1e17}));
    append(set, " of 1e-300", scaled(set.points, 1e-300));
    append(set, " of 1e300", scaled(set.points, 1e300));
    append(set, " of 5e307", scaled(set.points, 5e307 / 3));
    append(set, " of denormals", scaled(set.points, 0x1p-1070));
    append(set, " on the verge of denormals", scaled(set.points, 0x1p-1021));
    append(set, " of mixed scale", [&] {
      Points points = set.points;
      for (std::size_t i = 0; i < points.size(); i += 3)
        points[i] *= 1e-200;
      return points;
    }());
  }
  return sets;
}

}  // namespace graze::tests
