#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>

#include <algorithm>

namespace graze::narrowphase {
namespace {

using Rows = double[9][TrianglePairBatch::kCapacity];

void scatter(const Triangle& triangle, Rows& rows, std::size_t index) {
  const double* corners[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  for (int row = 0; row < 9; ++row)
    rows[row][index] = corners[row / 3][row % 3];
}

Triangle gather(const Rows& rows, std::size_t index) {
  Triangle triangle;
  double* corners[3] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  for (int row = 0; row < 9; ++row)
    corners[row / 3][row % 3] = rows[row][index];
  return triangle;
}

}  // namespace

void TrianglePairBatch::add(const Triangle& triangle_a, const Triangle& triangle_b) {
  if (!is_cleared_) {
    std::fill_n(&a_[0][0], 9 * kCapacity, 0.0);
    std::fill_n(&b_[0][0], 9 * kCapacity, 0.0);
    is_cleared_ = true;
  }
  scatter(triangle_a, a_, size_);
  scatter(triangle_b, b_, size_);
  ++size_;
}

Triangle TrianglePairBatch::triangle_a(std::size_t index) const {
  return gather(a_, index);
}

Triangle TrianglePairBatch::triangle_b(std::size_t index) const {
  return gather(b_, index);
}

}  // namespace graze::narrowphase
