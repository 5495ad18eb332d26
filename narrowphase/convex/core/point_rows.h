#pragma once

// Stores points coordinate by coordinate, for sets of which many support points are asked. Private
// to graze.

#include <graze/narrowphase/convex/core/vector.h>

#include <cstddef>
#include <vector>

namespace graze::narrowphase {

struct PointPointers {
  const double* x;
  const double* y;
  const double* z;
};

/// Compares several points at once, with the same answers as one by one on any CPU.
class PointRows {
 public:
  void clear() { x_.clear(), y_.clear(), z_.clear(); }
  void add(const Vec3& point) {
    x_.push_back(point.x), y_.push_back(point.y), z_.push_back(point.z);
  }
  void resize(std::size_t count) { x_.resize(count), y_.resize(count), z_.resize(count); }

  /// Returns the number of the first of the points that are farthest in a direction, of the first
  /// `count`, one at least.
  std::size_t farthest(const Vec3& direction, std::size_t count) const;

  /// Returns the number of the first point from that one on that lies at least so far along a
  /// direction, or how many points there are if none does.
  std::size_t next_beyond(const Vec3& direction, double along, std::size_t from) const;

 private:
  std::vector<double> x_, y_, z_;
};

}  // namespace graze::narrowphase
