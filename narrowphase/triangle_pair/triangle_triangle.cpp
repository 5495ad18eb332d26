#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/predicates/fixed_point.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_pair/intersection_signs.h>
#include <graze/narrowphase/triangle_pair/pair_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <algorithm>

namespace graze {

bool intersects(const Triangle& triangle_a, const Triangle& triangle_b) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return narrowphase::decide(triangle_a, triangle_b).is_hit; });
}

namespace narrowphase {
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

Decision decide(const Triangle& triangle_a, const Triangle& triangle_b) {
  const Verdict verdict = triage(triangle_a, triangle_b);
  if (verdict != Verdict::Unsure) return {verdict == Verdict::Touching, Stage::Triage};
  return {intersects_exactly(triangle_a, triangle_b), Stage::Exact};
}

Verdict compare_coordinates(const Triangle& triangle_a, const Triangle& triangle_b) {
  const double* a = coordinates(triangle_a);
  const double* b = coordinates(triangle_b);
  if (!is_finite(a) || !is_finite(b)) return Verdict::Unsure;
  if (shares_vertex(a, b)) return Verdict::Touching;
  return are_boxes_apart(a, b) ? Verdict::Apart : Verdict::Unsure;
}

Decision decide_unsure(const Triangle& triangle_a, const Triangle& triangle_b, Touch touch) {
  check_touch(touch);
  const Verdict verdict = compare_coordinates(triangle_a, triangle_b);
  if (verdict == Verdict::Apart) return {false, Stage::Triage};
  if (touch == Touch::Exclude) return {crosses_exactly(triangle_a, triangle_b), Stage::Exact};
  if (verdict == Verdict::Touching) return {true, Stage::Triage};
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
