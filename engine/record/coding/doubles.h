#pragma once

// Doubles are written by how far they are from a guess, exactly.

#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/coding/byte_writer.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace graze::record {

/// Returns the difference of two patterns of bits, whose sign is the lowest bit. Bits of doubles of
/// one sign are ordered as the doubles are, so that a good guess leaves few.
inline std::uint64_t turned_difference(double actual, double guess) {
  const std::uint64_t step =
      std::bit_cast<std::uint64_t>(actual) - std::bit_cast<std::uint64_t>(guess);
  return step << 1 ^ (~(step >> 63) + 1);
}
inline double turned_back(std::uint64_t turned, double guess) {
  const std::uint64_t step = turned >> 1 ^ (~(turned & 1) + 1);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(guess) + step);
}

/// Writes half a byte for each double, which says how many bytes of its difference follow, 0 to 8;
/// then these bytes.
template <std::size_t kCount>
void write_doubles(ByteWriter& to, const std::array<double, kCount>& actual,
                   const std::array<double, kCount>& guess) {
  static_assert(kCount <= 16, "half a byte each in one word");
  constexpr std::size_t kLengths = (kCount + 1) / 2;
  unsigned char* const begin = to.room(kLengths + kCount * 8 + 8);
  unsigned char* at = begin + kLengths;
  std::uint64_t lengths = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    const std::uint64_t turned = turned_difference(actual[i], guess[i]);
    const auto length = static_cast<unsigned>((71 - std::countl_zero(turned)) / 8);
    const std::uint64_t bytes = lowest_first(turned);
    std::memcpy(at, &bytes, sizeof bytes);  // the next double writes over what is beyond its length
    at += length;
    lengths |= std::uint64_t{length} << 4 * i;
  }
  const std::uint64_t bytes = lowest_first(lengths);
  std::memcpy(begin, &bytes, kLengths);
  to.end_at(at);
}

/// Reads the doubles one after the other, so that a guess may depend on those before it.
template <std::size_t kCount>
class DoubleReader {
 public:
  explicit DoubleReader(ByteReader& from) : from_(from), lengths_(from.raw((kCount + 1) / 2)) {}

  double next(double guess) {
    const auto pair = static_cast<unsigned char>(lengths_[index_ / 2]);
    const unsigned length = pair >> 4 * (index_ % 2) & 15U;
    ++index_;
    if (length > 8) from_.fail("a number of more than eight bytes");
    const std::string_view bytes = from_.raw(length);
    std::uint64_t turned = 0;
    for (unsigned k = 0; k < length; ++k)
      turned |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << 8 * k;
    return turned_back(turned, guess);
  }

 private:
  ByteReader& from_;
  std::string_view lengths_;
  std::size_t index_ = 0;
};

}  // namespace graze::record
