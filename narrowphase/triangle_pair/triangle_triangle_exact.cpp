#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/finite.h>
#include <graze/narrowphase/predicates/fixed_point.h>
#include <graze/narrowphase/triangle_pair/signs_of_crossing.h>
#include <graze/narrowphase/triangle_triangle.h>

namespace graze::narrowphase {

bool intersects_exactly(const Triangle& triangle_a, const Triangle& triangle_b) {
  check_finite(triangle_a, "triangle A");
  check_finite(triangle_b, "triangle B");
  const double* a = coordinates(triangle_a);
  const double* b = coordinates(triangle_b);
  const double* const corners[6] = {a, a + 3, a + 6, b, b + 3, b + 6};
  FixedPoint fixed[6];
  if (to_fixed_point(corners, 6, fixed)) {
    return meet_exactly(Corners<std::int64_t>{{fixed[0], fixed[1], fixed[2]}},
                        Corners<std::int64_t>{{fixed[3], fixed[4], fixed[5]}});
  }
  return meet_exactly(Corners<double>{{a, a + 3, a + 6}}, Corners<double>{{b, b + 3, b + 6}});
}

}  // namespace graze::narrowphase
