#include <graze/engine/mesh/contacts/contact_normal.h>
#include <graze/engine/mesh/contacts/face_normals.h>
#include <graze/engine/mesh/sweep/last_contact.h>
#include <graze/engine/mesh/sweep/sweep.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace graze::contacts {
namespace {

/// Three doubles; the operations are those that are written, in their order.
struct Vector {
  double x = 0, y = 0, z = 0;
};

Vector from(const Eigen::Vector3d& v) {
  return {v.data()[0], v.data()[1], v.data()[2]};
}
Vector operator+(const Vector& u, const Vector& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
Vector operator-(const Vector& u, const Vector& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
Vector operator*(double s, const Vector& v) {
  return {s * v.x, s * v.y, s * v.z};
}
double dot(const Vector& u, const Vector& v) {
  return (u.x * v.x + u.y * v.y) + u.z * v.z;
}
Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}
double length(const Vector& v) {
  return std::sqrt(dot(v, v));
}
double size(const Vector& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// A sum of area vectors, and a bound of its error.
struct Area {
  Vector vector;
  double error = 0;
};

class RegionNormal {
 public:
  RegionNormal(const CellComplex& complex, const std::vector<CurveSteps>& curves,
               const Region& region, const SweepUnits& units)
      : complex_(complex),
        curves_(curves),
        region_(region),
        per_metre_(units.per_metre),
        origin_(scaled(region.nodes.front())) {}

  std::optional<Eigen::Vector3d> by_area() const {
    Area area;
    for (std::uint32_t i : region_.curves)
      add_curve(curves_[i], area);
    const std::vector<bool> is_edge = is_on_curve();
    for (std::size_t i = 0; i < region_.segments.size(); ++i) {
      if (!is_edge[i]) add_edge_of_polygon(complex_.segments[region_.segments[i]], area);
    }
    for (std::uint32_t i : region_.polygons)
      add_polygon(complex_.polygons[i], area);
    if (!(size(area.vector) > 16 * area.error)) return std::nullopt;
    return unit(area.vector);
  }

  std::optional<Eigen::Vector3d> by_faces() const {
    Vector sum;
    for (std::uint32_t i : region_.segments) {
      const Cell& cell = complex_.segments[i];
      const double weight = length(scaled(cell.corner[1]) - scaled(cell.corner[0]));
      sum = sum + weight * between(normals_of(complex_, cell));
    }
    if (region_.segments.empty() && region_.polygons.empty()) {
      for (std::uint32_t i : region_.points)
        sum = sum + at_point(complex_.points[i]);
    }
    return unit(sum);
  }

 private:
  Vector scaled(std::uint32_t node) const {
    return per_metre_ * from(complex_.nodes[node].position);
  }

  static std::optional<Eigen::Vector3d> unit(const Vector& v) {
    if (v.x == 0 && v.y == 0 && v.z == 0) return std::nullopt;
    return unit_direction({v.x, v.y, v.z});
  }

  /// Returns the direction from A to B that the faces of a cell have.
  static Vector between(const CellNormals& normals) {
    const Vector a = (1.0 / normals.count_a) * from(normals.sum_a);
    const Vector b = (1.0 / normals.count_b) * from(normals.sum_b);
    if (normals.count_a == 1 && normals.count_b > 1) return 2 * a;
    if (normals.count_b == 1 && normals.count_a > 1) return Vector{} - 2 * b;
    return a - b;
  }

  Vector at_point(const Cell& cell) const {
    const Vector mean = between(normals_of(complex_, cell));
    const NodeName& name = complex_.nodes[cell.corner[0]].name;
    if (!name.a.is_edge() || !name.b.is_edge()) return mean;
    const Vector across = cross(edge_of(complex_.a, name.a), edge_of(complex_.b, name.b));
    const double side = dot(across, mean);
    if (side == 0) return mean;
    return side > 0 ? across : Vector{} - across;
  }

  Vector edge_of(const PlacedCorners& corners, const FeatureName& edge) const {
    const Vector v = per_metre_ * from(corners.position(edge.corner[1])) -
                     per_metre_ * from(corners.position(edge.corner[0]));
    const double largest = std::max(std::abs(v.x), std::max(std::abs(v.y), std::abs(v.z)));
    return largest == 0 ? v : std::scalbn(1.0, -std::ilogb(largest)) * v;
  }

  /// Adds a triangle with the origin, whose other corners are p and q, times a factor. Scaled
  /// coordinates are below 1 and off by 2 ulp, that is by 2^-51 in each; the differences from the
  /// origin by 2^-49 of two points. A component of the product of p and q is then off by less than
  /// 2^-48 (|p| + |q|), sums of absolute components, and its rounding by far less.
  void add_triangle(const Vector& p, const Vector& q, double factor, Area& area) const {
    area.vector = area.vector + factor * cross(p, q);
    area.error += 0x1p-48 * std::abs(factor) * (size(p) + size(q));
  }

  double vote(const Cell& cell, const Vector& step) const {
    const CellNormals normals = normals_of(complex_, cell);
    return dot(cross(from(normals.sum_a), from(normals.sum_b)), step);
  }

  void add_curve(const CurveSteps& curve, Area& area) const {
    double sense = 0;
    for (const CurveStep& step : curve)
      sense += vote(complex_.segments[step.segment], scaled(step.to) - scaled(step.from));
    if (sense == 0) return;
    for (const CurveStep& step : curve)
      add_triangle(scaled(step.from) - origin_, scaled(step.to) - origin_, sense > 0 ? 1 : -1,
                   area);
  }

  void add_edge_of_polygon(const Cell& cell, Area& area) const {
    const Vector p = scaled(cell.corner[0]);
    const Vector q = scaled(cell.corner[1]);
    const double sense = vote(cell, q - p);
    if (sense != 0) add_triangle(p - origin_, q - origin_, sense > 0 ? 1 : -1, area);
  }

  void add_polygon(const Cell& cell, Area& area) const {
    Area own;
    for (std::uint32_t i = 0; i < cell.count; ++i) {
      add_triangle(scaled(cell.corner[i]) - origin_,
                   scaled(cell.corner[(i + 1) % cell.count]) - origin_, 1, own);
    }
    const CellNormals normals = normals_of(complex_, cell);
    const double side_a = dot(own.vector, from(normals.sum_a));
    const double side_b = dot(own.vector, from(normals.sum_b));
    if ((side_a > 0) == (side_b > 0)) return;
    area.vector = area.vector + (side_a > side_b ? 1 : -1) * own.vector;
    area.error += own.error;
  }

  /// Returns for each segment of the region whether it is on a curve.
  std::vector<bool> is_on_curve() const {
    std::vector<std::uint32_t> on_curves;
    for (std::uint32_t i : region_.curves) {
      for (const CurveStep& step : curves_[i])
        on_curves.push_back(step.segment);
    }
    std::sort(on_curves.begin(), on_curves.end());
    std::vector<bool> is_on;
    for (std::uint32_t segment : region_.segments)
      is_on.push_back(std::binary_search(on_curves.begin(), on_curves.end(), segment));
    return is_on;
  }

  const CellComplex& complex_;
  const std::vector<CurveSteps>& curves_;
  const Region& region_;
  double per_metre_;
  Vector origin_;
};

}  // namespace

Eigen::Vector3d contact_normal(const CellComplex& complex, const std::vector<CurveSteps>& curves,
                               const Region& region, const PlacedMeshView& a,
                               const PlacedMeshView& b, const SweepUnits& units) {
  const RegionNormal normal(complex, curves, region, units);
  if (const auto by_area = normal.by_area()) return *by_area;
  if (const auto by_faces = normal.by_faces()) return *by_faces;
  const Vector offset = 0.5 * from(middle_of(b)) - 0.5 * from(middle_of(a));
  if (offset.x != 0 || offset.y != 0 || offset.z != 0)
    return unit_direction({offset.x, offset.y, offset.z});
  return {complex.b.is_before(complex.a) ? -1.0 : 1.0, 0, 0};
}

}  // namespace graze::contacts
