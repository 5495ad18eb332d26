#include <graze/bvh/error.h>
#include <graze/engine/pose_text.h>
#include <gtest/gtest.h>

#include "tests/files/temporary_directory.h"

namespace graze {
namespace {

/// What load_poses() says of a file, without its folder.
std::string message_of(const std::string& text) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.write("poses.txt", text);
  try {
    load_poses(path);
  } catch (const PoseError& error) {
    const std::string what = error.what();
    EXPECT_TRUE(what.starts_with(path)) << what;
    return what.substr(path.size());
  }
  return "no error";
}

const std::string kShift = "1 0 0 0.5, 0 1 0 -2, 0 0 1 1e-3\n";

TEST(PoseText, EachLineThatIsNotBlankIsAPose) {
  const tests::TemporaryDirectory directory;
  const std::string path = directory.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n\n" + kShift);
  const std::vector<PoseLine> lines = load_pose_lines(path);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].line, 1u);
  EXPECT_EQ(lines[1].line, 3u);
  EXPECT_EQ(lines[1].pose.translation(), Eigen::Vector3d(0.5, -2, 1e-3));
  EXPECT_EQ(load_poses(path).at(1).matrix(), lines[1].pose.matrix());
}

TEST(PoseText, ErrorsNameTheLine) {
  EXPECT_EQ(message_of(kShift + "1 0 0\n"), ":2: 3 numbers, a pose has 12");
  EXPECT_EQ(message_of("1 0 0 0 x\n"), ":1: number 5: \"x\" is not a number");
  EXPECT_EQ(message_of("1 0 0 0 0 1 0 0 0 0 1 0 7\n"), ":1: 13 numbers, a pose has 12");
  EXPECT_EQ(message_of(""), ": no poses");
  EXPECT_TRUE(message_of(kShift + "2 0 0 0 0 1 0 0 0 0 1 0").starts_with(":2: not a rotation"));
  EXPECT_THROW(load_poses("no/such/file.txt"), PoseError);
}

TEST(PoseText, OnePoseIsNamedByItsPlace) {
  EXPECT_EQ(parse_pose(kShift, "argument").translation(), Eigen::Vector3d(0.5, -2, 1e-3));
  try {
    parse_pose("1,,0", "argument");
    FAIL();
  } catch (const PoseError& error) {
    EXPECT_STREQ(error.what(), "argument: a comma without a number before it");
  }
}

}  // namespace
}  // namespace graze
