#pragma once

// The least translation that satisfies several ways out at once. Private to engine/world.

#include <graze/narrowphase/convex/depth/facing_depth.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace graze {

/// Ways out that a body takes together.
class Clearance {
 public:
  /// Lengths below `tolerance`, metres, do not matter; every exit is exceeded by as much.
  void start(double tolerance);

  /// Takes another exit. Where no translation satisfies it with those before, as between two walls
  /// that are too near to each other, or one of more than kMostTimes the depth, the translation
  /// stays. O(n) for exits that come in no particular order, O(n^3) at worst.
  void add(const narrowphase::Exit& exit);

  /// The translation of least length that goes along each exit by its depth.
  const narrowphase::Vec3& translation() const { return translation_; }

  /// Whether the translation goes along that exit by more than its depth. What only touches is not
  /// left by a translation across.
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
