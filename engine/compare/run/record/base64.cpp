#include <graze/engine/compare/run/record/base64.h>

#include <cstddef>
#include <cstdint>

namespace graze::compare {
namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kBits = 6;

std::uint32_t byte_at(std::string_view bytes, std::size_t at) {
  return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
}

}  // namespace

std::string to_base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::uint32_t group =
        byte_at(bytes, at) << 16 | byte_at(bytes, at + 1) << 8 | byte_at(bytes, at + 2);
    for (std::size_t digit = 0; digit < 4; ++digit) {
      const bool is_there = digit < 2 || at + digit - 1 < bytes.size();
      text += is_there ? kDigits[group >> (kBits * (3 - digit)) & 63] : '=';
    }
  }
  return text;
}

std::optional<std::string> from_base64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t at = 0; at < text.size(); at += 4) {
    std::string_view four = text.substr(at, 4);
    while (at + 4 == text.size() && four.size() > 2 && four.ends_with('='))
      four.remove_suffix(1);
    std::uint32_t group = 0;
    for (const char digit : four) {
      const std::size_t value = kDigits.find(digit);
      if (value == kDigits.npos) return std::nullopt;
      group = group << kBits | static_cast<std::uint32_t>(value);
    }
    group <<= kBits * (4 - four.size());
    for (std::size_t byte = 0; byte + 1 < four.size(); ++byte)
      bytes += static_cast<char>(group >> (16 - 8 * byte) & 255);
  }
  return bytes;
}

}  // namespace graze::compare
