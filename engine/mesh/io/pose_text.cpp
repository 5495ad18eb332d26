#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/files/number_list.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/pose_array.h>
#include <graze/engine/mesh/io/pose_lines.h>
#include <graze/engine/pose_text.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace graze {
namespace {

constexpr std::string_view kBlanks = " \t\n\r\v\f";

/// The longest line that is read: it has room for 12 numbers with every digit that a double can
/// have. A longer line is no pose, and is not worth the memory.
constexpr std::size_t kMaxLineLength = 1 << 16;

[[noreturn]] void fail(const std::string& place, const std::string& why) {
  throw PoseError(place + ": " + why);
}

[[noreturn]] void fail_in_file(const std::string& name, const std::string& why) {
  throw PoseError(name + ": " + why, {.file = name});
}

/// The first byte of numpy's arrays. No line of text begins with it.
constexpr int kFirstOfArray = 0x93;

std::vector<PoseLine> poses_of_array(std::ifstream& file, const std::string& name) {
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) fail_in_file(name, "cannot be read to its end");
  if (!mesh_io::is_array(bytes)) fail_in_file(name, "is no text, and no array of numpy's");
  return mesh_io::poses_of_array(bytes, name);
}

}  // namespace

Pose parse_pose(std::string_view text, const std::string& place) {
  return bvh::in_standard_arithmetic([&]() -> Pose {
    const std::vector<double> numbers = files::parse_numbers(text, place);
    if (numbers.size() != kPoseNumbers) {
      fail(place, std::to_string(numbers.size()) + (numbers.size() == 1 ? " number" : " numbers") +
                      ", a pose has " + std::to_string(kPoseNumbers));
    }
    Pose pose = Pose::Identity();
    for (std::size_t i = 0; i < kPoseNumbers; ++i)
      pose.matrix()(static_cast<int>(i / 4), static_cast<int>(i % 4)) = numbers[i];
    check_rigid(pose, place.c_str());
    return pose;
  });
}

namespace mesh_io {

PoseLines::PoseLines(std::istream& file, std::string name, std::size_t next_line)
    : file_(file), name_(std::move(name)), next_line_(next_line), buffer_(kMaxLineLength) {}

bool PoseLines::next(PoseLine& pose) {
  while (file_.peek() != std::istream::traits_type::eof()) {
    const std::size_t line = next_line_++;
    const std::string place = name_ + ":" + std::to_string(line);
    file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    if (file_.bad()) break;
    if (file_.fail()) {
      throw PoseError(place + ": longer than " + std::to_string(kMaxLineLength - 1) + " bytes",
                      {.file = name_, .line = line});
    }
    // gcount() includes the end of the line, unless the file ends first.
    const auto length = static_cast<std::size_t>(file_.gcount()) - (file_.eof() ? 0 : 1);
    const std::string_view text(buffer_.data(), length);
    if (text.find_first_not_of(kBlanks) == text.npos) continue;
    try {
      pose = {parse_pose(text, place), line};
      return true;
    } catch (const PoseError& error) {
      throw PoseError(error.what(), {.file = name_, .line = line});
    }
  }
  if (file_.bad()) fail_in_file(name_, "cannot be read to its end");
  return false;
}

}  // namespace mesh_io

std::vector<PoseLine> load_pose_lines(const std::filesystem::path& path) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<PoseLine> {
    const std::string name = mesh_io::printable(path.string());
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) fail_in_file(name, "is a directory");
    std::ifstream file(path, std::ios::binary);
    if (!file) fail_in_file(name, std::strerror(errno));
    if (file.peek() == kFirstOfArray) return poses_of_array(file, name);

    std::vector<PoseLine> poses;
    mesh_io::PoseLines lines(file, name);
    for (PoseLine line; lines.next(line);)
      poses.push_back(line);
    if (poses.empty()) fail_in_file(name, "no poses");
    return poses;
  });
}

std::vector<Pose> load_poses(const std::filesystem::path& path) {
  return bvh::in_standard_arithmetic([&]() -> std::vector<Pose> {
    std::vector<Pose> poses;
    for (const PoseLine& line : load_pose_lines(path))
      poses.push_back(line.pose);
    return poses;
  });
}

}  // namespace graze
