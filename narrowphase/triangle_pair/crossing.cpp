#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <string>

namespace graze {

bool crosses(const Triangle& triangle_a, const Triangle& triangle_b) {
  return intersects(triangle_a, triangle_b, Touch::Exclude);
}

bool intersects(const Triangle& triangle_a, const Triangle& triangle_b, Touch touch) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return narrowphase::decide(triangle_a, triangle_b, touch).is_hit; });
}

namespace narrowphase {

void check_touch(Touch touch) {
  if (touch == Touch::Include || touch == Touch::Exclude) return;
  throw InputError("touch: there is no policy " + std::to_string(static_cast<int>(touch)));
}

Decision decide(const Triangle& triangle_a, const Triangle& triangle_b, Touch touch) {
  check_touch(touch);
  if (touch == Touch::Include) return decide(triangle_a, triangle_b);
  const Verdict verdict = crossing_triage(triangle_a, triangle_b);
  if (verdict != Verdict::Unsure) return {verdict == Verdict::Yes, Stage::Triage};
  return {crosses_exactly(triangle_a, triangle_b), Stage::Exact};
}

}  // namespace narrowphase
}  // namespace graze
