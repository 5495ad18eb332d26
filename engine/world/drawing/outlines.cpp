#include <graze/engine/world/drawing/outlines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace graze {
namespace {

using Eigen::Vector3d;

/// Draws shapes in their own frame, and gives `take` the segments in the world's frame.
class Outline {
 public:
  Outline(const Pose& pose, const WorldDrawingSettings& settings, const TakeLine& take)
      : pose_(pose), settings_(settings), take_(take) {}

  void draw(const Box& box) {
    outline(Aabb{-box.half_extents, box.half_extents},
            [&](const Vector3d& from, const Vector3d& to) { line(from, to); });
  }

  void draw(const Sphere& ball) { draw(Ellipsoid{ball.centre, Vector3d::Constant(ball.radius)}); }

  void draw(const Ellipsoid& ball) {
    for (int axis = 0; axis < 3; ++axis) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      arc(ball.centre, ball.semi_axes[u] * Vector3d::Unit(u), ball.semi_axes[v] * Vector3d::Unit(v),
          1);
    }
  }

  void draw(const Capsule& capsule) {
    const Vector3d end = capsule.half_length * Vector3d::UnitZ();
    const Vector3d up = capsule.radius * Vector3d::UnitZ();
    for (const Vector3d& side : sides(capsule.radius)) {
      line(side - end, side + end);
      arc(end, side, up, 0.25);
      arc(-end, side, -up, 0.25);
    }
    circle(end, capsule.radius);
    circle(-end, capsule.radius);
  }

  void draw(const Cylinder& cylinder) {
    const Vector3d end = cylinder.half_height * Vector3d::UnitZ();
    for (const Vector3d& side : sides(cylinder.radius))
      line(side - end, side + end);
    circle(end, cylinder.radius);
    circle(-end, cylinder.radius);
  }

  void draw(const Cone& cone) {
    const Vector3d apex = cone.half_height * Vector3d::UnitZ();
    for (const Vector3d& side : sides(cone.radius))
      line(side - apex, apex);
    circle(-apex, cone.radius);
  }

  void draw(const ConvexHull& hull) {
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < hull.facet_count(); ++i) {
      const auto facet = hull.facet(i);
      for (std::size_t k = 0; k < facet.size(); ++k)
        edges.push_back(std::minmax(facet[k], facet[(k + 1) % facet.size()]));
    }
    draw_edges(std::move(edges), [&](std::uint32_t i) { return hull.vertex(i); });
  }

  void draw(const Mesh& mesh) {
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles().size());
    for (const TriangleIndices& t : mesh.triangles()) {
      for (std::size_t k = 0; k < 3; ++k)
        edges.push_back(std::minmax(t[k], t[(k + 1) % 3]));
    }
    draw_edges(std::move(edges), [&](std::uint32_t i) { return mesh.vertices()[i]; });
  }

  /// Draws each edge of the triangles once, as for their mesh.
  void draw(const HeightField& field) {
    const auto is_cell = [&](std::int64_t c, std::int64_t r) {
      return c >= 0 && r >= 0 && c + 1 < field.columns() && r + 1 < field.rows() &&
             !field.is_hole(static_cast<std::uint32_t>(c), static_cast<std::uint32_t>(r));
    };
    for (std::uint32_t r = 0; r < field.rows(); ++r) {
      for (std::uint32_t c = 0; c < field.columns(); ++c) {
        const Vector3d from = field.vertex(c, r);
        const std::int64_t column = c, row = r;
        if (is_cell(column, row) || is_cell(column, row - 1)) line(from, field.vertex(c + 1, r));
        if (is_cell(column, row) || is_cell(column - 1, row)) line(from, field.vertex(c, r + 1));
        if (is_cell(column, row)) line(from, field.vertex(c + 1, r + 1));
      }
    }
  }

  /// Draws a square about the point of the plane that is nearest to the frame's origin, its
  /// diagonals, and its normal.
  void draw(const HalfSpace& half_space) {
    const Vector3d& normal = half_space.normal;
    const Vector3d middle = half_space.offset * normal;
    const Vector3d aside = settings_.half_space_extent * normal.unitOrthogonal();
    const Vector3d across = normal.cross(aside);
    const std::array<Vector3d, 4> corners = {middle + aside + across, middle + aside - across,
                                             middle - aside - across, middle - aside + across};
    for (std::size_t i = 0; i < 4; ++i)
      line(corners[i], corners[(i + 1) % 4]);
    line(corners[0], corners[2]);
    line(corners[1], corners[3]);
    line(middle, middle + normal * (settings_.half_space_extent / 4));
  }

  /// Draws the same square as for a half-space, and both normals.
  void draw(const Plane& plane) {
    draw(HalfSpace{plane.normal, plane.offset});
    const Vector3d middle = plane.offset * plane.normal;
    line(middle, middle - plane.normal * (settings_.half_space_extent / 4));
  }

 private:
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  void line(const Vector3d& from, const Vector3d& to) { take_(pose_ * from, pose_ * to); }

  /// Draws an arc from `middle + u` towards `middle + v`, of a share of a full turn.
  void arc(const Vector3d& middle, const Vector3d& u, const Vector3d& v, double turns) {
    const auto count =
        static_cast<std::size_t>(std::ceil(turns * static_cast<double>(settings_.segments)));
    Vector3d last = middle + u;
    for (std::size_t i = 1; i <= count; ++i) {
      const double angle =
          2 * std::numbers::pi * turns * static_cast<double>(i) / static_cast<double>(count);
      const Vector3d next = middle + std::cos(angle) * u + std::sin(angle) * v;
      line(last, next);
      last = next;
    }
  }

  void circle(const Vector3d& middle, double radius) {
    arc(middle, radius * Vector3d::UnitX(), radius * Vector3d::UnitY(), 1);
  }

  static std::array<Vector3d, 4> sides(double radius) {
    return {radius * Vector3d::UnitX(), radius * Vector3d::UnitY(), -radius * Vector3d::UnitX(),
            -radius * Vector3d::UnitY()};
  }

  template <typename Vertex>
  void draw_edges(std::vector<Edge> edges, const Vertex& vertex) {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [from, to] : edges)
      line(vertex(from), vertex(to));
  }

  const Pose& pose_;
  const WorldDrawingSettings& settings_;
  const TakeLine& take_;
};

}  // namespace

void outline(const PlacedShapeView& shape, const WorldDrawingSettings& settings,
             const TakeLine& take) {
  Outline drawing(shape.pose, settings, take);
  std::visit([&](const auto& which) { drawing.draw(which); }, shape.shape.value());
}

void outline(const Aabb& box, const TakeLine& take) {
  const auto corner = [&](unsigned which) {
    Vector3d point;
    for (int i = 0; i < 3; ++i)
      point[i] = (which >> i & 1) != 0 ? box.max[i] : box.min[i];
    return point;
  };
  for (unsigned from = 0; from < 8; ++from) {
    for (unsigned axis = 1; axis < 8; axis *= 2)
      if ((from & axis) == 0) take(corner(from), corner(from | axis));
  }
}

}  // namespace graze
