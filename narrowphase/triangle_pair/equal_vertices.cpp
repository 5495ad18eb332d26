#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/triangle_pair/pair_stages.h>
#include <algorithm>

namespace graze::narrowphase {
namespace {

/// Zero times what is not finite is NaN, and so is a sum that holds one.
bool is_finite(const double* corners) {
  double sum = 0;
  for (int i = 0; i < 9; ++i)
    sum += 0 * corners[i];
  return sum == 0;
}

bool shares_vertex(const double* a, const double* b) {
  bool is_shared = false;
  for (int i = 0; i < 9; i += 3) {
    for (int j = 0; j < 9; j += 3) {
      is_shared |= (a[i] == b[j]) & (a[i + 1] == b[j + 1]) & (a[i + 2] == b[j + 2]);
    }
  }
  return is_shared;
}

bool are_boxes_apart(const double* a, const double* b) {
  bool is_apart = false;
  for (int k = 0; k < 3; ++k) {
    is_apart |=
        std::max(std::max(a[k], a[k + 3]), a[k + 6]) < std::min(std::min(b[k], b[k + 3]), b[k + 6]);
    is_apart |=
        std::max(std::max(b[k], b[k + 3]), b[k + 6]) < std::min(std::min(a[k], a[k + 3]), a[k + 6]);
  }
  return is_apart;
}

}  // namespace

Verdict compare_coordinates(const Triangle& triangle_a, const Triangle& triangle_b) {
  const double* a = coordinates(triangle_a);
  const double* b = coordinates(triangle_b);
  if (!is_finite(a) || !is_finite(b)) return Verdict::Unsure;
  if (shares_vertex(a, b)) return Verdict::Touching;
  return are_boxes_apart(a, b) ? Verdict::Apart : Verdict::Unsure;
}

}  // namespace graze::narrowphase
