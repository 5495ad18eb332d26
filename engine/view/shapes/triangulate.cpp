#include <graze/engine/view/shapes/triangulate.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <variant>

namespace graze::view {
namespace {

using Eigen::Vector3d;

/// A point of an outline that turns about the z axis.
struct ProfilePoint {
  double radius;
  double z;
};

/// Makes triangles of one kind of shape after the other.
class Triangulator {
 public:
  explicit Triangulator(const TriangulationSettings& settings) : settings_(settings) {}

  Triangulation operator()(const Sphere& ball) const {
    return (*this)(Ellipsoid{ball.centre, Vector3d::Constant(ball.radius)});
  }

  Triangulation operator()(const Ellipsoid& ball) const {
    std::vector<ProfilePoint> profile;
    add_arc(-0.5, 0.5, 1, 0, profile);
    Triangulation surface = turned(profile);
    for (Vector3d& vertex : surface.vertices)
      vertex = ball.centre + ball.semi_axes.cwiseProduct(vertex);
    return surface;
  }

  Triangulation operator()(const Capsule& capsule) const {
    std::vector<ProfilePoint> profile;
    add_arc(-0.5, 0, capsule.radius, -capsule.half_length, profile);
    if (capsule.half_length == 0)
      profile.pop_back();  // the upper half begins where the lower one
                           // ends
    add_arc(0, 0.5, capsule.radius, capsule.half_length, profile);
    return turned(profile);
  }

  Triangulation operator()(const Cylinder& cylinder) const {
    const double r = cylinder.radius, h = cylinder.half_height;
    return turned(std::vector<ProfilePoint>{{0, -h}, {r, -h}, {r, h}, {0, h}});
  }

  Triangulation operator()(const Cone& cone) const {
    const double h = cone.half_height;
    return turned(std::vector<ProfilePoint>{{0, -h}, {cone.radius, -h}, {0, h}});
  }

  Triangulation operator()(const Box& box) const {
    Triangulation surface;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const auto side = [&](unsigned axis) { return (corner >> axis & 1u) != 0 ? 1.0 : -1.0; };
      surface.vertices.emplace_back(
          box.half_extents.cwiseProduct(Vector3d(side(0), side(1), side(2))));
    }
    surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return surface;
  }

  Triangulation operator()(const ConvexHull& hull) const {
    Triangulation surface;
    for (std::size_t i = 0; i < hull.vertex_count(); ++i)
      surface.vertices.push_back(hull.vertex(i));
    for (std::size_t i = 0; i < hull.facet_count(); ++i) {
      const auto facet = hull.facet(i);
      for (std::size_t k = 2; k < facet.size(); ++k)
        surface.triangles.push_back({facet[0], facet[k - 1], facet[k]});
    }
    return surface;
  }

  /// Triangulates a square about the point of the plane that is nearest to the frame's origin.
  Triangulation operator()(const HalfSpace& half_space) const {
    const Vector3d middle = half_space.offset * half_space.normal;
    const Vector3d aside = settings_.half_space_extent * half_space.normal.unitOrthogonal();
    const Vector3d across = half_space.normal.cross(aside);
    return {{middle - aside - across, middle + aside - across, middle + aside + across,
             middle - aside + across},
            {{0, 1, 2}, {0, 2, 3}},
            true};
  }

  Triangulation operator()(const Plane& plane) const {
    return (*this)(HalfSpace{plane.normal, plane.offset});
  }

  Triangulation operator()(const Mesh& mesh) const { return triangulate(mesh); }

  Triangulation operator()(const HeightField& field) const { return (*this)(field.mesh()); }

 private:
  /// Adds points of a circle about (0, z), from one angle to another, in half turns. Ends at the
  /// axis lie on it.
  void add_arc(double from, double to, double radius, double z,
               std::vector<ProfilePoint>& profile) const {
    const auto count =
        static_cast<unsigned>(std::ceil((to - from) * static_cast<double>(settings_.segments) / 2));
    for (unsigned i = 0; i <= count; ++i) {
      const double half_turns = from + (to - from) * i / count;
      const double angle = std::numbers::pi * half_turns;
      const bool is_pole = std::abs(half_turns) == 0.5;
      profile.push_back({is_pole ? 0 : radius * std::cos(angle), z + radius * std::sin(angle)});
    }
  }

  /// Turns the profile, from below to above, about the z axis. It begins and ends on that axis.
  Triangulation turned(std::span<const ProfilePoint> profile) const {
    Triangulation surface;
    const std::uint32_t n = settings_.segments;
    std::vector<std::uint32_t> first;  // the first vertex of each ring, which at the axis has one
                                       // vertex
    for (const ProfilePoint& point : profile) {
      first.push_back(static_cast<std::uint32_t>(surface.vertices.size()));
      for (std::uint32_t k = 0; k < (point.radius == 0 ? 1 : n); ++k) {
        const double angle = 2 * std::numbers::pi * k / n;
        surface.vertices.emplace_back(point.radius * std::cos(angle),
                                      point.radius * std::sin(angle), point.z);
      }
    }
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
      const bool is_low_pole = profile[i].radius == 0, is_high_pole = profile[i + 1].radius == 0;
      for (std::uint32_t k = 0; k < n; ++k) {
        const std::uint32_t next = (k + 1) % n;
        const std::uint32_t low = first[i] + (is_low_pole ? 0 : k);
        const std::uint32_t low_next = first[i] + (is_low_pole ? 0 : next);
        const std::uint32_t high = first[i + 1] + (is_high_pole ? 0 : k);
        const std::uint32_t high_next = first[i + 1] + (is_high_pole ? 0 : next);
        if (!is_low_pole) surface.triangles.push_back({low, low_next, high_next});
        if (!is_high_pole) surface.triangles.push_back({low, high_next, high});
      }
    }
    return surface;
  }

  const TriangulationSettings& settings_;
};

}  // namespace

Triangulation triangulate(const Mesh& mesh) {
  // Vertices that no triangle has are left out: they may lie anywhere.
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.vertices().size(), kUnused);
  Triangulation surface;
  surface.triangles.reserve(mesh.triangles().size());
  for (TriangleIndices triangle : mesh.triangles()) {
    for (std::uint32_t& index : triangle) {
      std::uint32_t& own = number[index];
      if (own == kUnused) {
        own = static_cast<std::uint32_t>(surface.vertices.size());
        surface.vertices.push_back(mesh.vertices()[index]);
      }
      index = own;
    }
    surface.triangles.push_back(triangle);
  }
  return surface;
}

Triangulation triangulate(const Shape& shape, const TriangulationSettings& settings) {
  return std::visit(Triangulator(settings), shape.value());
}

}  // namespace graze::view
