#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace graze::compare {

/// Code a time, or a ratio of two, in 16 bits: ten bits behind the leading one, so that it is off
/// by no more than 2^-11 of itself, from 2^-20 to 2^43; 0 stands for 0, and a time beyond these
/// bounds becomes the nearest of them.
std::uint16_t time_code(double value);
double time_of_code(std::uint16_t code);

/// Returns the time as a record has it: two records of one run tell the same.
inline double recorded_time(double value) {
  return time_of_code(time_code(value));
}

/// Keeps the median of as many times as there are, in the memory of a counter for each code.
class TimeMedian {
 public:
  void add(double value);

  /// Returns the middle one, the upper of two; 0 if there is none.
  double median() const;

 private:
  static constexpr std::size_t kCodes = std::size_t{1} << 16;
  std::unique_ptr<std::array<std::uint64_t, kCodes>> counts_;  ///< null while there is none
  std::uint64_t count_ = 0;
};

}  // namespace graze::compare
