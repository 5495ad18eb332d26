#include <graze/bvh/error.h>
#include <graze/narrowphase/predicates/finite.h>
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

}  // namespace graze::narrowphase
