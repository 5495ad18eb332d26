#pragma once

// Finds the least translation that satisfies several ways out at once. Private to engine/world.

#include <graze/narrowphase/convex/depth/facing_depth.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace graze {

/// Several ways out that a body takes together.
class Clearance {
 public:
  /// Begins without exits. Lengths below `tolerance`, metres, do not matter; every exit is exceeded
  /// by as much.
  void start(double tolerance);

  /// Takes another exit. The translation stays as it is if no translation satisfies this exit with
  /// those before, as between two walls that are too near to each other, or only one longer than
  /// kMostTimes the depth. It costs O(n) for exits in random order, and O(n^3) at worst.
  void add(const narrowphase::Exit& exit);

  /// Returns the shortest translation that goes along each exit by its depth.
  const narrowphase::Vec3& translation() const { return translation_; }

  /// True if the translation goes along that exit by more than its depth. So a translation across
  /// does not leave what only touches.
  bool satisfies(const narrowphase::Exit& exit) const {
    return dot(translation_, exit.direction) >= exit.depth + 0.5 * tolerance_;
  }

  static constexpr double kMostTimes = 16;

 private:
  bool goes_along(const narrowphase::Vec3& x, const narrowphase::Exit& exit) const;
  std::optional<narrowphase::Vec3> on_plane(std::size_t c) const;
  std::optional<narrowphase::Vec3> on_line(std::size_t c, std::size_t i) const;

  std::vector<narrowphase::Exit> exits_;
  narrowphase::Vec3 translation_;
  double tolerance_ = 0;
};

}  // namespace graze
