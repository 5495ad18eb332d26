#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace graze::record {

/// Returns the bytes of a number, lowest first, as a word of this machine.
constexpr std::uint64_t lowest_first(std::uint64_t word) {
  return std::endian::native == std::endian::little ? word : __builtin_bswap64(word);
}

/// Holds bytes that grow at their end, in memory that is kept when they are cleared.
class ByteWriter {
 public:
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  std::string_view view() const { return {reinterpret_cast<const char*>(bytes_.data()), size_}; }

  /// Returns where up to `count` bytes may be written, which end_at() then counts.
  unsigned char* room(std::size_t count) {
    if (bytes_.size() - size_ < count) bytes_.resize(2 * bytes_.size() + count + kLeast);
    return bytes_.data() + size_;
  }
  void end_at(const unsigned char* end) { size_ = static_cast<std::size_t>(end - bytes_.data()); }

  void byte(std::uint8_t value) {
    *room(1) = value;
    ++size_;
  }
  void text(std::string_view bytes) {
    number(bytes.size());
    raw(bytes);
  }
  void raw(std::string_view bytes) {
    if (bytes.empty()) return;
    std::memcpy(room(bytes.size()), bytes.data(), bytes.size());
    size_ += bytes.size();
  }
  void word(std::uint64_t value) {
    const std::uint64_t bytes = lowest_first(value);
    std::memcpy(room(sizeof bytes), &bytes, sizeof bytes);
    size_ += sizeof bytes;
  }
  void real(double value) { word(std::bit_cast<std::uint64_t>(value)); }
  /// Writes seven bits in each byte, the lowest first; all but the last byte have the eighth bit
  /// set (LEB128).
  void number(std::uint64_t value) {
    unsigned char* at = room(kLongestNumber);
    for (; value >= 0x80; value >>= 7)
      *at++ = static_cast<unsigned char>(value | 0x80);
    *at++ = static_cast<unsigned char>(value);
    end_at(at);
  }
  /// Writes a number that may be negative in the same way: its sign is the lowest bit.
  void difference(std::int64_t value) {
    number(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
  }

 private:
  static constexpr std::size_t kLeast = 256;
  static constexpr std::size_t kLongestNumber = 10;

  std::vector<unsigned char> bytes_;  ///< the memory; its first size_ bytes are written
  std::size_t size_ = 0;
};

}  // namespace graze::record
