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

/// What stands in the header behind a key, up to the end of all.
std::string_view behind(std::string_view header, std::string_view key, const std::string& name) {
  const std::size_t at = header.find(std::string("'").append(key).append("':"));
  if (at == header.npos) fail(name, std::string("its header has no ").append(key));
  header.remove_prefix(at + key.size() + 3);
  header.remove_prefix(std::min(header.find_first_not_of(' '), header.size()));
  return header;
}

/// "(2, 3, 4)" as 2, 3, 4; nothing if it is no list of whole numbers.
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
  std::size_t rows;  ///< 3 or 4
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

std::vector<PoseLine> poses_of_array(std::string_view bytes, const std::string& name) {
  // Behind the magic stand two bytes of a version and the length of the header.
  const std::size_t start = kMagic.size() + 2;
  const std::size_t width = bytes.size() > start && bytes[start - 2] == 1 ? 2 : 4;
  if (bytes.size() < start + width) fail(name, "ends within its header");
  const std::size_t length = little_endian(bytes.substr(start, width));
  if (bytes.size() - start - width < length) fail(name, "ends within its header");
  const Layout layout = layout_of(bytes.substr(start + width, length), name);
  bytes.remove_prefix(start + width + length);
  const std::size_t size = layout.rows * 4 * sizeof(double);
  if (layout.count != bytes.size() / size || bytes.size() % size != 0) {
    fail(name, "has " + std::to_string(bytes.size()) + " bytes of numbers, not " +
                   std::to_string(layout.count) + " times " + std::to_string(size));
  }
  if (layout.count == 0) fail(name, "no poses");
  std::vector<PoseLine> poses;
  poses.reserve(layout.count);
  for (std::size_t n = 0; n < layout.count; ++n) {
    Pose pose = Pose::Identity();
    for (std::size_t i = 0; i < layout.rows * 4; ++i) {
      const std::string_view number = bytes.substr(n * size + i * sizeof(double), sizeof(double));
      pose.matrix()(static_cast<int>(i / 4), static_cast<int>(i % 4)) =
          std::bit_cast<double>(static_cast<std::uint64_t>(little_endian(number)));
    }
    try {
      check_rigid(pose, (name + ":" + std::to_string(n + 1)).c_str());
    } catch (const PoseError& error) {
      throw PoseError(error.what(), {.file = name, .element = "pose", .index = n});
    }
    poses.push_back({pose, n + 1});
  }
  return poses;
}

}  // namespace graze::mesh_io
