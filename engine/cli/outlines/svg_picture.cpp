#include <graze/bvh/error.h>
#include <graze/engine/cli/outlines/case_outlines.h>
#include <graze/engine/cli/outlines/scale_bar.h>
#include <graze/engine/cli/outlines/svg_picture.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/world/shape_pairs.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace graze::cli {
namespace {

constexpr double kSide = 240;  // the side of each of the two views, in pixels
constexpr double kMargin = 22;
constexpr double kLongestBar = 90;

/// Holds a direction to look along, and what is right and up then.
struct View {
  Eigen::Vector3d right;
  Eigen::Vector3d up;
};

using Seen = std::vector<Eigen::Vector2d>;

std::optional<Eigen::Vector3d> unit(const Eigen::Vector3d& direction) {
  const double length = direction.norm();
  if (!(length > 1e-12)) return std::nullopt;
  return Eigen::Vector3d(direction / length);
}

Eigen::Vector3d normal_of(const Outline& outline, const Eigen::Vector3d& otherwise) {
  if (outline.is_silhouette || outline.points.size() < 3) return otherwise;
  const Eigen::Vector3d to_b = outline.points[1] - outline.points[0];
  const Eigen::Vector3d to_c = outline.points[2] - outline.points[0];
  const double size = std::max({to_b.cwiseAbs().maxCoeff(), to_c.cwiseAbs().maxCoeff(), 0x1p-1000});
  return unit((to_b / size).cross(to_c / size)).value_or(otherwise);
}

/// Returns the direction from one body to the other, if the library knows it.
std::optional<Eigen::Vector3d> direction_between(const Case& query) {
  const std::optional<compare::BodyCase> bodies = compare::as_bodies(query);
  if (!bodies) return std::nullopt;
  try {
    return unit(
        distance({bodies->a.shape, bodies->a.pose}, {bodies->b.shape, bodies->b.pose}).normal);
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Returns views that show from both sides what is between the two: along the line from one body to
/// the other, or for triangles one view onto the plane of the first, and one along it.
std::array<View, 2> views_of(const Case& query, const std::vector<Outline>& outlines) {
  if (const std::optional<Eigen::Vector3d> direction = direction_between(query)) {
    const Eigen::Vector3d up = direction->unitOrthogonal();
    return {View{*direction, up}, View{*direction, direction->cross(up)}};
  }
  const Eigen::Vector3d normal = normal_of(outlines.front(), Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d other = normal_of(outlines.back(), Eigen::Vector3d::UnitX());
  const Eigen::Vector3d right = unit(normal.cross(other)).value_or(normal.unitOrthogonal());
  const Eigen::Vector3d up = normal.cross(right);
  return {View{right, up}, View{up, normal}};
}

Eigen::Vector2d seen(const View& view, const Eigen::Vector3d& point,
                     const Eigen::Vector3d& origin) {
  return {view.right.dot(point - origin), view.up.dot(point - origin)};
}

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Returns the corners of the points' convex hull, by Andrew's chains.
Seen silhouette(Seen points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  Seen hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Eigen::Vector2d& point : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull.empty() ? points : hull;
}

/// Puts all that is seen into a view's square, `left` pixels from the picture's edge. Returns how
/// many pixels a metre has there.
double fit(std::vector<Seen>& all, double left) {
  Eigen::Vector2d min = all.front().front();
  Eigen::Vector2d max = min;
  for (const Seen& points : all) {
    for (const Eigen::Vector2d& point : points) {
      min = min.cwiseMin(point);
      max = max.cwiseMax(point);
    }
  }
  const double scale = (kSide - 2 * kMargin) / std::max((max - min).maxCoeff(), 0x1p-1000);
  for (Seen& points : all) {
    for (Eigen::Vector2d& point : points) {
      const Eigen::Vector2d at = (point - min) * scale;
      point = {left + kMargin + at.x(), kSide - kMargin - at.y()};
    }
  }
  return scale;
}

/// Returns a line of round length with its length under it, in the view's lower left corner.
std::string bar_of(double pixels_per_metre, double left) {
  const ScaleBar bar = scale_bar(kLongestBar / pixels_per_metre);
  if (bar.length == 0) return "";
  const double from = left + 6;
  const double to = from + bar.length * pixels_per_metre;
  return fmt::format(
      "<path d=\"M{0:.2f} {2} V{3} H{1:.2f} V{2}\" class=\"bar\"/>"
      "<text x=\"{4:.2f}\" y=\"{5}\">{6}</text>",
      from, to, kSide - 10, kSide - 6, to + 4, kSide - 5, bar.label);
}

std::string svg_of(const Seen& points, const std::string& colour) {
  if (points.size() == 1) {
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3\" fill=\"{}\"/>", points[0].x(),
                       points[0].y(), colour);
  }
  std::string svg = "<polygon points=\"";
  for (const Eigen::Vector2d& at : points)
    svg += fmt::format("{:.2f},{:.2f} ", at.x(), at.y());
  return svg + fmt::format("\" fill=\"{0}\" fill-opacity=\"0.35\" stroke=\"{0}\"/>", colour);
}

}  // namespace

std::string svg_picture(const Case& query) {
  const std::vector<Outline> outlines = case_outlines(query);
  if (outlines.empty()) return "";
  const Eigen::Vector3d origin = outlines.front().points.front();
  std::string svg = fmt::format(
      "<svg class=\"still\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\">",
      2 * kSide, kSide);
  double left = 0;
  for (const View& view : views_of(query, outlines)) {
    std::vector<Seen> all;
    for (const Outline& outline : outlines) {
      Seen points;
      for (const Eigen::Vector3d& point : outline.points)
        points.push_back(seen(view, point, origin));
      all.push_back(outline.is_silhouette ? silhouette(std::move(points)) : std::move(points));
    }
    const double scale = fit(all, left);
    svg += fmt::format("<rect x=\"{}\" y=\"0.5\" width=\"{}\" height=\"{}\" class=\"view\"/>",
                       left + 0.5, kSide - 1, kSide - 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const Eigen::Vector2d& at : all[i])
        if (!at.allFinite()) return "";  // such numbers are beyond what can be drawn
      svg += svg_of(all[i], outlines[i].colour);
    }
    svg += bar_of(scale, left);
    left += kSide;
  }
  return svg + "</svg>";
}

}  // namespace graze::cli
