#include "data/generator/parts/circle.h"

#include <cmath>
#include <cstddef>

namespace graze::generator {
namespace {

CirclePoint middle(const CirclePoint& p, const CirclePoint& q) {
  const double x = p.x + q.x;
  const double y = p.y + q.y;
  const double length = std::sqrt(x * x + y * y);
  return {x / length, y / length};
}

std::vector<CirclePoint> first_quarter(int halvings) {
  std::vector<CirclePoint> points = {{1, 0}, {0, 1}};
  for (int halving = 0; halving < halvings; ++halving) {
    std::vector<CirclePoint> finer = {points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
      finer.push_back(middle(points[i - 1], points[i]));
      finer.push_back(points[i]);
    }
    points = finer;
  }
  points.pop_back();  // the next quarter begins with it
  return points;
}

}  // namespace

std::vector<CirclePoint> unit_circle(int halvings) {
  std::vector<CirclePoint> points = first_quarter(halvings);
  const std::size_t quarter = points.size();
  for (std::size_t i = 0; i < 3 * quarter; ++i) {
    points.push_back({-points[i].y, points[i].x});
  }
  return points;
}

}  // namespace graze::generator
