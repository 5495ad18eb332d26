#include <graze/bvh/wide/tree/range_moments.h>

#include <cmath>

namespace graze::bvh {
namespace {

void add_corner(RangeMoments& moments, const double* p) {
  for (int k = 0; k < 3; ++k) {
    moments.sum[k] += p[k];
    moments.products[k] += p[k] * p[k];
    moments.products[3 + k] += p[k] * p[(k + 1) % 3];
  }
}

void add_primitive(RangeMoments& moments, const CornerRows& rows, std::size_t primitive) {
  double corner[3][3];
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 0; k < 3; ++k)
      corner[c][k] = rows.row(c, k)[primitive];
  }
  double e[3], f[3];
  for (int k = 0; k < 3; ++k) {
    e[k] = corner[1][k] - corner[0][k];
    f[k] = corner[2][k] - corner[0][k];
  }
  double square = 0;
  for (int k = 0; k < 3; ++k) {
    const double n = e[(k + 1) % 3] * f[(k + 2) % 3] - e[(k + 2) % 3] * f[(k + 1) % 3];
    moments.normal[k] += n;
    square += n * n;
  }
  moments.area += std::sqrt(square);
  for (const auto& p : corner)
    add_corner(moments, p);
}

}  // namespace

MomentSums::MomentSums(const CornerRows& rows) : rows_(rows) {
  sums_.reserve(rows.size() / kStep + 1);
  RangeMoments running;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % kStep == 0) sums_.push_back(running);
    add_primitive(running, rows, i);
  }
  if (rows.size() % kStep == 0) sums_.push_back(running);
}

RangeMoments MomentSums::of_first(std::size_t count) const {
  RangeMoments moments = sums_[count / kStep];
  for (std::size_t i = count / kStep * kStep; i < count; ++i)
    add_primitive(moments, rows_, i);
  return moments;
}

RangeMoments MomentSums::of(std::size_t begin, std::size_t end) const {
  const RangeMoments low = of_first(begin);
  const RangeMoments high = of_first(end);
  RangeMoments moments;
  for (int k = 0; k < 3; ++k) {
    moments.normal[k] = high.normal[k] - low.normal[k];
    moments.sum[k] = high.sum[k] - low.sum[k];
  }
  moments.area = high.area - low.area;
  for (int k = 0; k < 6; ++k)
    moments.products[k] = high.products[k] - low.products[k];
  return moments;
}

}  // namespace graze::bvh
