#pragma once

#include <array>
#include <charconv>
#include <string>

namespace graze::compare {

/// Returns "apart by 0.25 m", with all digits that tell a double from its neighbours.
inline std::string in_metres(const char* what, double length) {
  std::array<char, 32> text;
  const std::to_chars_result end = std::to_chars(text.data(), text.data() + text.size(), length);
  return std::string(what) + " " + std::string(text.data(), end.ptr) + " m";
}

}  // namespace graze::compare
