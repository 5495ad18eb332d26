#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

namespace graze {
namespace narrowphase {

Decision decide(const Triangle& triangle, const Sphere& sphere) {
  const Verdict verdict = triage(triangle, sphere);
  if (verdict != Verdict::Unsure) return {verdict == Verdict::Touching, Stage::Triage};
  return {intersects_exactly(triangle, sphere), Stage::Exact};
}

}  // namespace narrowphase

bool intersects(const Triangle& triangle, const Sphere& sphere) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return narrowphase::decide(triangle, sphere).is_hit; });
}

}  // namespace graze
