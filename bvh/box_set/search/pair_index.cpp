#include <graze/bvh/box_set/search/pair_index.h>

#include <bit>

namespace graze::bvh {

/// Returns the entry where a pair is looked for first, by Fibonacci hashing: the top bits of a
/// product with the golden ratio (Knuth, TAOCP 3, 6.4).
std::size_t PairIndex::home(BoxPair pair) const {
  const std::uint64_t key = static_cast<std::uint64_t>(pair.a) << 32 | pair.b;
  const std::uint64_t mixed = (key ^ key >> 29) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>((mixed ^ mixed >> 31) * 0x9e3779b97f4a7c15u >> shift_);
}

std::size_t PairIndex::find(const PairBuffer& list, BoxPair pair) const {
  const std::size_t mask = entries_.size() - 1;
  std::size_t at = home(pair);
  while (entries_[at] != kFree && list.data()[entries_[at]] != pair)
    at = (at + 1) & mask;
  return at;
}

/// Builds the index with entries for a list of up to `longest` pairs.
void PairIndex::build(const PairBuffer& list, std::size_t longest) {
  const std::size_t size = std::bit_ceil(2 * longest + 1024);
  entries_.assign(size, kFree);
  shift_ = 64 - std::countr_zero(size);
  for (std::size_t i = 0; i < list.size(); ++i)
    entries_[find(list, list.data()[i])] = static_cast<std::uint32_t>(i);
}

void PairIndex::reserve(PairBuffer& list, std::size_t more) {
  list.room_for(more);
  if (2 * (list.size() + more) > entries_.size()) build(list, list.size() + more);
}

void PairIndex::add(PairBuffer& list, BoxPair pair) {
  reserve(list, 1);
  list.push_back(pair);
  entries_[find(list, pair)] = static_cast<std::uint32_t>(list.size() - 1);
}

void PairIndex::prefetch_removal(const PairBuffer& list, std::span<const BoxPair> ended,
                                 std::size_t i) const {
  constexpr std::size_t kSoon = 8, kNext = 4;
  if (i + kSoon < ended.size()) prefetch(ended[i + kSoon]);
  if (i + kNext < ended.size()) {
    const std::uint32_t entry = entries_[home(ended[i + kNext])];
    if (entry != kFree) __builtin_prefetch(list.data() + entry);
  }
  if (list.size() > kNext) prefetch(list.data()[list.size() - 1 - kNext]);
}

void PairIndex::remove(PairBuffer& list, BoxPair pair) {
  const std::size_t mask = entries_.size() - 1;
  std::size_t free = find(list, pair);
  const std::uint32_t at = entries_[free];
  const auto last = static_cast<std::uint32_t>(list.size() - 1);
  if (at != last) entries_[find(list, list.data()[last])] = at;
  const BoxPair moved = list.data()[last];
  // Entries behind the freed one move up, unless that is before their home.
  entries_[free] = kFree;
  for (std::size_t next = (free + 1) & mask; entries_[next] != kFree; next = (next + 1) & mask) {
    const std::uint32_t entry = entries_[next];
    const BoxPair of = entry == at && at != last ? moved : list.data()[entry];
    if (((next - home(of)) & mask) >= ((next - free) & mask)) {
      entries_[free] = entry;
      entries_[next] = kFree;
      free = next;
    }
  }
  list.data()[at] = moved;
  list.resize(last);
}

}  // namespace graze::bvh
