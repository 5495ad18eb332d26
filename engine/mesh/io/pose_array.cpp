#include <graze/bvh/error.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/pose_array.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>

namespace graze::mesh_io {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

[[noreturn]] void fail(const std::string& name, const std::string& why) {
  throw PoseError(name + ": " + why, {.file = name});
}

std::size_t little_endian(std::string_view bytes) {
  std::size_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// Returns what stands in the header behind a key, up to the end of the header.
std::string_view behind(std::string_view header, std::string_view key, const std::string& name) {
  const std::size_t at = header.find(std::string("'").append(key).append("':"));
  if (at == header.npos) fail(name, std::string("its header has no ").append(key));
  header.remove_prefix(at + key.size() + 3);
  header.remove_prefix(std::min(header.find_first_not_of(' '), header.size()));
  return header;
}

/// Returns "(2, 3, 4)" as 2, 3, 4; nothing if the text is no list of whole numbers.
std::vector<std::size_t> numbers_of(std::string_view text) {
  std::vector<std::size_t> numbers;
  if (!text.starts_with('(')) return {};
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of("(, "), text.size()));
    if (text.starts_with(')')) return numbers;
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return {};
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

struct Layout {
  std::size_t count;
  std::size_t rows;  ///< how many rows a pose has, 3 or 4
};

Layout layout_of(std::string_view header, const std::string& name) {
  if (!behind(header, "descr", name).starts_with("'<f8'"))
    fail(name, "its numbers are no float64 ('<f8')");
  if (!behind(header, "fortran_order", name).starts_with("False"))
    fail(name, "is not in C order: see numpy.ascontiguousarray");
  const std::string_view text = behind(header, "shape", name);
  const std::vector<std::size_t> shape = numbers_of(text);
  const bool are_poses = shape.size() == 3 && (shape[1] == 3 || shape[1] == 4) && shape[2] == 4;
  if (!are_poses) {
    std::string why = "has the shape ";
    why.append(printable(text.substr(0, text.find(')') + 1)))
        .append(", poses have (n, 3, 4) or (n, 4, 4)");
    fail(name, why);
  }
  return {shape[0], shape[1]};
}

}  // namespace

bool is_array(std::string_view bytes) {
  return bytes.starts_with(kMagic);
}

PoseArrayLayout layout_of_array(std::string_view begin, std::size_t size, const std::string& name) {
  // Two bytes of a version and the length of the header stand behind the magic.
  const std::size_t start = kMagic.size() + 2;
  const std::size_t width = begin.size() > start && begin[start - 2] == 1 ? 2 : 4;
  if (begin.size() < start + width) fail(name, "ends within its header");
  const std::size_t length = little_endian(begin.substr(start, width));
  if (begin.size() - start - width < length) fail(name, "ends within its header");
  const Layout shape = layout_of(begin.substr(start + width, length), name);
  const PoseArrayLayout layout{shape.count, shape.rows, start + width + length};
  const std::size_t numbers = size - layout.start;
  if (layout.count != numbers / layout.bytes_of_pose() || numbers % layout.bytes_of_pose() != 0) {
    fail(name, "has " + std::to_string(numbers) + " bytes of numbers, not " +
                   std::to_string(layout.count) + " times " +
                   std::to_string(layout.bytes_of_pose()));
  }
  return layout;
}

Pose pose_of_array(std::string_view bytes, std::size_t index, const std::string& name) {
  Pose pose = Pose::Identity();
  for (std::size_t i = 0; i < bytes.size() / sizeof(double); ++i) {
    const std::string_view number = bytes.substr(i * sizeof(double), sizeof(double));
    pose.matrix()(static_cast<int>(i / 4), static_cast<int>(i % 4)) =
        std::bit_cast<double>(static_cast<std::uint64_t>(little_endian(number)));
  }
  try {
    check_rigid(pose, (name + ":" + std::to_string(index + 1)).c_str());
  } catch (const PoseError& error) {
    throw PoseError(error.what(), {.file = name, .element = "pose", .index = index});
  }
  return pose;
}

std::vector<PoseLine> poses_of_array(std::string_view bytes, const std::string& name) {
  const PoseArrayLayout layout = layout_of_array(bytes, bytes.size(), name);
  if (layout.count == 0) fail(name, "no poses");
  std::vector<PoseLine> poses;
  poses.reserve(layout.count);
  for (std::size_t n = 0; n < layout.count; ++n) {
    const std::size_t at = layout.start + n * layout.bytes_of_pose();
    poses.push_back({pose_of_array(bytes.substr(at, layout.bytes_of_pose()), n, name), n + 1});
  }
  return poses;
}

}  // namespace graze::mesh_io
