#include <graze/bvh/error.h>
#include <graze/bvh/pose.h>
#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace graze {
namespace {

TEST(Law10Pose, RotationsPass) {
  Pose pose = Pose::Identity();
  EXPECT_EQ(check_rigid(pose, "pose"), 0);
  pose.linear() = Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() << 1e300, -1e-300, 0;
  EXPECT_LT(check_rigid(pose, "pose"), 1e-15);
}

TEST(Law10Pose, DeviationDecidesAtTheLimit) {
  Pose pose = Pose::Identity();
  pose.linear()(0, 0) = 1 + 0.49e-6;
  EXPECT_NO_THROW(check_rigid(pose, "pose"));
  pose.linear()(0, 0) = 1 + 0.51e-6;
  EXPECT_THROW(check_rigid(pose, "pose"), PoseError);
  pose.linear()(0, 0) = 1;
  pose.linear()(1, 2) = 1.1e-6;
  EXPECT_THROW(check_rigid(pose, "pose"), PoseError);
}

TEST(Law10Pose, ReflectionsScalingsAndProjectionsAreRefused) {
  Pose reflection = Pose::Identity();
  reflection.linear()(2, 2) = -1;
  EXPECT_THROW(check_rigid(reflection, "pose"), PoseError);
  Pose scaling = Pose::Identity();
  scaling.linear() *= 2;
  EXPECT_THROW(check_rigid(scaling, "pose"), PoseError);
  for (int column = 0; column < 4; ++column) {
    Pose projection = Pose::Identity();
    projection.matrix()(3, column) += 1e-9;
    EXPECT_THROW(check_rigid(projection, "pose"), PoseError) << column;
  }
}

TEST(Law10Pose, EveryEntryMustBeFinite) {
  for (int i = 0; i < 16; ++i) {
    for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
      Pose pose = Pose::Identity();
      pose.data()[i] = bad;
      EXPECT_THROW(check_rigid(pose, "pose"), PoseError) << i;
    }
  }
}

TEST(Law10Pose, NoTwoEntriesHideEachOther) {
  const double bad[] = {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e200, -1e200};
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < i; ++j) {
      if (i % 4 == 3 || j % 4 == 3) continue;
      for (const double one : bad) {
        for (const double other : bad) {
          Pose pose = Pose::Identity();
          pose.data()[i] = one;
          pose.data()[j] = other;
          EXPECT_THROW(check_rigid(pose, "pose"), PoseError) << i << " " << j;
        }
      }
    }
  }
}

TEST(Law10Pose, TheMessageNamesThePlace) {
  Pose pose = Pose::Identity();
  pose.matrix()(1, 3) = std::nan("");
  try {
    check_rigid(pose, "pose of B");
    FAIL();
  } catch (const PoseError& error) {
    EXPECT_STREQ(error.what(), "pose of B: entry (1, 3) is not finite");
  }
}

}  // namespace
}  // namespace graze
