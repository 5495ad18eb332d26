#include "data/pose_file.h"

#include <gtest/gtest.h>

#include <graze/bvh/error.h>
#include <fstream>

namespace graze::data {
namespace {

// Each test has a file of its own: tests may run at the same time.
std::filesystem::path test_file() {
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  return std::filesystem::path(testing::TempDir()) / ("graze_pose_file_" + test + ".txt");
}

std::vector<Pose> read(const std::string& text) {
  std::ofstream(test_file()) << text;
  return read_poses(test_file());
}

std::string message_of(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    return std::string(error.what()).substr(test_file().string().size());
  }
  return "no error";
}

const std::string kShift = "1 0 0 0.5 0 1 0 -2 0 0 1 1e-3\n";

TEST(PoseFile, EachLineIsAPose) {
  const std::vector<Pose> poses = read("1 0 0 0 0 1 0 0 0 0 1 0\n" + kShift);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[1].translation(), Eigen::Vector3d(0.5, -2, 1e-3));
}

TEST(PoseFile, ErrorsNameTheLine) {
  EXPECT_EQ(message_of(kShift + "1 0 0\n"), ":2: number 4 of 12 is missing or no number");
  EXPECT_EQ(message_of("1 0 0 0 x\n"), ":1: number 5 of 12 is missing or no number");
  EXPECT_EQ(message_of("1 0 0 0 0 1 0 0 0 0 1 0 7\n"), ":1: more than 12 numbers");
  EXPECT_EQ(message_of(""), ": no poses");
  EXPECT_EQ(message_of("2 0 0 0 0 1 0 0 0 0 1 0\n").substr(0, 8), ":1: pose");
  EXPECT_THROW(read_poses("no/such/file.txt"), Error);
}

}  // namespace
}  // namespace graze::data
