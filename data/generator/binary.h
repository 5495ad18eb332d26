#pragma once

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <string>

namespace graze::generator {

/// A number's bytes, least significant first, whatever the machine.
template <std::unsigned_integral Number>
void append_little_endian(std::string& bytes, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i) {
    bytes.push_back(static_cast<char>(number >> (8 * i) & 0xff));
  }
}

inline void append_little_endian(std::string& bytes, float number) {
  append_little_endian(bytes, std::bit_cast<std::uint32_t>(number));
}
inline void append_little_endian(std::string& bytes, double number) {
  append_little_endian(bytes, std::bit_cast<std::uint64_t>(number));
}

/// A number's bytes, most significant first.
template <typename Number>
void append_big_endian(std::string& bytes, Number number) {
  append_little_endian(bytes, number);
  std::reverse(bytes.end() - sizeof number, bytes.end());
}

}  // namespace graze::generator
