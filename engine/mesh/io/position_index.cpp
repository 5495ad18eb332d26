#include <graze/engine/mesh/io/position_index.h>
#include <bit>
#include <limits>
#include <utility>

namespace graze::mesh_io {
namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kFirstSlots = 64;

/// Hashes a position. Each coordinate is multiplied by an odd constant and its high half folded
/// down, so that grids, whose doubles differ in their high bits only, spread over the low bits as
/// well.
std::size_t hash(const Eigen::Vector3d& position) {
  std::uint64_t state = 0;
  for (int k = 0; k < 3; ++k) {
    state ^= std::bit_cast<std::uint64_t>(position[k]);
    state *= 0x9e3779b97f4a7c15;
    state ^= state >> 32;
  }
  return static_cast<std::size_t>(state);
}

bool is_bit_equal(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  for (int k = 0; k < 3; ++k) {
    if (std::bit_cast<std::uint64_t>(a[k]) != std::bit_cast<std::uint64_t>(b[k])) return false;
  }
  return true;
}

}  // namespace

std::uint32_t PositionIndex::add(const Eigen::Vector3d& position) {
  if (2 * positions_.size() >= slots_.size()) grow();
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(position) & mask;
  while (slots_[slot] != kFree) {
    if (is_bit_equal(positions_[slots_[slot]], position)) return slots_[slot];
    slot = (slot + 1) & mask;
  }
  slots_[slot] = static_cast<std::uint32_t>(positions_.size());
  positions_.push_back(position);
  return slots_[slot];
}

void PositionIndex::grow() {
  slots_.assign(slots_.empty() ? kFirstSlots : 2 * slots_.size(), kFree);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    std::size_t slot = hash(positions_[i]) & mask;
    while (slots_[slot] != kFree)
      slot = (slot + 1) & mask;
    slots_[slot] = static_cast<std::uint32_t>(i);
  }
}

}  // namespace graze::mesh_io
