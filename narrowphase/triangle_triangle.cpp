#include <graze/narrowphase/triangle_triangle.h>

namespace graze {

bool intersects(const Triangle& triangle_a, const Triangle& triangle_b) {
  using narrowphase::Verdict;
  const Verdict verdict = narrowphase::triage(triangle_a, triangle_b);
  if (verdict != Verdict::Unsure) return verdict == Verdict::Touching;
  return narrowphase::intersects_exactly(triangle_a, triangle_b);
}

}  // namespace graze
