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

/// What numpy.save() writes: a header padded to 64 bytes, then the numbers.
std::string saved(const std::string& description, const std::vector<double>& numbers) {
  std::string header = description;
  header.resize((header.size() + 10) / 64 * 64 + 64 - 10 - 1, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += '\1';
  bytes += '\0';
  bytes += static_cast<char>(header.size() & 0xff);
  bytes += static_cast<char>(header.size() >> 8);
  bytes += header;
  for (const double number : numbers)
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  return bytes;
}

std::string shaped(const std::string& shape) {
  return "{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }";
}

const std::vector<double> kTwo = {1, 0, 0, 0.5, 0, 1, 0,  -2, 0,  0, 1, 1e-3,
                                  0, 1, 0, 7,   0, 0, -1, 8,  -1, 0, 0, 0x1p-1074};

TEST(PoseArray, IsReadBitForBit) {
  const tests::TemporaryDirectory directory;
  const std::vector<PoseLine> poses =
      load_pose_lines(directory.write("poses.npy", saved(shaped("(2, 3, 4)"), kTwo)));
  ASSERT_EQ(poses.size(), 2u);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_EQ(poses[n].line, n + 1);
    for (std::size_t i = 0; i < 12; ++i) {
      EXPECT_EQ(poses[n].pose.matrix()(static_cast<int>(i / 4), static_cast<int>(i % 4)),
                kTwo[12 * n + i]);
    }
  }
  std::vector<double> whole(kTwo.begin(), kTwo.begin() + 12);
  whole.insert(whole.end(), {0, 0, 0, 1});
  const std::string file = directory.write("whole.txt", saved(shaped("(1,4,4)"), whole));
  EXPECT_EQ(load_poses(file).at(0).matrix(), poses[0].pose.matrix()) << "whatever its name";
}

TEST(PoseArray, ErrorsSayWhatIsWrong) {
  EXPECT_EQ(message_of(saved(shaped("(2, 3, 4)"), {1, 2, 3})),
            ": has 24 bytes of numbers, not 2 times 96");
  EXPECT_EQ(message_of(saved(shaped("(1, 3, 4)"), kTwo)),
            ": has 192 bytes of numbers, not 1 times 96");
  EXPECT_EQ(message_of(saved(shaped("(0, 3, 4)"), {})), ": no poses");
  EXPECT_EQ(message_of(saved(shaped("(24,)"), kTwo)),
            ": has the shape (24,), poses have (n, 3, 4) or (n, 4, 4)");
  EXPECT_EQ(message_of(saved(shaped("(18446744073709551615, 3, 4)"), kTwo)),
            ": has 192 bytes of numbers, not 18446744073709551615 times 96");
  EXPECT_EQ(message_of(saved(shaped("(18446744073709551616, 3, 4)"), kTwo)).find(": has the shape"),
            0u);
  EXPECT_EQ(
      message_of(saved("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3, 4), }", kTwo)),
      ": its numbers are no float64 ('<f8')");
  EXPECT_EQ(
      message_of(saved("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 3, 4), }", kTwo)),
      ": is not in C order: see numpy.ascontiguousarray");
  EXPECT_EQ(message_of(saved("{'descr': '<f8', 'fortran_order': False, }", kTwo)),
            ": its header has no shape");
  EXPECT_EQ(message_of("\x93NUMPY"), ": ends within its header");
  EXPECT_EQ(message_of(saved(shaped("(2, 3, 4)"), kTwo).substr(0, 40)), ": ends within its header");
  EXPECT_EQ(message_of("\x93UMPY"), ": is no text, and no array of numpy's");
  std::vector<double> bent = kTwo;
  bent[12] = 2;
  EXPECT_TRUE(message_of(saved(shaped("(2, 3, 4)"), bent)).starts_with(":2: not a rotation"));
  std::vector<double> whole(kTwo.begin(), kTwo.begin() + 12);
  whole.insert(whole.end(), {0, 0, 0, 2});
  EXPECT_TRUE(message_of(saved(shaped("(1, 4, 4)"), whole)).starts_with(":1: "));
}

}  // namespace
}  // namespace graze
