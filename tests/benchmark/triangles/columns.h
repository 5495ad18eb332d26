#pragma once

#include <cstddef>
#include <vector>

namespace graze::benchmark {

/// Rows of numbers, each one number for each element. One behind the other and each from a cache
/// line on: rows in allocations of their own would all begin at one place of a page, and compete
/// for the same few lines of the cache.
class Columns {
 public:
  /// numbers_of(element, numbers) writes the `rows` numbers of an element.
  template <typename Elements, typename NumbersOf>
  void assign(const Elements& elements, std::size_t rows, NumbersOf numbers_of) {
    lines_per_row_ = elements.size() / kLine + 1;
    lines_.assign(rows * lines_per_row_, Line{});
    std::vector<double> numbers(rows);
    for (std::size_t n = 0; n < elements.size(); ++n) {
      numbers_of(elements[n], numbers.data());
      for (std::size_t r = 0; r < rows; ++r)
        lines_[r * lines_per_row_ + n / kLine].numbers[n % kLine] = numbers[r];
    }
  }

  const double* row(std::size_t r) const { return lines_[r * lines_per_row_].numbers; }

 private:
  static constexpr std::size_t kLine = 8;
  struct alignas(64) Line {
    double numbers[kLine];
  };

  std::size_t lines_per_row_ = 0;
  std::vector<Line> lines_;
};

}  // namespace graze::benchmark
