#include <graze/engine/cli/html_report.h>
#include <graze/engine/mesh/placement.h>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <vector>

namespace graze::cli {
namespace {

constexpr double kSide = 240;  // of each of the two views, in pixels
constexpr double kMargin = 16;

struct Coloured {
  Triangle triangle;
  const char* colour;
};

/// A direction to look along, and what is right and up then.
struct View {
  Eigen::Vector3d right;
  Eigen::Vector3d up;
};

std::vector<Coloured> triangles_of(const compare::MeshCase& meshes) {
  constexpr std::size_t kMaxTriangles = 200;
  std::vector<Coloured> all;
  for (const auto& [mesh, colour] :
       {std::pair{&meshes.a, "#1f6fb4"}, std::pair{&meshes.b, "#d95f02"}}) {
    for (std::size_t i = 0; i < std::min(mesh->mesh.triangles().size(), kMaxTriangles); ++i)
      all.push_back({place(mesh->pose, mesh->mesh.triangle(i)), colour});
  }
  return all;
}

Eigen::Vector3d normal_of(const Triangle& t, const Eigen::Vector3d& otherwise) {
  const double size =
      std::max({(t.b - t.a).cwiseAbs().maxCoeff(), (t.c - t.a).cwiseAbs().maxCoeff(), 0x1p-1000});
  const Eigen::Vector3d normal = ((t.b - t.a) / size).cross((t.c - t.a) / size);
  const double length = normal.norm();
  return length > 1e-12 ? Eigen::Vector3d(normal / length) : otherwise;
}

/// One view onto the plane of the first triangle, one along it: what is between the two shows
/// there.
std::array<View, 2> views_of(const std::vector<Coloured>& triangles) {
  const Eigen::Vector3d normal = normal_of(triangles.front().triangle, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d other = normal_of(triangles.back().triangle, Eigen::Vector3d::UnitX());
  Eigen::Vector3d right = normal.cross(other);
  if (right.norm() < 1e-6) right = normal.unitOrthogonal();
  right.normalize();
  const Eigen::Vector3d up = normal.cross(right);
  return {View{right, up}, View{up, normal}};
}

struct Frame {
  Eigen::Vector2d min;
  double scale;  // pixels a metre
};

Eigen::Vector2d seen(const View& view, const Eigen::Vector3d& point,
                     const Eigen::Vector3d& origin) {
  return {view.right.dot(point - origin), view.up.dot(point - origin)};
}

Frame frame_of(const View& view, const std::vector<Coloured>& triangles,
               const Eigen::Vector3d& origin) {
  Eigen::Vector2d min = seen(view, triangles.front().triangle.a, origin);
  Eigen::Vector2d max = min;
  for (const Coloured& each : triangles) {
    for (const Eigen::Vector3d* p : {&each.triangle.a, &each.triangle.b, &each.triangle.c}) {
      min = min.cwiseMin(seen(view, *p, origin));
      max = max.cwiseMax(seen(view, *p, origin));
    }
  }
  const double size = std::max((max - min).maxCoeff(), 0x1p-1000);
  return {min, (kSide - 2 * kMargin) / size};
}

}  // namespace

std::string svg_picture(const Case& query) {
  const std::optional<compare::MeshCase> meshes = compare::as_meshes(query);
  if (!meshes) return "";
  const std::vector<Coloured> triangles = triangles_of(*meshes);
  const Eigen::Vector3d origin = triangles.front().triangle.a;
  std::string svg = fmt::format(
      "<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\">", 2 * kSide, kSide);
  double left = 0;
  for (const View& view : views_of(triangles)) {
    const Frame frame = frame_of(view, triangles, origin);
    svg += fmt::format("<rect x=\"{}\" y=\"0.5\" width=\"{}\" height=\"{}\" class=\"view\"/>",
                       left + 0.5, kSide - 1, kSide - 1);
    for (const Coloured& each : triangles) {
      svg += "<polygon points=\"";
      for (const Eigen::Vector3d* p : {&each.triangle.a, &each.triangle.b, &each.triangle.c}) {
        const Eigen::Vector2d at = (seen(view, *p, origin) - frame.min) * frame.scale;
        const double x = left + kMargin + at.x();
        const double y = kSide - kMargin - at.y();
        if (!std::isfinite(x) || !std::isfinite(y)) return "";  // beyond what can be drawn
        svg += fmt::format("{:.2f},{:.2f} ", x, y);
      }
      svg += fmt::format("\" fill=\"{0}\" fill-opacity=\"0.35\" stroke=\"{0}\"/>", each.colour);
    }
    left += kSide;
  }
  return svg + "</svg>";
}

}  // namespace graze::cli
