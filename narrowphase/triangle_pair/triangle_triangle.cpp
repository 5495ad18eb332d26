#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/fixed_point.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_pair/intersection_signs.h>
#include <graze/narrowphase/triangle_triangle.h>

namespace graze {

bool intersects(const Triangle& triangle_a, const Triangle& triangle_b) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return narrowphase::decide(triangle_a, triangle_b).is_hit; });
}

namespace narrowphase {

Decision decide(const Triangle& triangle_a, const Triangle& triangle_b) {
  const Verdict verdict = triage(triangle_a, triangle_b);
  if (verdict != Verdict::Unsure) return {verdict == Verdict::Touching, Stage::Triage};
  return {intersects_exactly(triangle_a, triangle_b), Stage::Exact};
}

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

}  // namespace narrowphase
}  // namespace graze
