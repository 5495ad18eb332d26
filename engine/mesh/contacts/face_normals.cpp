#include <graze/engine/mesh/contacts/face_normals.h>
#include <graze/engine/mesh/sweep/last_contact.h>

#include <algorithm>
#include <cmath>

namespace graze::contacts {
namespace {

/// Returns q - p times a power of two that brings its largest component to about 1. Halves are
/// subtracted, for a difference of two doubles can overflow.
Eigen::Vector3d scaled_step(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  double step[3];
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    step[k] = 0.5 * q.data()[k] - 0.5 * p.data()[k];
    largest = std::max(largest, std::abs(step[k]));
  }
  if (largest == 0) return {0, 0, 0};
  const int exponent = -std::ilogb(largest);
  return {std::scalbn(step[0], exponent), std::scalbn(step[1], exponent),
          std::scalbn(step[2], exponent)};
}

std::vector<std::uint32_t> triangles_of(const CellComplex& complex, const Cell& cell,
                                        std::uint32_t TrianglePair::*side) {
  std::vector<std::uint32_t> triangles;
  for (const TrianglePair& pair : complex.pairs_of(cell))
    triangles.push_back(pair.*side);
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

void add_normals(const PlacedCorners& corners, const std::vector<std::uint32_t>& triangles,
                 Eigen::Vector3d& sum, int& count) {
  for (std::uint32_t triangle : triangles) {
    const Eigen::Vector3d normal = face_normal(corners, triangle);
    for (int k = 0; k < 3; ++k)
      sum.data()[k] += normal.data()[k];
    ++count;
  }
}

}  // namespace

Eigen::Vector3d face_normal(const PlacedCorners& corners, std::uint32_t triangle) {
  if (!corners.elements(triangle).has_area()) return {0, 0, 0};
  const std::array<std::uint32_t, 3>& corner = corners.corners(triangle);
  const Eigen::Vector3d u = scaled_step(corners.position(corner[0]), corners.position(corner[1]));
  const Eigen::Vector3d v = scaled_step(corners.position(corner[0]), corners.position(corner[2]));
  const double* p = u.data();
  const double* q = v.data();
  const Eigen::Vector3d n(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                          p[0] * q[1] - p[1] * q[0]);
  const bool is_zero = n.data()[0] == 0 && n.data()[1] == 0 && n.data()[2] == 0;
  return is_zero ? n : unit_direction(n);
}

CellNormals normals_of(const CellComplex& complex, const Cell& cell) {
  CellNormals normals;
  add_normals(complex.a, triangles_of(complex, cell, &TrianglePair::a), normals.sum_a,
              normals.count_a);
  add_normals(complex.b, triangles_of(complex, cell, &TrianglePair::b), normals.sum_b,
              normals.count_b);
  return normals;
}

}  // namespace graze::contacts
