#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>

namespace graze {
namespace narrowphase {

// This method is the fastest of the three, by the measurement in README.md.
Decision decide(const Sphere& sphere, const Aabb& box) {
  return decide_branch_free(sphere, box);
}

}  // namespace narrowphase

bool intersects(const Sphere& sphere, const Aabb& box) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_sphere(sphere, "sphere");
    bvh::check_box(box, "box");
    return narrowphase::decide(sphere, box).is_hit;
  });
}

bool intersects(const Aabb& box, const Sphere& sphere) {
  return intersects(sphere, box);
}

bool intersects(const Sphere& sphere, const Obb& box) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    bvh::check_sphere(sphere, "sphere");
    bvh::check_box(box, "box");
    Aabb local;
    for (int i = 0; i < 3; ++i) {
      local.min.data()[i] = -box.half_extents.data()[i];
      local.max.data()[i] = box.half_extents.data()[i];
    }
    const Sphere framed{narrowphase::point_into_frame(sphere.centre, box.pose), sphere.radius};
    bvh::check_sphere(framed, "sphere in the frame of the box");
    return narrowphase::decide(framed, local).is_hit;
  });
}

bool intersects(const Obb& box, const Sphere& sphere) {
  return intersects(sphere, box);
}

}  // namespace graze
