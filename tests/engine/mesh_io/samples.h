#pragma once

#include <array>
#include <bit>

#include <cstddef>

#include <string>
#include <utility>
#include <vector>

namespace graze::mesh_io {

/// A file of a test: its name decides how it is read.
struct Sample {
  std::string name;
  std::string bytes;
};

/// Appends the bytes of the values in the given order.
template <typename... T>
void append(std::string& bytes, std::endian order, T... values) {
  const auto append_one = [&](auto value) {
    auto raw = std::bit_cast<std::array<char, sizeof(value)>>(value);
    if (order != std::endian::native) {
      for (std::size_t i = 0; i < raw.size() / 2; ++i)
        std::swap(raw[i], raw[raw.size() - 1 - i]);
    }
    bytes.append(raw.data(), raw.size());
  };
  (append_one(values), ...);
}

/// The same cube in every format that there is: 12 triangles, 8 corners at -0.25 and 0.5, in the
/// same order, outwards.
std::vector<Sample> cubes();

std::string cube_obj();
std::string cube_off();
std::string cube_stl_ascii();
std::string cube_stl_binary();
std::string cube_ply_ascii();
std::string cube_ply_binary(std::endian order);

}  // namespace graze::mesh_io
