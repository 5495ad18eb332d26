#include <graze/engine/mesh/io/polygon.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

// Ear clipping needs no proof that the polygon is simple. However n corners are cut into n - 2
// triangles, in the projection each point is covered by as many left-turning triangles, less
// right-turning ones, as the outline winds around it. If no triangle turns right, the triangles
// therefore cover just the points that the outline winds around, each that many times: a simple
// polygon exactly once. A triangle without area adds nothing: the segment that it is lies in its
// other two edges, so by induction over the cuts in the outline or in other triangles.

namespace graze::mesh_io {
namespace {

using narrowphase::orientation_2d;
using narrowphase::Point2;
using narrowphase::Sign;

Eigen::Vector3d newell_normal(std::span<const Eigen::Vector3d> vertices,
                              std::span<const std::uint32_t> corners, double factor, double scale) {
  const Eigen::Vector3d origin = vertices[corners[0]] * factor;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d from = (vertices[corners[1]] * factor - origin) * scale;
  for (const std::uint32_t corner : corners.subspan(2)) {
    const Eigen::Vector3d to = (vertices[corner] * factor - origin) * scale;
    normal += from.cross(to);
    from = to;
  }
  return normal;
}

double largest_difference(std::span<const Eigen::Vector3d> vertices,
                          std::span<const std::uint32_t> corners, double factor) {
  const Eigen::Vector3d origin = vertices[corners[0]] * factor;
  double largest = 0;
  for (const std::uint32_t corner : corners) {
    largest = std::max(largest, (vertices[corner] * factor - origin).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// Returns twice the area in each coordinate plane, up to a common factor: differences are scaled
/// to about one, by a power of two, so that no product overflows, nor underflows if it matters. It
/// only chooses a plane and a first guess at the side: rounding costs time at worst.
Eigen::Vector3d scaled_areas(std::span<const Eigen::Vector3d> vertices,
                             std::span<const std::uint32_t> corners) {
  constexpr int kLargestExponent = 1000;
  double factor = 1;
  double largest = largest_difference(vertices, corners, factor);
  if (!std::isfinite(largest)) {
    factor = 0.5;
    largest = largest_difference(vertices, corners, factor);
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  exponent = std::clamp(exponent, -kLargestExponent, kLargestExponent);
  return newell_normal(vertices, corners, factor, std::ldexp(1.0, -exponent));
}

bool is_equal(Point2 a, Point2 b) {
  return a.x == b.x && a.y == b.y;
}

void write_fan(std::span<const std::uint32_t> corners, std::span<TriangleIndices> triangles) {
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    triangles[i] = {corners[0], corners[i + 1], corners[i + 2]};
  }
}

}  // namespace

void Triangulator::triangulate(std::span<const Eigen::Vector3d> vertices,
                               std::span<const std::uint32_t> corners,
                               std::span<TriangleIndices> triangles) {
  if (corners.size() == 3) {
    write_fan(corners, triangles);
    return;
  }
  const Eigen::Vector3d areas = scaled_areas(vertices, corners);
  Eigen::Index axis = 0;
  if (areas.cwiseAbs().maxCoeff(&axis) == 0) {
    write_fan(corners, triangles);
    return;
  }
  points_.clear();
  for (const std::uint32_t corner : corners) {
    points_.push_back(narrowphase::project(vertices[corner].data(), static_cast<int>(axis)));
  }
  if (is_fan_of_one_turn()) {
    write_fan(corners, triangles);
    return;
  }
  // Left must be the inside. Where the guess is wrong, for a sliver, clipping gets stuck.
  if (areas[axis] < 0) mirror();
  bool is_clipped = clip_ears();
  if (!is_clipped) {
    mirror();
    is_clipped = clip_ears();
  }
  if (!is_clipped) {
    write_fan(corners, triangles);
    return;
  }
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    triangles[i] = {corners[cuts_[i][0]], corners[cuts_[i][1]], corners[cuts_[i][2]]};
  }
}

bool Triangulator::is_fan_of_one_turn() const {
  const Sign first = orientation_2d(points_[0], points_[1], points_[2]);
  if (first == Sign::Zero) return false;
  for (std::size_t i = 2; i + 1 < points_.size(); ++i) {
    if (orientation_2d(points_[0], points_[i], points_[i + 1]) != first) return false;
  }
  return true;
}

/// Turns left into right, without rounding.
void Triangulator::mirror() {
  for (Point2& point : points_)
    std::swap(point.x, point.y);
}

/// Fills cuts_ with triangles of which none turns right and some turn left, or returns false.
bool Triangulator::clip_ears() {
  link();
  auto left = static_cast<std::uint32_t>(points_.size());
  std::uint32_t corner = cut_folds(left);
  mark_ears(corner, left);
  bool has_area = false;
  while (left > 3) {
    if (!find_corner_to_cut(corner, left)) return false;
    has_area = has_area || is_ear_[corner];
    cut_off(corner);
    --left;
    corner = next_[next_[corner]];  // not the neighbour: else all triangles would share a corner
  }
  cuts_.push_back({previous_[corner], corner, next_[corner]});
  const Sign last = turn(corner);
  return last == Sign::Positive || (last == Sign::Zero && has_area);
}

/// Makes a ring of all corners.
void Triangulator::link() {
  const auto count = static_cast<std::uint32_t>(points_.size());
  previous_.resize(count);
  next_.resize(count);
  cuts_.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    previous_[i] = i == 0 ? count - 1 : i - 1;
    next_[i] = i + 1 == count ? 0 : i + 1;
  }
}

/// Cuts off repeated corners and tips of spikes, which have no area but would seem to turn once
/// their neighbours are cut. Returns a corner that is left.
std::uint32_t Triangulator::cut_folds(std::uint32_t& left) {
  std::uint32_t corner = 0;
  for (std::uint32_t unseen = left; unseen > 0 && left > 3;) {
    if (is_fold(corner)) {
      unlink(corner);
      --left;
      ++unseen;  // both neighbours are to be seen again
      corner = previous_[corner];
    } else {
      --unseen;
      corner = next_[corner];
    }
  }
  return corner;
}

void Triangulator::mark_ears(std::uint32_t corner, std::uint32_t left) {
  blockers_.clear();
  is_ear_.assign(points_.size(), false);
  for (std::uint32_t i = 0; i < left; ++i, corner = next_[corner]) {
    if (turn(corner) != Sign::Positive) blockers_.push_back(corner);
  }
  for (std::uint32_t i = 0; i < left; ++i, corner = next_[corner])
    is_ear_[corner] = is_ear(corner);
}

/// Finds the first ear from `corner` on; if there is none, the first corner without area, which
/// only repeated or folded outlines leave to the end.
bool Triangulator::find_corner_to_cut(std::uint32_t& corner, std::uint32_t left) const {
  for (std::uint32_t i = 0; i < left; ++i, corner = next_[corner]) {
    if (is_ear_[corner]) return true;
  }
  for (std::uint32_t i = 0; i < left; ++i, corner = next_[corner]) {
    if (turn(corner) == Sign::Zero) return true;
  }
  return false;
}

void Triangulator::unlink(std::uint32_t corner) {
  cuts_.push_back({previous_[corner], corner, next_[corner]});
  next_[previous_[corner]] = next_[corner];
  previous_[next_[corner]] = previous_[corner];
}

/// Cuts off a corner. Only the two neighbours can become ears or cease to be: for any other corner
/// the diagonal that cuts it off is the same one, in a smaller polygon.
void Triangulator::cut_off(std::uint32_t corner) {
  unlink(corner);
  const std::uint32_t before = previous_[corner];
  const std::uint32_t after = next_[corner];
  const auto is_done = [&](std::uint32_t blocker) {
    if (blocker == corner) return true;
    return (blocker == before || blocker == after) && turn(blocker) == Sign::Positive;
  };
  std::erase_if(blockers_, is_done);
  is_ear_[before] = is_ear(before);
  is_ear_[after] = is_ear(after);
}

/// True if the outline stands still here or goes back the way it came.
bool Triangulator::is_fold(std::uint32_t corner) const {
  if (turn(corner) != Sign::Zero) return false;
  const Point2 a = points_[previous_[corner]], b = points_[corner], c = points_[next_[corner]];
  const auto is_between = [](double from, double at, double to) {
    return (from < at && at < to) || (from > at && at > to);
  };
  return !is_between(a.x, b.x, c.x) && !is_between(a.y, b.y, c.y);
}

Sign Triangulator::turn(std::uint32_t corner) const {
  return orientation_2d(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
}

/// True if the corner turns left and its triangle has no other corner in it. It suffices to look at
/// corners that do not turn left: a triangle that any corner lies in has one of these in it.
bool Triangulator::is_ear(std::uint32_t corner) const {
  if (turn(corner) != Sign::Positive) return false;
  const Cut cut{previous_[corner], corner, next_[corner]};
  const Point2 a = points_[cut[0]], b = points_[cut[1]], c = points_[cut[2]];
  const double min_x = std::min({a.x, b.x, c.x}), max_x = std::max({a.x, b.x, c.x});
  const double min_y = std::min({a.y, b.y, c.y}), max_y = std::max({a.y, b.y, c.y});
  for (const std::uint32_t blocker : blockers_) {
    const Point2 p = points_[blocker];
    if (p.x < min_x || p.x > max_x || p.y < min_y || p.y > max_y) continue;
    if (blocks(blocker, cut)) return false;
  }
  return true;
}

/// True if the corner lies in the closed triangle, other than in one of its corners: there an
/// outline that is joined to its holes passes by.
bool Triangulator::blocks(std::uint32_t corner, const Cut& cut) const {
  const Point2 p = points_[corner];
  const Point2 a = points_[cut[0]], b = points_[cut[1]], c = points_[cut[2]];
  if (is_equal(p, a) || is_equal(p, b) || is_equal(p, c)) return false;
  return orientation_2d(a, b, p) != Sign::Negative && orientation_2d(b, c, p) != Sign::Negative &&
         orientation_2d(c, a, p) != Sign::Negative;
}

}  // namespace graze::mesh_io
