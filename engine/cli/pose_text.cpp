#include <graze/engine/cli/pose_text.h>
#include <graze/engine/cli/quote.h>
#include <graze/engine/cli/usage_error.h>

#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace graze::cli {
namespace {

constexpr std::string_view kBlanks = " \t\n\r\v\f";

/// Room for 12 numbers with every digit that a double can have. A longer line is no pose, and is
/// not worth the memory.
constexpr std::size_t kMaxLineLength = 1 << 16;

bool is_blank(std::string_view text) {
  return text.find_first_not_of(kBlanks) == text.npos;
}

/// The fields of a line: runs of what is neither blank nor comma. A comma stands between two
/// fields.
std::vector<std::string_view> split(std::string_view text, const std::string& place) {
  std::vector<std::string_view> fields;
  bool is_comma_open = true;  // a comma here would have no field before it
  while (!(text = text.substr(std::min(text.find_first_not_of(kBlanks), text.size()))).empty()) {
    if (text.front() == ',') {
      if (is_comma_open) throw UsageError(place + ": a comma without a number before it");
      is_comma_open = true;
      text.remove_prefix(1);
      continue;
    }
    const std::size_t length = std::min(text.find_first_of(" \t\n\r\v\f,"), text.size());
    fields.push_back(text.substr(0, length));
    text.remove_prefix(length);
    is_comma_open = false;
  }
  if (is_comma_open && !fields.empty()) {
    throw UsageError(place + ": a comma without a number after it");
  }
  return fields;
}

double parse_number(std::string_view field, std::size_t number, const std::string& place) {
  // A plus sign is how some programs print numbers, though from_chars() refuses it.
  const bool has_plus = field.size() > 1 && field[0] == '+' && field[1] != '-';
  const char* const begin = field.data() + (has_plus ? 1 : 0);
  const char* const end = field.data() + field.size();
  double value = 0;
  const auto result = fast_float::from_chars(begin, end, value);
  if (result.ec == std::errc::invalid_argument || result.ptr != end) {
    throw UsageError(
        fmt::format("{}: number {}: {} is not a number", place, number, in_quotes(field)));
  }
  if (!std::isfinite(value)) {
    throw UsageError(
        fmt::format("{}: number {}: {} is not finite", place, number, in_quotes(field)));
  }
  return value;
}

}  // namespace

Pose parse_pose(std::string_view text, const std::string& place) {
  const std::vector<std::string_view> fields = split(text, place);
  std::array<double, kPoseNumbers> numbers{};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const double value = parse_number(fields[i], i + 1, place);
    if (i < kPoseNumbers) numbers[i] = value;
  }
  if (fields.size() != kPoseNumbers) {
    throw UsageError(fmt::format("{}: {} number{}, a pose has {}", place, fields.size(),
                                 fields.size() == 1 ? "" : "s", kPoseNumbers));
  }
  Pose pose = Pose::Identity();
  for (std::size_t i = 0; i < kPoseNumbers; ++i) {
    pose.matrix()(static_cast<int>(i / 4), static_cast<int>(i % 4)) = numbers[i];
  }
  check_rigid(pose, place.c_str());
  return pose;
}

std::vector<PoseLine> load_poses(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (std::filesystem::is_directory(path)) throw UsageError(name + ": is a directory");
  std::ifstream file(path);
  if (!file) throw UsageError(name + ": " + std::strerror(errno));

  std::vector<PoseLine> poses;
  std::vector<char> buffer(kMaxLineLength);
  for (std::size_t line = 1; file.peek() != std::ifstream::traits_type::eof(); ++line) {
    const std::string place = fmt::format("{}:{}", name, line);
    file.getline(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    if (file.bad()) break;
    if (file.fail()) {
      throw UsageError(fmt::format("{}: longer than {} bytes", place, kMaxLineLength - 1));
    }
    // gcount() includes the end of the line, unless the file ends first.
    const auto length = static_cast<std::size_t>(file.gcount()) - (file.eof() ? 0 : 1);
    const std::string_view text(buffer.data(), length);
    if (!is_blank(text)) poses.push_back({parse_pose(text, place), line});
  }
  if (file.bad()) throw UsageError(name + ": cannot be read to its end");
  if (poses.empty()) throw UsageError(name + ": no poses");
  return poses;
}

}  // namespace graze::cli
