#pragma once

#include <graze/engine/record/coding/byte_writer.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace graze::record {

/// Reads what a ByteWriter wrote. Refusals are RecordingErrors that name the byte of the file.
class ByteReader {
 public:
  /// The bytes stand in the file `name` from `offset` on; `name` must outlive this. With
  /// `is_packed` they were unpacked, and errors name where the packed ones begin.
  ByteReader(std::string_view bytes, const std::string& name, std::uint64_t offset,
             bool is_packed = false)
      : bytes_(bytes), name_(name), offset_(offset), is_packed_(is_packed) {}

  std::uint8_t byte() {
    require(1);
    return static_cast<std::uint8_t>(bytes_[at_++]);
  }
  std::string_view raw(std::uint64_t count) {
    require(count);
    const std::string_view part = bytes_.substr(at_, static_cast<std::size_t>(count));
    at_ += part.size();
    return part;
  }
  std::string_view text() { return raw(number()); }
  std::uint64_t word();
  double real() { return std::bit_cast<double>(word()); }
  std::uint64_t number();
  std::int64_t difference() {
    const std::uint64_t turned = number();
    return static_cast<std::int64_t>(turned >> 1 ^ (~(turned & 1) + 1));
  }
  /// Reads a number that must be at most so much.
  std::uint32_t number_up_to(std::uint64_t most, const char* what);
  /// Reads how many elements follow, each of at least so many bytes; fails if fewer bytes are left
  /// than they need.
  std::size_t count(std::size_t least_bytes_each, const char* what);
  /// Reads bits of which only those of `known` may be set.
  std::uint8_t flags(std::uint8_t known, const char* what);

  std::size_t remaining() const { return bytes_.size() - at_; }
  void require(std::uint64_t count) const {
    if (count > remaining()) fail("ends too soon");
  }
  /// Fails unless all was read.
  void require_end() const {
    if (remaining() != 0) fail("more bytes than belong there");
  }
  [[noreturn]] void fail(const std::string& why) const;

 private:
  std::string_view bytes_;
  const std::string& name_;
  std::uint64_t offset_;
  bool is_packed_;
  std::size_t at_ = 0;
};

}  // namespace graze::record
