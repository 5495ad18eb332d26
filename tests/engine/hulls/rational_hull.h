#pragma once

// The convex hull of a few points by its definition, in rational numbers: a plane through three of
// them with all others on one side bounds it. Shares nothing with the library.

#include <graze/bvh/pose.h>

#include <gmpxx.h>

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace graze::tests {

struct RationalPoint {
  std::array<mpq_class, 3> at;
};

RationalPoint rational(const Eigen::Vector3d& point);

/// R p + t, not rounded.
RationalPoint placed(const Pose& pose, const Eigen::Vector3d& point);

class RationalHull {
 public:
  /// O(n^4) for n points.
  explicit RationalHull(std::vector<RationalPoint> points);

  struct Facet {
    RationalPoint normal;              ///< outward, of any length
    mpq_class offset;                  ///< the hull has normal . x <= offset
    Eigen::Vector3d unit_normal;       ///< rounded
    std::vector<std::size_t> corners;  ///< all of the points that are in the plane
  };

  /// None if the points lie in a plane.
  const std::vector<Facet>& facets() const { return facets_; }
  const std::vector<RationalPoint>& points() const { return points_; }

  /// Those that are no convex combination of others: they lie in three of the facets' planes.
  std::vector<std::size_t> corners() const;

  bool holds(const RationalPoint& p) const;

  /// How far a point is from the facet, rounded.
  double distance(const Facet& facet, const RationalPoint& p) const;

  /// How far a point is from the boundary, rounded.
  double distance_to_boundary(const RationalPoint& p) const;

  /// 0 if it is inside.
  double distance(const RationalPoint& p) const;

 private:
  std::vector<RationalPoint> points_;
  std::vector<Facet> facets_;
};

/// The line o + s d beside a hull.
struct LinePassage {
  bool is_hit;
  double enter, exit;  ///< s, rounded, if it is hit
  /// How far a parallel line may be from this one before it misses, or hits: of the hull's shadow
  /// along the line, the distance of the line to its outline. Not more than that for a hit.
  double margin;
};
LinePassage pass(const RationalHull& hull, const Eigen::Vector3d& origin,
                 const Eigen::Vector3d& direction);

}  // namespace graze::tests
