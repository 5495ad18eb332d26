#include <graze/bvh/floating_point/standard_arithmetic.h>
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

}  // namespace narrowphase
}  // namespace graze
