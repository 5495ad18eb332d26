#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace graze::view {

/// Where an array of 32-bit words lies among the bytes of all.
struct WordArray {
  std::size_t offset;    ///< bytes
  std::size_t words;     ///< how many
  std::uint32_t stride;  ///< words back to the one that a word is written as the difference from
};

/// Arrays of words, written so that they pack well: each word as its difference from the one
/// `stride` before it, with the sign in the lowest bit, and of all words first their lowest bytes,
/// then the next. Indices and coordinates of neighbours then have high bytes of mostly 0.
class WordArrays {
 public:
  /// The number of the array.
  std::size_t add(std::span<const std::uint32_t> words, std::uint32_t stride);
  /// The bits of floats as words.
  std::size_t add(std::span<const float> floats, std::uint32_t stride);

  const std::vector<WordArray>& places() const { return places_; }
  const std::string& bytes() const { return bytes_; }

 private:
  std::vector<WordArray> places_;
  std::string bytes_;
};

}  // namespace graze::view
