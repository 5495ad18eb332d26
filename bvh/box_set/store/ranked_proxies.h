#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze::bvh {

/// Says which proxies an ascending list names, and where in the list: it takes two bits for each
/// proxy, where a table would take 32.
class RankedProxies {
 public:
  /// Takes a list: `proxy_of(i)`, for i below `count`, ascends and stays below `proxies`.
  template <typename ProxyOf>
  void assign(std::size_t proxies, std::size_t count, const ProxyOf& proxy_of) {
    words_.assign((proxies + kBits - 1) / kBits, {});
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t proxy = proxy_of(i);
      words_[proxy / kBits].named |= std::uint64_t{1} << proxy % kBits;
    }
    std::uint32_t before = 0;
    for (Word& word : words_) {
      word.before = before;
      before += static_cast<std::uint32_t>(std::popcount(word.named));
    }
  }

  /// Returns where in the list a proxy is; a place beyond its end if it is not there.
  std::size_t rank(std::uint32_t proxy) const {
    constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);
    if (proxy / kBits >= words_.size()) return kNowhere;
    const Word& word = words_[proxy / kBits];
    const std::uint64_t bit = std::uint64_t{1} << proxy % kBits;
    if ((word.named & bit) == 0) return kNowhere;
    return word.before + static_cast<std::size_t>(std::popcount(word.named & (bit - 1)));
  }

  std::size_t bytes() const { return words_.capacity() * sizeof(Word); }

 private:
  static constexpr std::uint32_t kBits = 64;

  struct Word {
    std::uint64_t named = 0;
    std::uint32_t before = 0;  ///< how many proxies the words before name
  };

  std::vector<Word> words_;
};

}  // namespace graze::bvh
