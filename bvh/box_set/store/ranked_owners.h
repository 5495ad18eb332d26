#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze::bvh {

/// Which owners an ascending list names, and where in it: a bit and a half an owner, where a table
/// would take 32.
class RankedOwners {
 public:
  /// `owner_of(i)`, for i below `count`, ascends and stays below `owners`.
  template <typename OwnerOf>
  void assign(std::size_t owners, std::size_t count, const OwnerOf& owner_of) {
    words_.assign((owners + kBits - 1) / kBits, {});
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t owner = owner_of(i);
      words_[owner / kBits].named |= std::uint64_t{1} << owner % kBits;
    }
    std::uint32_t before = 0;
    for (Word& word : words_) {
      word.before = before;
      before += static_cast<std::uint32_t>(std::popcount(word.named));
    }
  }

  /// Where the list names an owner; beyond its end if it does not.
  std::size_t rank(std::uint32_t owner) const {
    constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
    if (owner / kBits >= words_.size()) return kNowhere;
    const Word& word = words_[owner / kBits];
    const std::uint64_t bit = std::uint64_t{1} << owner % kBits;
    if ((word.named & bit) == 0) return kNowhere;
    return word.before + static_cast<std::size_t>(std::popcount(word.named & (bit - 1)));
  }

  std::size_t bytes() const { return words_.capacity() * sizeof(Word); }

 private:
  static constexpr std::uint32_t kBits = 64;

  struct Word {
    std::uint64_t named = 0;
    std::uint32_t before = 0;  // named by the words before
  };

  std::vector<Word> words_;
};

}  // namespace graze::bvh
