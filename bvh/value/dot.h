#pragma once

namespace graze::bvh {

/// Returns the dot product of two rows of three numbers, rounded term by term from the first to the
/// last.
inline double dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace graze::bvh
