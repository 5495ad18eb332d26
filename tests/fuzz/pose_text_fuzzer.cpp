#include <graze/bvh/error.h>
#include <graze/engine/mesh/io/pose_array.h>
#include <graze/engine/pose_text.h>

#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

// Whatever a line holds, it is a pose or a PoseError. A pose that was read is rigid, and its
// numbers, written with all their digits, are read as the same pose, bit for bit.

using namespace graze;

namespace {

std::string written(const Pose& pose) {
  std::string text;
  for (int i = 0; i < static_cast<int>(kPoseNumbers); ++i) {
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, pose.matrix()(i / 4, i % 4)).ptr;
    text.append(digits, end);
    text += i % 2 == 0 ? ", " : " ";
  }
  return text;
}

bool have_equal_numbers(const Pose& p, const Pose& q) {
  for (int i = 0; i < 16; ++i) {
    if (std::bit_cast<std::uint64_t>(p.data()[i]) != std::bit_cast<std::uint64_t>(q.data()[i]))
      return false;
  }
  return true;
}

/// An array of poses is read, or refused, whatever it holds.
void read_array(std::string_view bytes) {
  try {
    for (const PoseLine& pose : mesh_io::poses_of_array(bytes, "array"))
      check_rigid(pose.pose, "a pose of an array");
  } catch (const PoseError&) {  // what is wrong with an input is no finding
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (mesh_io::is_array(bytes)) read_array(bytes);
  Pose pose;
  try {
    pose = parse_pose(bytes, "line");
  } catch (const PoseError&) {
    return 0;  // what is wrong with an input is no finding
  }
  check_rigid(pose, "a pose that was read");
  if (!have_equal_numbers(parse_pose(written(pose), "written"), pose)) std::abort();
  return 0;
}
