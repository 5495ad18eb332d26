#include <graze/engine/cases/text/hex_float.h>
#include <graze/engine/cases/text/json_text.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace graze::cases {
namespace {

/// Returns how many bytes the UTF-8 sequence at the front has; 0 if there is none (RFC 3629,
/// section 4).
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto is_tail = [&](std::size_t i) { return (byte(i) & 0xc0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first <= 0xdf) return is_tail(1) ? 2 : 0;
  if (first >= 0xe0 && first <= 0xef) {
    const bool is_shortest = first != 0xe0 || byte(1) >= 0xa0;
    const bool is_surrogate = first == 0xed && byte(1) >= 0xa0;
    return is_tail(1) && is_tail(2) && is_shortest && !is_surrogate ? 3 : 0;
  }
  if (first >= 0xf0 && first <= 0xf4) {
    const bool is_in_range =
        (first != 0xf0 || byte(1) >= 0x90) && (first != 0xf4 || byte(1) < 0x90);
    return is_tail(1) && is_tail(2) && is_tail(3) && is_in_range ? 4 : 0;
  }
  return 0;
}

void append_ascii(std::string& out, char c) {
  if (c == '"' || c == '\\') {
    out += '\\';
    out += c;
  } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
    constexpr const char* kDigits = "0123456789abcdef";
    out += "\\u00";
    out += kDigits[static_cast<unsigned char>(c) >> 4];
    out += kDigits[static_cast<unsigned char>(c) & 0xf];
  } else {
    out += c;
  }
}

}  // namespace

std::string json_string(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length == 0) {
      out += "\\ufffd";
    } else if (length == 1) {
      append_ascii(out, text.front());
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out + '"';
}

std::string json_number(double value) {
  std::string out = "\"";
  out += to_hex_float(value);
  return out + '"';
}

std::string json_bits(std::uint64_t bits) {
  std::array<char, 16> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), bits, 16).ptr;
  return std::string("\"0x") + std::string(digits.data(), end) + "\"";
}

std::string json_plain_number(double value) {
  if (!std::isfinite(value)) return "null";
  if (value == 0 && std::signbit(value)) return "-0.0";  // "-0" would be read as a whole number
  std::array<char, 32> text;
  const std::to_chars_result end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

std::string json_plain_or_infinite(double value) {
  return std::isfinite(value) ? json_plain_number(value) : json_string(kInfinite);
}

std::string json_point(const Eigen::Vector3d& point) {
  std::string out = "[";
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) out += ',';
    out += json_number(point[axis]);
  }
  return out + "]";
}

std::string json_pose(const Pose& pose) {
  std::string out = "[";
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      if (row + column > 0) out += ',';
      out += json_number(pose(row, column));
    }
  }
  return out + "]";
}

}  // namespace graze::cases
