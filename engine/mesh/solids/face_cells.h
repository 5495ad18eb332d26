#pragma once

// This is private to engine/mesh.

#include <graze/narrowphase/ray/rational_sample.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// Homogeneous coordinates in a plane that is projected along an axis: those of a point, (u, v) / w
/// with w > 0, or of a line, which holds the points whose scalar product with it is 0.
struct PlaneTriple {
  narrowphase::GrowingInteger u, v, w;
};

/// The section in which a triangle meets a plane. If that is one point, both ends are, and the line
/// is zero.
struct PlaneSection {
  PlaneTriple from, to;
  PlaneTriple line;
};

/// The cells into which triangles that meet it divide a triangle with area, exactly: open pieces
/// that no section of another triangle, and no edge of one in the same plane, goes into. What is
/// beside one point of a cell, on one side of the plane, is beside all of its points there.
class FaceCells {
 public:
  using Visit = std::function<bool(const narrowphase::RationalPoint&)>;

  /// Divides `face` by the others. Triangles without area divide nothing.
  FaceCells(const Triangle& face, std::span<const Triangle> others);

  /// Calls `visit(point)` for points inside the face, one at least of each cell, until it returns
  /// true. Returns false if it never does. It computes in integers, and takes O(n^2) for n
  /// triangles, and O(n) more for each piece of a section between two others.
  bool any(const Visit& visit) const;

 private:
  using Point = std::array<narrowphase::GrowingInteger, 3>;

  Point point_of(const Eigen::Vector3d& corner) const;
  PlaneTriple spot_of(const Point& point, const narrowphase::GrowingInteger& weight) const;
  narrowphase::GrowingInteger height_of(const Point& point) const;
  void add_sections_of(const Triangle& other);
  bool is_in_face(const PlaneTriple& spot, bool are_edges_in) const;
  std::vector<PlaneTriple> cuts_of(const PlaneSection& section) const;
  std::optional<PlaneTriple> next_along_u(const PlaneTriple& spot) const;
  narrowphase::RationalPoint in_space(const PlaneTriple& spot) const;

  int unit_ = 0;  ///< coordinates are counted in 2^unit
  std::array<Point, 3> corners_;
  Point normal_;
  std::size_t axis_ = 0;  ///< the axis of the projection, in which the face has area
  std::vector<PlaneSection> sections_;
};

}  // namespace graze
