// Let the plane have coordinates u and v. From a point of a cell, at a level v at which no section
// begins, ends, meets another one or lies along u, go towards lower u until a section is met:
// beyond the piece of that between two others lies the cell, all along it. So from the middle of
// each such piece a line goes towards higher u until it meets another section, and half-way there
// is a point of a cell, one at least of each. Sections that are points are met like others, so that
// no such point is one of them.

#include <graze/engine/mesh/solids/face_cells.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>

#include <algorithm>
#include <optional>

namespace graze {
namespace {

using narrowphase::Sign;
using Integer = narrowphase::GrowingInteger;

/// A coordinate of a triple, u or v.
using Coordinate = Integer PlaneTriple::*;

Sign compare(const PlaneTriple& s, const PlaneTriple& t, Coordinate of) {
  return (s.*of * t.w - t.*of * s.w).sign();
}

/// True if the section lies along u, or is a point.
bool is_along_u(const PlaneSection& section) {
  return section.line.u.is_zero();
}

PlaneTriple line_through(const PlaneTriple& s, const PlaneTriple& t) {
  return {s.v * t.w - s.w * t.v, s.w * t.u - s.u * t.w, s.u * t.v - s.v * t.u};
}

PlaneTriple middle_of(const PlaneTriple& s, const PlaneTriple& t) {
  const Integer weight = s.w * t.w;
  return {s.u * t.w + t.u * s.w, s.v * t.w + t.v * s.w, weight + weight};
}

Integer height_above(const PlaneTriple& line, const PlaneTriple& spot) {
  return line.u * spot.u + line.v * spot.v + line.w * spot.w;
}

/// Returns where height is 0 between two points whose heights have opposite signs, or one of them
/// is 0.
PlaneTriple spot_between(const PlaneTriple& s, const Integer& height_s, const PlaneTriple& t,
                         const Integer& height_t) {
  PlaneTriple spot{s.u * height_t - t.u * height_s, s.v * height_t - t.v * height_s,
                   s.w * height_t - t.w * height_s};
  if (spot.w.sign() == Sign::Negative) spot = {-spot.u, -spot.v, -spot.w};
  return spot;
}

/// Calls `visit(spot)` for the points in which the section meets a line, by the heights of its ends
/// above that; for both ends if it lies along it.
template <typename Visit>
void for_meetings(const PlaneSection& section, const Integer& height_from, const Integer& height_to,
                  const Visit& visit) {
  if (height_from.is_zero()) visit(section.from);
  if (height_to.is_zero()) visit(section.to);
  if (static_cast<int>(height_from.sign()) * static_cast<int>(height_to.sign()) < 0)
    visit(spot_between(section.from, height_from, section.to, height_to));
}

}  // namespace

FaceCells::FaceCells(const Triangle& face, std::span<const Triangle> others) {
  narrowphase::CommonUnit unit({0.0});
  const auto include = [&](const Triangle& triangle) {
    for (const Eigen::Vector3d* corner : {&triangle.a, &triangle.b, &triangle.c})
      unit.include(corner->data(), 3);
  };
  include(face);
  for (const Triangle& other : others)
    include(other);
  unit_ = unit.exponent();
  corners_ = {point_of(face.a), point_of(face.b), point_of(face.c)};
  const auto edge = [&](std::size_t corner, std::size_t k) {
    return corners_[corner][k] - corners_[0][k];
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
    normal_[k] = edge(1, x) * edge(2, y) - edge(1, y) * edge(2, x);
    if (!normal_[k].is_zero()) axis_ = k;
  }
  add_sections_of(face);
  for (const Triangle& other : others) {
    if (!narrowphase::is_degenerate(other)) add_sections_of(other);
  }
}

FaceCells::Point FaceCells::point_of(const Eigen::Vector3d& corner) const {
  Point point;
  for (std::size_t k = 0; k < 3; ++k)
    point[k] = Integer::from_double(corner.data()[k], unit_);
  return point;
}

PlaneTriple FaceCells::spot_of(const Point& point, const Integer& weight) const {
  return {point[(axis_ + 1) % 3], point[(axis_ + 2) % 3], weight};
}

/// Returns the height above the plane of the face, times a positive number.
Integer FaceCells::height_of(const Point& point) const {
  Integer sum;
  for (std::size_t k = 0; k < 3; ++k)
    sum = sum + normal_[k] * (point[k] - corners_[0][k]);
  return sum;
}

/// Adds the sections of a triangle: its edges if it lies in the plane, else one section, or none.
void FaceCells::add_sections_of(const Triangle& other) {
  const auto add = [&](const PlaneTriple& from, const PlaneTriple& to) {
    sections_.push_back({from, to, line_through(from, to)});
  };
  std::array<PlaneTriple, 3> spots;
  std::array<Integer, 3> heights;
  const Eigen::Vector3d* const corners[3] = {&other.a, &other.b, &other.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Point corner = point_of(*corners[i]);
    spots[i] = spot_of(corner, Integer(1));
    heights[i] = height_of(corner);
  }
  std::vector<PlaneTriple> met;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    if (heights[i].is_zero()) met.push_back(spots[i]);
    if (static_cast<int>(heights[i].sign()) * static_cast<int>(heights[next].sign()) < 0)
      met.push_back(spot_between(spots[i], heights[i], spots[next], heights[next]));
  }
  if (met.size() == 3) {
    for (std::size_t i = 0; i < 3; ++i)
      add(met[i], met[(i + 1) % 3]);
  } else if (!met.empty()) {
    add(met.front(), met.back());
  }
}

bool FaceCells::is_in_face(const PlaneTriple& spot, bool are_edges_in) const {
  const Sign inner = normal_[axis_].sign();
  for (std::size_t i = 0; i < 3; ++i) {
    const Sign side = height_above(sections_[i].line, spot).sign();
    if (side == -inner || (side == Sign::Zero && !are_edges_in)) return false;
  }
  return true;
}

/// Returns for a section that is not along u its ends, and where others meet it, by v.
std::vector<PlaneTriple> FaceCells::cuts_of(const PlaneSection& section) const {
  const auto is_before = [](const PlaneTriple& s, const PlaneTriple& t) {
    return compare(s, t, &PlaneTriple::v) == Sign::Negative;
  };
  const auto [low, high] = std::minmax(section.from, section.to, is_before);
  std::vector<PlaneTriple> cuts{low, high};
  for (const PlaneSection& other : sections_) {
    const Integer from = height_above(section.line, other.from);
    const Integer to = height_above(section.line, other.to);
    for_meetings(other, from, to, [&](const PlaneTriple& spot) {
      if (is_before(cuts[0], spot) && is_before(spot, cuts[1])) cuts.push_back(spot);
    });
  }
  std::sort(cuts.begin(), cuts.end(), is_before);
  const auto are_same = [](const PlaneTriple& s, const PlaneTriple& t) {
    return compare(s, t, &PlaneTriple::v) == Sign::Zero;
  };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), are_same), cuts.end());
  return cuts;
}

bool FaceCells::any(const Visit& visit) const {
  for (const PlaneSection& section : sections_) {
    if (is_along_u(section)) continue;
    const std::vector<PlaneTriple> cuts = cuts_of(section);
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const PlaneTriple middle = middle_of(cuts[i - 1], cuts[i]);
      if (!is_in_face(middle, true)) continue;
      const std::optional<PlaneTriple> end = next_along_u(middle);
      if (!end) continue;
      const PlaneTriple spot = middle_of(middle, *end);
      if (is_in_face(spot, false) && visit(in_space(spot))) return true;
    }
  }
  return false;
}

/// Returns the first point beyond a spot at which a section meets the line through it along u.
std::optional<PlaneTriple> FaceCells::next_along_u(const PlaneTriple& spot) const {
  std::optional<PlaneTriple> next;
  const auto meet = [&](const PlaneTriple& at) {
    const bool is_beyond = compare(at, spot, &PlaneTriple::u) == Sign::Positive;
    if (is_beyond && (!next || compare(at, *next, &PlaneTriple::u) == Sign::Negative)) next = at;
  };
  const auto height = [&](const PlaneTriple& at) { return at.v * spot.w - spot.v * at.w; };
  for (const PlaneSection& section : sections_)
    for_meetings(section, height(section.from), height(section.to), meet);
  return next;
}

/// Returns a spot in space: the third coordinate follows from the plane.
narrowphase::RationalPoint FaceCells::in_space(const PlaneTriple& spot) const {
  const std::size_t x = (axis_ + 1) % 3, y = (axis_ + 2) % 3;
  const auto from_corner = [&](const Integer& at, std::size_t k) {
    return at - corners_[0][k] * spot.w;
  };
  const Integer slope = normal_[x] * from_corner(spot.u, x) + normal_[y] * from_corner(spot.v, y);
  narrowphase::RationalPoint point;
  point.at[x] = normal_[axis_] * spot.u;
  point.at[y] = normal_[axis_] * spot.v;
  point.at[axis_] = normal_[axis_] * corners_[0][axis_] * spot.w - slope;
  point.weight = normal_[axis_] * spot.w;
  point.unit = unit_;
  if (point.weight.sign() == Sign::Negative) {
    point.weight = -point.weight;
    for (Integer& at : point.at)
      at = -at;
  }
  return point;
}

}  // namespace graze
