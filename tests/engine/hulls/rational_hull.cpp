#include "tests/engine/hulls/rational_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace graze::tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {{a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2]}};
}

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  RationalPoint c;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    c.at[k] = a.at[u] * b.at[v] - a.at[v] * b.at[u];
  }
  return c;
}

mpq_class dot(const RationalPoint& a, const RationalPoint& b) {
  return a.at[0] * b.at[0] + a.at[1] * b.at[1] + a.at[2] * b.at[2];
}

/// Scaled in rationals, so that no square overflows or vanishes.
Eigen::Vector3d unit(const RationalPoint& n) {
  mpq_class most = 0;
  for (const mpq_class& c : n.at)
    most = std::max<mpq_class>(most, abs(c));
  Eigen::Vector3d v;
  for (std::size_t k = 0; k < 3; ++k)
    v[static_cast<int>(k)] = mpq_class(n.at[k] / most).get_d();
  return v.normalized();
}

/// The root of a rational number whose double may vanish or overflow.
double root(const mpq_class& square) {
  if (square == 0) return 0;
  const long bits = static_cast<long>(mpz_sizeinbase(square.get_num_mpz_t(), 2)) -
                    static_cast<long>(mpz_sizeinbase(square.get_den_mpz_t(), 2));
  const long half = bits / 2;
  mpq_class scaled = square;
  if (half > 0) scaled /= mpq_class(mpz_class(1) << static_cast<unsigned long>(2 * half));
  if (half < 0) scaled *= mpq_class(mpz_class(1) << static_cast<unsigned long>(-2 * half));
  return std::ldexp(std::sqrt(scaled.get_d()), static_cast<int>(half));
}

mpq_class squared_to_segment(const RationalPoint& p, const RationalPoint& a,
                             const RationalPoint& b) {
  const RationalPoint along = minus(b, a), way = minus(p, a);
  const mpq_class length = dot(along, along);
  mpq_class share = length == 0 ? mpq_class(0) : mpq_class(dot(way, along) / length);
  share = std::clamp<mpq_class>(share, 0, 1);
  RationalPoint rest;
  for (std::size_t k = 0; k < 3; ++k)
    rest.at[k] = way.at[k] - share * along.at[k];
  return dot(rest, rest);
}

mpq_class squared_to_triangle(const RationalPoint& p, const RationalPoint& a,
                              const RationalPoint& b, const RationalPoint& c) {
  const RationalPoint normal = cross(minus(b, a), minus(c, a));
  const auto is_left = [&](const RationalPoint& from, const RationalPoint& to) {
    return dot(cross(minus(to, from), minus(p, from)), normal) >= 0;
  };
  const mpq_class square = dot(normal, normal);
  if (square > 0 && is_left(a, b) && is_left(b, c) && is_left(c, a)) {
    const mpq_class height = dot(normal, minus(p, a));
    return height * height / square;
  }
  return std::min(
      {squared_to_segment(p, a, b), squared_to_segment(p, b, c), squared_to_segment(p, c, a)});
}

}  // namespace

RationalPoint rational(const Eigen::Vector3d& point) {
  return {{mpq_class(point.x()), mpq_class(point.y()), mpq_class(point.z())}};
}

RationalPoint placed(const Pose& pose, const Eigen::Vector3d& point) {
  RationalPoint result = rational(pose.translation());
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      result.at[static_cast<std::size_t>(i)] += mpq_class(pose.linear()(i, j)) * point[j];
  }
  return result;
}

RationalHull::RationalHull(std::vector<RationalPoint> points) : points_(std::move(points)) {
  const std::size_t n = points_.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = j + 1; k < n; ++k) {
        RationalPoint normal = cross(minus(points_[j], points_[i]), minus(points_[k], points_[i]));
        if (dot(normal, normal) == 0) continue;
        const mpq_class offset = dot(normal, points_[i]);
        int above = 0, below = 0;
        std::vector<std::size_t> in_plane;
        for (std::size_t l = 0; l < n && (above == 0 || below == 0); ++l) {
          const mpq_class height = dot(normal, points_[l]) - offset;
          above += height > 0;
          below += height < 0;
          if (height == 0) in_plane.push_back(l);
        }
        if ((above == 0) == (below == 0)) continue;
        const bool is_known = std::any_of(facets_.begin(), facets_.end(),
                                          [&](const Facet& f) { return f.corners == in_plane; });
        if (is_known) continue;
        const int sign = above == 0 ? 1 : -1;
        for (mpq_class& c : normal.at)
          c *= sign;
        const Eigen::Vector3d rounded = unit(normal);
        facets_.push_back({std::move(normal), offset * sign, rounded, std::move(in_plane)});
      }
    }
  }
}

std::vector<std::size_t> RationalHull::corners() const {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    // Of equal points the first.
    const auto is_equal = [&](const RationalPoint& p) { return p.at == points_[i].at; };
    const auto end = points_.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(points_.begin(), end, is_equal)) continue;
    const auto planes = std::count_if(facets_.begin(), facets_.end(), [&](const Facet& f) {
      return std::binary_search(f.corners.begin(), f.corners.end(), i);
    });
    if (planes >= 3) found.push_back(i);
  }
  return found;
}

bool RationalHull::holds(const RationalPoint& p) const {
  return std::all_of(facets_.begin(), facets_.end(),
                     [&](const Facet& f) { return dot(f.normal, p) <= f.offset; });
}

double RationalHull::distance(const Facet& facet, const RationalPoint& p) const {
  std::optional<mpq_class> least;
  const std::vector<std::size_t>& at = facet.corners;
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t j = i + 1; j < at.size(); ++j) {
      for (std::size_t k = j + 1; k < at.size(); ++k) {
        mpq_class square = squared_to_triangle(p, points_[at[i]], points_[at[j]], points_[at[k]]);
        if (!least || square < *least) least = std::move(square);
      }
    }
  }
  return root(*least);
}

double RationalHull::distance_to_boundary(const RationalPoint& p) const {
  double least = kInfinity;
  for (const Facet& facet : facets_)
    least = std::min(least, distance(facet, p));
  return least;
}

double RationalHull::distance(const RationalPoint& p) const {
  return holds(p) ? 0 : distance_to_boundary(p);
}

namespace {

/// The points as the line sees them: along two axes at right angles to it, in double.
std::vector<Eigen::Vector2d> shadow(const RationalHull& hull, const Eigen::Vector3d& origin,
                                    const Eigen::Vector3d& direction) {
  const Eigen::Vector3d d = direction.normalized();
  const Eigen::Vector3d e = d.unitOrthogonal(), f = d.cross(e).normalized();
  // The dual of e and f in the frame (d, e, f), so that the line itself is exactly at 0.
  const RationalPoint exact_d = rational(direction);
  const RationalPoint along_e = cross(rational(f), exact_d), along_f = cross(exact_d, rational(e));
  const mpq_class volume_e = dot(along_e, rational(e)), volume_f = dot(along_f, rational(f));
  std::vector<Eigen::Vector2d> seen;
  for (const RationalPoint& p : hull.points()) {
    const RationalPoint way = minus(p, rational(origin));
    seen.emplace_back(mpq_class(dot(along_e, way) / volume_e).get_d(),
                      mpq_class(dot(along_f, way) / volume_f).get_d());
  }
  return seen;
}

double to_segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d along = b - a;
  const double length = along.squaredNorm();
  const double share = length > 0 ? std::clamp(-a.dot(along) / length, 0.0, 1.0) : 0;
  return (a + along * share).norm();
}

}  // namespace

LinePassage pass(const RationalHull& hull, const Eigen::Vector3d& origin,
                 const Eigen::Vector3d& direction) {
  const RationalPoint o = rational(origin), d = rational(direction);
  std::optional<mpq_class> enter, exit;
  bool is_beside = false;
  for (const RationalHull::Facet& f : hull.facets()) {
    const mpq_class slope = dot(f.normal, d), room = f.offset - dot(f.normal, o);
    if (slope == 0) {
      is_beside |= room < 0;
      continue;
    }
    const mpq_class s = room / slope;
    if (slope < 0 && (!enter || s > *enter)) enter = s;
    if (slope > 0 && (!exit || s < *exit)) exit = s;
  }
  LinePassage passage{!is_beside && enter && exit && *enter <= *exit, 0, 0, kInfinity};
  if (passage.is_hit) passage.enter = enter->get_d(), passage.exit = exit->get_d();

  const std::vector<Eigen::Vector2d> seen = shadow(hull, origin, direction);
  double size = 0;
  for (const Eigen::Vector2d& p : seen)
    size = std::max(size, p.norm());
  for (const Eigen::Vector2d& a : seen) {
    for (const Eigen::Vector2d& b : seen) {
      if (!passage.is_hit) {
        passage.margin = std::min(passage.margin, to_segment(a, b));
        continue;
      }
      const Eigen::Vector2d along = b - a;
      if (!(along.norm() > 0)) continue;
      const Eigen::Vector2d out = Eigen::Vector2d(along.y(), -along.x()).normalized();
      const bool is_edge = std::all_of(seen.begin(), seen.end(), [&](const Eigen::Vector2d& p) {
        return out.dot(p - a) <= 0x1p-48 * size;
      });
      if (is_edge) passage.margin = std::min(passage.margin, std::max(out.dot(a), 0.0));
    }
  }
  return passage;
}

}  // namespace graze::tests
