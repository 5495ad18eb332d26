#pragma once

#include <cstdint>

namespace graze {

/// Two times of a grid, the ends of a stretch.
struct TimeSpan {
  std::uint64_t first;
  std::uint64_t last;
};

/// A stretch of time from `first` to `first + 2^level` of a grid.
struct TimeCell {
  std::uint64_t first;
  std::uint32_t level;

  std::uint64_t length() const { return std::uint64_t{1} << level; }
  std::uint64_t last() const { return first + length(); }
  bool is_finest() const { return level == 0; }
  std::uint64_t middle() const { return first + length() / 2; }
  TimeCell earlier() const { return {first, level - 1}; }
  TimeCell later() const { return {middle(), level - 1}; }
};

/// The times k / 2^depth, which doubles have exactly.
class TimeGrid {
 public:
  explicit TimeGrid(std::uint32_t depth)
      : depth_(depth), step_(1 / static_cast<double>(std::uint64_t{1} << depth)) {}

  /// Returns the coarsest grid in whose steps nothing moves further than `most`, if it goes as far
  /// as `displacement` in all.
  static TimeGrid for_steps(double displacement, double most) {
    std::uint32_t depth = 0;
    for (double step = displacement; step > most; step /= 2)
      ++depth;
    return TimeGrid(depth);
  }

  std::uint64_t end() const { return std::uint64_t{1} << depth_; }
  TimeCell whole() const { return {0, depth_}; }
  double step() const { return step_; }
  double time(std::uint64_t k) const { return static_cast<double>(k) * step_; }
  double length(const TimeSpan& span) const { return time(span.last - span.first); }

 private:
  std::uint32_t depth_;
  double step_;
};

}  // namespace graze
