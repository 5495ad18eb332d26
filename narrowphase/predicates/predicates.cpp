#include <graze/bvh/error.h>
#include <graze/narrowphase/predicates/orientation_stages.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle.h>
#include <cmath>
#include <string>

namespace graze::narrowphase {

void check_finite(const Triangle& triangle, const char* what) {
  const double* corners[] = {triangle.a.data(), triangle.b.data(), triangle.c.data()};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(corners[i][k])) {
        throw InputError(std::string(what) + ": coordinate " + "xyz"[k] + " of vertex " + "abc"[i] +
                         " is not finite");
      }
    }
  }
}

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
