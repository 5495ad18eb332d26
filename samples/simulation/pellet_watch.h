#pragma once

#include <Eigen/Core>
#include <cmath>

#include "samples/simulation/bin.h"

namespace graze::samples {

/// True if a point is within the walls of a bin, and between its floor and its mouth or above that.
inline bool is_in_bin(const BinSize& size, const Eigen::Vector3d& point) {
  return point.z() > 0 && std::hypot(point.x(), point.y()) < inner_radius(size, point.z());
}

/// Watches a pellet that is shot into a bin. It may jump out over the rim, but must not go through
/// the walls or the floor.
class PelletWatch {
 public:
  /// Takes note of where the pellet is, once a step.
  void see(const BinSize& size, const Eigen::Vector3d& centre) {
    if (centre.z() > size.height) {
      place_ = Place::Above;
    } else if (is_in_bin(size, centre)) {
      place_ = Place::Inside;
    } else if (place_ == Place::Above) {
      place_ = Place::Beside;
    } else if (place_ == Place::Inside) {
      place_ = Place::Through;
    }
  }
  bool has_jumped_out() const { return place_ == Place::Beside; }
  bool has_gone_through() const { return place_ == Place::Through; }

 private:
  enum class Place { Above, Inside, Beside, Through };

  Place place_ = Place::Above;
};

}  // namespace graze::samples
