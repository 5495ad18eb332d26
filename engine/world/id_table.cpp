#include <graze/engine/world/id_table.h>

namespace graze {

std::uint32_t IdTable::take() {
  ++live_count_;
  if (free_.empty()) {
    generation_.push_back(1);
    return static_cast<std::uint32_t>(generation_.size() - 1);
  }
  const std::uint32_t index = free_.back();
  free_.pop_back();
  ++generation_[index];
  return index;
}

/// An index whose generations are used up, after 32,768 users, is not given out again.
void IdTable::free(std::uint32_t index) {
  --live_count_;
  ++generation_[index];
  if (generation_[index] != 0) resting_[0].push_back(index);
}

void IdTable::next_round() {
  if (resting_[0].empty() && resting_[1].empty()) return;
  free_.insert(free_.end(), resting_[1].begin(), resting_[1].end());
  resting_[1].clear();
  resting_[0].swap(resting_[1]);
}

std::size_t IdTable::bytes() const {
  return generation_.capacity() * 2 +
         (free_.capacity() + resting_[0].capacity() + resting_[1].capacity()) * 4;
}

}  // namespace graze
