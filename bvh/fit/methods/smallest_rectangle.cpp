#include <graze/bvh/fit/methods/smallest_rectangle.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::bvh {
namespace {

using Polygon = std::vector<PlanePoint>;

double cross(const PlanePoint& o, const PlanePoint& a, const PlanePoint& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// Returns the corners of the convex hull, counterclockwise (Andrew's monotone chain). Rounding may
/// drop a corner that is nearly straight: whoever uses the rectangle's direction covers all points
/// anyway.
Polygon convex_hull(Polygon& points) {
  std::sort(points.begin(), points.end(), [](const PlanePoint& a, const PlanePoint& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  Polygon hull;
  const auto append = [&](const PlanePoint& point, std::size_t fixed) {
    while (hull.size() > fixed && cross(hull[hull.size() - 2], hull.back(), point) <= 0)
      hull.pop_back();
    hull.push_back(point);
  };
  for (const PlanePoint& point : points)
    append(point, 1);
  const std::size_t lower = hull.size();
  for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
    append(*point, lower);
  hull.pop_back();  // the first again
  return hull;
}

/// A corner of the hull that is farthest along a direction which turns once around.
class Caliper {
 public:
  Caliper(const Polygon& hull, std::size_t start) : hull_(hull), corner_(start) {}

  double advance(const PlanePoint& direction) {
    double height = along(corner_, direction);
    for (std::size_t steps = 0; steps < hull_.size(); ++steps) {
      const std::size_t next = corner_ + 1 == hull_.size() ? 0 : corner_ + 1;
      const double next_height = along(next, direction);
      if (next_height < height) break;
      corner_ = next;
      height = next_height;
    }
    return height;
  }

 private:
  double along(std::size_t i, const PlanePoint& d) const {
    return hull_[i].x * d.x + hull_[i].y * d.y;
  }

  const Polygon& hull_;
  std::size_t corner_;
};

}  // namespace

PlanePoint smallest_rectangle_side(std::vector<PlanePoint>& points, double padding) {
  const Polygon hull = points.size() > 1 ? convex_hull(points) : points;
  PlanePoint best{1, 0};
  double least = std::numeric_limits<double>::infinity();
  Caliper right(hull, 0);
  Caliper top(hull, 0);
  Caliper left(hull, 0);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const PlanePoint& from = hull[i];
    const PlanePoint& to = hull[i + 1 == hull.size() ? 0 : i + 1];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0)) continue;
    const PlanePoint side{(to.x - from.x) / length, (to.y - from.y) / length};
    const PlanePoint inward{-side.y, side.x};
    const double width = right.advance(side);
    const double height = top.advance(inward) - (from.x * inward.x + from.y * inward.y);
    const double back = left.advance({-side.x, -side.y});
    const double area = (width + back + padding) * (height + padding);
    if (area < least) {
      least = area;
      best = side;
    }
  }
  return best;
}

}  // namespace graze::bvh
