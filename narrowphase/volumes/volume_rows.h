#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace graze::narrowphase {

/// Stores volumes of N doubles each, row by row for kernels: row r holds number r of all volumes.
/// Rows are padded with zeros to whole blocks, so that kernels may compute with lanes that hold no
/// volume.
template <std::size_t N>
class VolumeRows {
 public:
  static constexpr std::size_t kAtOnce = 8;

  std::size_t size() const { return size_; }
  const double* row(std::size_t r) const { return rows_[r].data(); }

  /// The rows' first elements.
  std::array<const double*, N> rows() const {
    std::array<const double*, N> result;
    for (std::size_t r = 0; r < N; ++r)
      result[r] = row(r);
    return result;
  }

  std::array<double, N> operator[](std::size_t index) const {
    std::array<double, N> volume;
    for (std::size_t r = 0; r < N; ++r)
      volume[r] = rows_[r][index];
    return volume;
  }

  /// Adds a volume. If memory runs out the list stays as it was.
  void add(const std::array<double, N>& volume) {
    const std::size_t padded = (size_ / kAtOnce + 1) * kAtOnce;
    for (std::vector<double>& row : rows_)
      row.resize(padded);
    for (std::size_t r = 0; r < N; ++r)
      rows_[r][size_] = volume[r];
    ++size_;
  }

  void clear() {
    for (std::vector<double>& row : rows_)
      row.clear();
    size_ = 0;
  }

 private:
  std::array<std::vector<double>, N> rows_;
  std::size_t size_ = 0;
};

/// The form in which kernels get VolumeRows: the first element of each row.
template <std::size_t N>
using RowPointers = std::array<const double*, N>;

}  // namespace graze::narrowphase
