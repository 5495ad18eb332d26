#include <graze/bvh/wide/range_moments.h>

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

void add_primitive(RangeMoments& moments, const double (&corner)[3][3]) {
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

MomentSums::MomentSums(const CornerRows& rows) : sums_(rows.size() + 1) {
  RangeMoments running;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double corner[3][3];
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k)
        corner[c][k] = rows.row(c, k)[i];
    }
    add_primitive(running, corner);
    sums_[i + 1] = running;
  }
}

RangeMoments MomentSums::of(std::size_t begin, std::size_t end) const {
  const RangeMoments& low = sums_[begin];
  const RangeMoments& high = sums_[end];
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
