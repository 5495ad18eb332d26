#include <graze/engine/files/sha256.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace graze::files {
namespace {

using Word = std::uint32_t;
constexpr std::size_t kBlockBytes = 64;
constexpr std::size_t kRounds = 64;

/// The standard's constants are the first 32 bits of the fractions of roots of the first primes:
/// they are found here in whole numbers, as the largest r with r^n <= p * 2^(32 n).
Word fraction_of_root(unsigned prime, int degree) {
  __extension__ using Wide = unsigned __int128;
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 35; bit != 0; bit >>= 1) {
    const Wide candidate = root | bit;
    // candidate < 2^36, so that a cube needs 108 bits and p * 2^96 at most 105.
    Wide power = candidate * candidate;
    if (degree == 3) power *= candidate;
    if (power <= Wide{prime} << (32 * degree)) root |= bit;
  }
  return static_cast<Word>(root);
}

struct Constants {
  std::array<Word, kRounds> of_round;
  std::array<Word, 8> start;

  Constants() {
    std::size_t found = 0;
    for (unsigned number = 2; found < kRounds; ++number) {
      bool is_prime = true;
      for (unsigned divisor = 2; divisor * divisor <= number; ++divisor)
        is_prime = is_prime && number % divisor != 0;
      if (!is_prime) continue;
      of_round[found] = fraction_of_root(number, 3);
      if (found < start.size()) start[found] = fraction_of_root(number, 2);
      ++found;
    }
  }
};

const Constants& constants() {
  static const Constants kConstants;
  return kConstants;
}

Word big_endian(const unsigned char* bytes) {
  return Word{bytes[0]} << 24 | Word{bytes[1]} << 16 | Word{bytes[2]} << 8 | Word{bytes[3]};
}

// This is FIPS 180-4, section 6.2.2, with its names.
void absorb(std::array<Word, 8>& hash, const unsigned char* block) {
  std::array<Word, kRounds> w;
  for (std::size_t t = 0; t < 16; ++t)
    w[t] = big_endian(block + 4 * t);
  for (std::size_t t = 16; t < kRounds; ++t) {
    const Word s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ w[t - 15] >> 3;
    const Word s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ w[t - 2] >> 10;
    w[t] = s1 + w[t - 7] + s0 + w[t - 16];
  }
  auto [a, b, c, d, e, f, g, h] = hash;
  for (std::size_t t = 0; t < kRounds; ++t) {
    const Word sum1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
    const Word t1 = h + sum1 + ((e & f) ^ (~e & g)) + constants().of_round[t] + w[t];
    const Word sum0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
    const Word t2 = sum0 + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + t1;
    d = c, c = b, b = a, a = t1 + t2;
  }
  const std::array<Word, 8> last = {a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < hash.size(); ++i)
    hash[i] += last[i];
}

}  // namespace

std::string sha256_of(std::string_view bytes) {
  std::array<Word, 8> hash = constants().start;
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const std::size_t whole = bytes.size() / kBlockBytes * kBlockBytes;
  for (std::size_t at = 0; at < whole; at += kBlockBytes)
    absorb(hash, data + at);

  // The tail holds what is left, a one bit, zeros, and the length in bits as 64 bits, in one block
  // or two.
  std::array<unsigned char, 2 * kBlockBytes> tail{};
  const std::size_t left = bytes.size() - whole;
  for (std::size_t i = 0; i < left; ++i)
    tail[i] = data[whole + i];
  tail[left] = 0x80;
  const std::size_t end = left + 9 <= kBlockBytes ? kBlockBytes : 2 * kBlockBytes;
  const std::uint64_t bits = std::uint64_t{bytes.size()} * 8;
  for (std::size_t i = 0; i < 8; ++i)
    tail[end - 1 - i] = static_cast<unsigned char>(bits >> (8 * i));
  for (std::size_t at = 0; at < end; at += kBlockBytes)
    absorb(hash, tail.data() + at);

  std::string text;
  for (const Word word : hash) {
    for (int shift = 28; shift >= 0; shift -= 4)
      text += "0123456789abcdef"[(word >> shift) & 0xf];
  }
  return text;
}

}  // namespace graze::files
