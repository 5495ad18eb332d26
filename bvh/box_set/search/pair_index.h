#pragma once

#include <graze/bvh/box_set/search/pair_lists.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Says where in a list each pair is: a hash table with linear probing, 4 bytes an entry, at most
/// half full. It lets a list of millions of pairs lose and gain single ones, and stays one flat
/// list.
class PairIndex {
 public:
  /// Forgets what it knew.
  void reset() { entries_.clear(); }
  bool is_built() const { return !entries_.empty(); }

  /// Learns the whole list, in linear time.
  void build(const PairBuffer& list) { build(list, list.size()); }

  /// Makes room for a list that grows by so many: then neither add() nor remove() will throw.
  void reserve(PairBuffer& list, std::size_t more);

  /// Appends the pair to the list. It must not be in it.
  void add(PairBuffer& list, BoxPair pair);

  /// Removes the pair, which must be in the list: the last of the list takes its place.
  void remove(PairBuffer& list, BoxPair pair);

  /// Fetches what the next call that names the pair will look at first.
  void prefetch(BoxPair pair) const { __builtin_prefetch(entries_.data() + home(pair)); }

  /// Fetches what the removals of ended[i + 1] and those after it will look at: the entry first,
  /// what it names a little later, and the entry of the last of the list, which will take that
  /// place.
  void prefetch_removal(const PairBuffer& list, std::span<const BoxPair> ended,
                        std::size_t i) const;

  /// Returns where in the list the pair is, kNowhere if it is not.
  std::uint32_t position(const PairBuffer& list, BoxPair pair) const {
    return entries_[find(list, pair)];
  }
  static constexpr std::uint32_t kNowhere = 0xffffffffu;

  std::size_t bytes() const { return entries_.capacity() * sizeof(std::uint32_t); }

 private:
  static constexpr std::uint32_t kFree = kNowhere;

  void build(const PairBuffer& list, std::size_t longest);
  std::size_t home(BoxPair pair) const;
  std::size_t find(const PairBuffer& list, BoxPair pair) const;

  std::vector<std::uint32_t> entries_;  ///< positions in the list
  int shift_ = 0;
};

}  // namespace graze::bvh
