#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <graze/bvh/pose.h>
#include <Eigen/Core>

namespace graze::cases {

/// Returns the text as a JSON string, quotes included. Bytes that are not ASCII are handed on as
/// they are, except that those that are not UTF-8 become U+FFFD: file names may hold anything.
std::string json_string(std::string_view text);

/// Returns a double as a hex float in quotes.
std::string json_number(double value);

/// Returns 64 bits as a string, `"0x1f"`: a JSON number holds 53.
std::string json_bits(std::uint64_t bits);

/// Returns a double as a JSON number, of the fewest digits that read back as the same double; null
/// for what is not finite. It is for people and their tools: numbers that are read again are
/// written as hex floats.
std::string json_plain_number(double value);

/// This word stands in place of a number beyond the largest double.
inline constexpr const char* kInfinite = "infinite";

/// Returns the same, and that word for what is not finite: JsonCursor::number_or_infinite() reads
/// it back.
std::string json_plain_or_infinite(double value);

/// Returns `["0x1p+0","0x0p+0",...]`.
std::string json_point(const Eigen::Vector3d& point);

/// Returns the rows of [R | t], 12 numbers.
std::string json_pose(const Pose& pose);

/// Returns `[item,item,...]`, each written by `write(item)`.
template <typename List, typename Write>
std::string json_list(const List& list, std::string_view separator, Write&& write) {
  std::string out = "[";
  bool is_first = true;
  for (const auto& item : list) {
    if (!is_first) out += separator;
    is_first = false;
    out += write(item);
  }
  return out + "]";
}

}  // namespace graze::cases
