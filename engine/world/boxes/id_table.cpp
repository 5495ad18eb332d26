#include <graze/engine/world/boxes/id_table.h>

namespace graze {
namespace {

constexpr std::size_t kGrowthShare = 8, kFew = 64;

/// Makes room, but not for twice as much: a large table would be mostly room.
template <typename T>
void make_room_in(std::vector<T>& of, std::size_t size) {
  if (size > of.capacity()) of.reserve(size - 1 + size / kGrowthShare + kFew);
}

}  // namespace

template <typename Generation>
void IdTable<Generation>::prepare_take() {
  if (free_.empty()) make_room_in(generation_, generation_.size() + 1);
}

/// Makes room for an index that will rest, and then be free.
template <typename Generation>
void IdTable<Generation>::prepare_free() {
  make_room_in(resting_[0], resting_[0].size() + 1);
  make_room_in(free_, free_.size() + resting_[0].size() + resting_[1].size() + 1);
}

template <typename Generation>
void IdTable<Generation>::prepare_round() {
  make_room_in(free_, free_.size() + resting_[1].size());
}

template <typename Generation>
std::uint32_t IdTable<Generation>::take() {
  prepare_take();
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

template <typename Generation>
void IdTable<Generation>::free(std::uint32_t index) {
  prepare_free();
  --live_count_;
  ++generation_[index];
  if (generation_[index] != limit_) resting_[0].push_back(index);
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
