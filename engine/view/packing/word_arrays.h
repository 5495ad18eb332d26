#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace graze::view {

/// Says where an array of 32-bit words lies among the bytes of all.
struct WordArray {
  std::size_t offset;    ///< bytes
  std::size_t words;     ///< the number of words
  std::uint32_t stride;  ///< words back to the one from which a word's difference is written
};

/// Writes arrays of words so that they pack well: each word as its difference from the one `stride`
/// before it, with the sign in the lowest bit, and of all words first their lowest bytes, then the
/// next. Indices and coordinates of neighbours then have high bytes of mostly 0.
class WordArrays {
 public:
  /// Adds an array of words and returns its number.
  std::size_t add(std::span<const std::uint32_t> words, std::uint32_t stride);
  /// Adds the bits of floats as words.
  std::size_t add(std::span<const float> floats, std::uint32_t stride);

  const std::vector<WordArray>& places() const { return places_; }
  const std::string& bytes() const { return bytes_; }

 private:
  std::vector<WordArray> places_;
  std::string bytes_;
};

}  // namespace graze::view
