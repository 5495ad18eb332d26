#include <graze/bvh/fit/methods/moments.h>
#include <graze/bvh/value/dot.h>
#include <graze/bvh/wide/tree/node_axes.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

// The sum of normals of half a ball is half as long as the normals in all, that of a flat patch as
// long: in between a patch is taken for flat.
constexpr double kFlatness = 0.5;

// Squares of shorter vectors could underflow: what is divided by their root would not be of length
// 1. Sums of normals need no such limit, for products of floats are at least 2^-298.
constexpr double kShortest = 0x1p-500;

struct Covariance {
  double value[3][3];

  /// Computes C v.
  void times(const double* v, double* product) const {
    for (int i = 0; i < 3; ++i)
      product[i] = value[i][0] * v[0] + value[i][1] * v[1] + value[i][2] * v[2];
  }
};

void cross(const double* a, const double* b, double* product) {
  for (int k = 0; k < 3; ++k)
    product[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

Covariance covariance_of(const RangeMoments& moments, std::size_t corners) {
  const double share = 1 / static_cast<double>(corners);
  double mean[3];
  for (int k = 0; k < 3; ++k)
    mean[k] = moments.sum[k] * share;
  Covariance c;
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    c.value[k][k] = moments.products[k] * share - mean[k] * mean[k];
    c.value[k][l] = c.value[l][k] = moments.products[3 + k] * share - mean[k] * mean[l];
  }
  return c;
}

/// Finds any two unit vectors that stand on `w` and on each other.
void span_plane(const double* w, double* u, double* v) {
  const int smallest = std::abs(w[0]) <= std::abs(w[1]) && std::abs(w[0]) <= std::abs(w[2]) ? 0
                       : std::abs(w[1]) <= std::abs(w[2])                                   ? 1
                                                                                            : 2;
  double e[3] = {0, 0, 0};
  e[smallest] = 1;
  cross(w, e, u);
  const double norm = std::sqrt(dot(u, u));
  for (int k = 0; k < 3; ++k)
    u[k] /= norm;
  cross(w, u, v);
}

/// Turns u and v in their plane to the principal directions of the covariance there.
void turn_to_principal(const Covariance& c, double* u, double* v) {
  double cu[3], cv[3];
  c.times(u, cu);
  c.times(v, cv);
  const double half = 0.5 * (dot(u, cu) - dot(v, cv));
  const double mixed = dot(u, cv);
  const double root = std::sqrt(half * half + mixed * mixed);
  double cosine = half >= 0 ? root + half : mixed;
  double sine = half >= 0 ? mixed : root - half;
  const double norm = std::sqrt(cosine * cosine + sine * sine);
  if (!(norm > kShortest)) return;
  cosine /= norm;
  sine /= norm;
  for (int k = 0; k < 3; ++k) {
    const double along = cosine * u[k] + sine * v[k];
    v[k] = cosine * v[k] - sine * u[k];
    u[k] = along;
  }
}

}  // namespace

NodeAxes axes_of(const RangeMoments& moments, std::size_t corners) {
  const Covariance c = covariance_of(moments, corners);
  double axes[3][3];
  const double length = std::sqrt(dot(moments.normal, moments.normal));
  if (length > kFlatness * moments.area && std::isfinite(1 / length)) {
    for (int k = 0; k < 3; ++k)
      axes[2][k] = moments.normal[k] / length;
    span_plane(axes[2], axes[0], axes[1]);
    turn_to_principal(c, axes[0], axes[1]);
  } else {
    const Axes principal = principal_axes(Eigen::Map<const Eigen::Matrix3d>(&c.value[0][0]));
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k)
        axes[i][k] = principal(k, i);
    }
  }
  NodeAxes rounded;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      rounded.rows[i][k] = static_cast<float>(axes[i][k]);
  }
  return rounded;
}

}  // namespace graze::bvh
