#include <graze/engine/world/id_table.h>

namespace graze {
namespace {

constexpr std::size_t kGrowthShare = 8, kFew = 64;

}  // namespace

template <typename Generation>
std::uint32_t IdTable<Generation>::take() {
  ++live_count_;
  if (free_.empty()) {
    // Not twice as much: a table of many would be mostly room.
    const std::size_t size = generation_.size();
    if (size == generation_.capacity()) generation_.reserve(size + size / kGrowthShare + kFew);
    generation_.push_back(1);
    return static_cast<std::uint32_t>(generation_.size() - 1);
  }
  const std::uint32_t index = free_.back();
  free_.pop_back();
  ++generation_[index];
  return index;
}

template <typename Generation>
void IdTable<Generation>::free(std::uint32_t index) {
  --live_count_;
  ++generation_[index];
  if (generation_[index] != 0) resting_[0].push_back(index);
}

template <typename Generation>
void IdTable<Generation>::next_round() {
  if (resting_[0].empty() && resting_[1].empty()) return;
  free_.insert(free_.end(), resting_[1].begin(), resting_[1].end());
  resting_[1].clear();
  resting_[0].swap(resting_[1]);
}

template <typename Generation>
std::size_t IdTable<Generation>::bytes() const {
  return generation_.capacity() * sizeof(Generation) +
         (free_.capacity() + resting_[0].capacity() + resting_[1].capacity()) * 4;
}

template class IdTable<std::uint16_t>;
template class IdTable<std::uint32_t>;

}  // namespace graze
