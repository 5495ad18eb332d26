#pragma once

#include <charconv>
#include <string>
#include <system_error>

namespace graze::bvh {

/// Returns a number as a message tells it: the shortest text that is this double, in any locale.
inline std::string number_text(double number) {
  char text[32];
  const std::to_chars_result end = std::to_chars(text, text + sizeof(text), number);
  return std::string(text, end.ec == std::errc() ? end.ptr : text);
}

}  // namespace graze::bvh
