#pragma once

#include <gmpxx.h>

#include <optional>
#include <vector>

#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>

namespace graze::compare {

/// Finds a short translation of B after which no pair of triangles hits any more. That each pair
/// alone needs little says nothing: all pairs of two cubes pushed into each other along an axis
/// merely touch.
///
/// Directions are tried, not all of them: the axes, normals of triangles that hit, and the shortest
/// translation that parts each pair. Along one of them the answer is exact, in rational numbers:
/// each pair of triangles meets for an interval of lengths, and the first length that no interval
/// goes beyond separates the two. So a length found is always enough, an upper bound of the depth.
class LeastTranslation {
 public:
  /// Keeps `hits`, which are all that there are; both must outlive it.
  LeastTranslation(const MeshReferee& referee, const std::vector<TrianglePair>& hits);

  /// Returns the length of the shortest translation found, metres, if it is no longer than `limit`.
  std::optional<double> find_within(double limit);

  /// Returns the shortest one found with bounded effort, at most what lets the boxes of both part.
  double find();

 private:
  /// During the move t * d the triangles share a point only while t * (normal . d) lies between
  /// these.
  struct Slab {
    RationalPoint normal;
    mpq_class low;
    mpq_class high;
  };
  struct Interval {
    mpq_class first;
    mpq_class last;
    bool is_empty = false;
    bool is_bounded = false;
  };

  static std::vector<Slab> slabs_of(const RationalTriangle& a, const RationalTriangle& b);
  static Interval interval_of(const std::vector<Slab>& slabs, const RationalPoint& direction);
  Interval interval_of(std::size_t hit, const RationalPoint& direction);
  Interval interval_of(const TrianglePair& pair, const RationalPoint& direction) const;
  void add_direction(const Eigen::Vector3d& direction);
  void add_directions(std::size_t hit);
  double length_along(const Eigen::Vector3d& direction) const;
  bool may_look();
  /// Returns the square of the least length along the direction, if it is no more than `limit`.
  std::optional<mpq_class> march(const Eigen::Vector3d& direction, const mpq_class& limit);

  const MeshReferee& referee_;
  const std::vector<TrianglePair>& hits_;
  std::vector<std::vector<Slab>> known_slabs_;  ///< the slabs of the first hits
  std::vector<Eigen::Vector3d> directions_;
  std::size_t effort_ = 0;  ///< the number of pairs that may yet be looked at
};

}  // namespace graze::compare
