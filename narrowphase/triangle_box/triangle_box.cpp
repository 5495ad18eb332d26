#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>

namespace graze {
namespace narrowphase {

Eigen::Vector3d point_into_frame(const Eigen::Vector3d& point, const Pose& frame) {
  const double* m = frame.data();  // column-major 4x4: column i is the frame's axis i
  const double x = point.data()[0] - m[12];
  const double y = point.data()[1] - m[13];
  const double z = point.data()[2] - m[14];
  Eigen::Vector3d local;
  for (int i = 0; i < 3; ++i)
    local.data()[i] = (m[4 * i] * x + m[4 * i + 1] * y) + m[4 * i + 2] * z;
  return local;
}

Triangle into_frame(const Triangle& triangle, const Pose& frame) {
  return {point_into_frame(triangle.a, frame), point_into_frame(triangle.b, frame),
          point_into_frame(triangle.c, frame)};
}

Decision decide(const Triangle& triangle, const Aabb& box) {
  const Verdict verdict = triage(triangle, box);
  if (verdict != Verdict::Unsure) return {verdict == Verdict::Yes, Stage::Triage};
  return {intersects_exactly(triangle, box), Stage::Exact};
}

}  // namespace narrowphase

bool intersects(const Triangle& triangle, const Aabb& box) {
  return bvh::in_standard_arithmetic(
      [&]() -> bool { return narrowphase::decide(triangle, box).is_hit; });
}

bool intersects(const Triangle& triangle, const Obb& box) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_box(box, "box");
    narrowphase::check_finite(triangle, "triangle");
    Aabb local;
    for (int i = 0; i < 3; ++i) {
      local.min.data()[i] = -box.half_extents.data()[i];
      local.max.data()[i] = box.half_extents.data()[i];
    }
    const Triangle framed = narrowphase::into_frame(triangle, box.pose);
    narrowphase::check_finite(framed, "triangle in the frame of the box");
    return narrowphase::decide(framed, local).is_hit;
  });
}

}  // namespace graze
