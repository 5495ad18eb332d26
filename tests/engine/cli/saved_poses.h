#pragma once

#include <graze/bvh/pose.h>

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace graze::tests {

/// Writes a .npy file of float64 of the shape (count, 3, 4), and holds no more than one of them.
inline void save_poses(const std::filesystem::path& path, std::size_t count,
                       const std::function<Pose(std::size_t)>& pose_of) {
  std::string head =
      "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(count) + ", 3, 4), }";
  head.resize(117, ' ');
  head += '\n';
  std::ofstream file(path, std::ios::binary);
  file << std::string("\x93NUMPY\x01\x00", 8) << static_cast<char>(head.size()) << '\0' << head;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose pose = pose_of(i);
    for (int k = 0; k < 12; ++k) {
      const double number = pose(k / 4, k % 4);
      char bytes[sizeof(number)];
      std::memcpy(bytes, &number, sizeof(number));
      file.write(bytes, sizeof(bytes));
    }
  }
}

}  // namespace graze::tests
