#include <graze/bvh/aabb.h>
#include <graze/bvh/error.h>
#include <graze/bvh/obb.h>
#include <graze/bvh/value/float_box.h>
#include <gtest/gtest.h>

#include <cmath>

namespace graze {
namespace {

TEST(Law10Boxes, AlignedBoxesMustBeFiniteAndOrdered) {
  Aabb box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_NO_THROW(check_box(box, "box"));
  box.max.y() = 0;
  EXPECT_NO_THROW(check_box(box, "box")) << "flat boxes are boxes";
  box.max.y() = -1;
  EXPECT_THROW(check_box(box, "box"), InputError);
  box.max.y() = HUGE_VAL;
  EXPECT_THROW(check_box(box, "box"), InputError);
  box.max.y() = std::nan("");
  EXPECT_THROW(check_box(box, "box"), InputError);
}

TEST(Law10Boxes, OrientedBoxesMustBeRigidAndNotNegative) {
  Obb box{Pose::Identity(), {1, 0, 1}};
  EXPECT_NO_THROW(check_box(box, "box"));
  box.half_extents.z() = -1e-300;
  EXPECT_THROW(check_box(box, "box"), InputError);
  box.half_extents.z() = std::nan("");
  EXPECT_THROW(check_box(box, "box"), InputError);
  box.half_extents.z() = 1;
  box.pose.linear() *= 1.001;
  EXPECT_THROW(check_box(box, "box"), PoseError);
}

TEST(FloatBox, EmptyIsNeutral) {
  const bvh::FloatBox box{{-1, 2, 3}, {4, 5, 6}};
  const bvh::FloatBox same = bvh::merged(bvh::empty_box(), box);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(same.min[k], box.min[k]);
    EXPECT_EQ(same.max[k], box.max[k]);
  }
  EXPECT_EQ(bvh::half_surface(box), 5 * 3 + 3 * 3 + 3 * 5);
}

TEST(FloatBox, OverlapIsClosed) {
  const bvh::FloatBox box{{0, 0, 0}, {1, 1, 1}};
  const bvh::FloatBox at_its_corner{{1, 1, 1}, {2, 2, 2}};
  EXPECT_TRUE(bvh::overlap(box, at_its_corner));
  EXPECT_TRUE(bvh::overlap(at_its_corner, box));
  for (int k = 0; k < 3; ++k) {
    bvh::FloatBox beyond{{0, 0, 0}, {2, 2, 2}};
    beyond.min[k] = std::nextafter(1.0f, 2.0f);
    EXPECT_FALSE(bvh::overlap(box, beyond));
    EXPECT_FALSE(bvh::overlap(beyond, box));
  }
}

}  // namespace
}  // namespace graze
