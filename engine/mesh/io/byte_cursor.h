#pragma once

#include <graze/engine/files/source.h>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

namespace graze::mesh_io {

/// Reads binary values of either byte order in one pass. It throws each failure as a MeshError that
/// names the byte.
class ByteCursor {
 public:
  /// Begins at byte `offset`. The source must outlive the cursor.
  ByteCursor(const Source& source, std::size_t offset, std::endian order)
      : source_(source), offset_(offset), is_swapped_(order != std::endian::native) {}

  /// Reads the next value of type T. `what` names it if the file ends before.
  template <typename T>
  T read(std::string_view what) {
    require(sizeof(T), what);
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), source_.bytes.data() + offset_, sizeof(T));
    offset_ += sizeof(T);
    return from_bytes<T>(bytes);
  }

  /// Goes over `count` bytes.
  void skip(std::uint64_t count, std::string_view what) {
    require(count, what);
    offset_ += static_cast<std::size_t>(count);
  }

  /// Fails if the file has fewer than `count` bytes left.
  void require(std::uint64_t count, std::string_view what) const {
    if (remaining() < count) fail_short(what);
  }

  std::size_t remaining() const { return source_.bytes.size() - offset_; }
  Place place() const { return {Place::Unit::Byte, offset_}; }

  /// Fails at the current byte.
  [[noreturn]] void fail(std::string_view why) const { mesh_io::fail(source_, place(), why); }

  /// Fails at an earlier byte.
  [[noreturn]] void fail_at(Place at, std::string_view why) const {
    mesh_io::fail(source_, at, why);
  }

 private:
  template <typename T>
  T from_bytes(std::array<std::byte, sizeof(T)> bytes) const {
    if (is_swapped_) {
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
        std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
    }
    return std::bit_cast<T>(bytes);
  }

  [[noreturn]] void fail_short(std::string_view what) const;

  Source source_;
  std::size_t offset_;
  bool is_swapped_;
};

}  // namespace graze::mesh_io
