#include <graze/narrowphase/predicates/orientation_stages.h>
#include <graze/narrowphase/predicates/predicates.h>

namespace graze::narrowphase {

Sign orientation_2d(Point2 a, Point2 b, Point2 c) {
  if (const auto sign = orientation_2d_filter(a, b, c)) return *sign;
  if (const auto sign = orientation_2d_expansion(a, b, c)) return *sign;
  return orientation_2d_big(a, b, c);
}

Sign orientation_3d(const double* a, const double* b, const double* c, const double* d) {
  if (const auto sign = orientation_3d_filter(a, b, c, d)) return *sign;
  if (const auto sign = orientation_3d_expansion(a, b, c, d)) return *sign;
  return orientation_3d_big(a, b, c, d);
}

}  // namespace graze::narrowphase
