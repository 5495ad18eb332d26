#include <graze/engine/world/contacts/meshes/point_numbers.h>

#include <array>
#include <bit>

namespace graze {

using narrowphase::Vec3;

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

std::array<std::uint64_t, 3> bits_of(const Vec3& point) {
  return {std::bit_cast<std::uint64_t>(point.x), std::bit_cast<std::uint64_t>(point.y),
          std::bit_cast<std::uint64_t>(point.z)};
}

std::size_t hash_of(const Vec3& point, std::uint32_t piece) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15u;
  std::uint64_t hash = piece;
  for (const std::uint64_t of : bits_of(point))
    hash = (std::rotl(hash, 23) ^ of) * kOdd;
  return static_cast<std::size_t>(hash >> 32);
}

}  // namespace

void PointNumbers::number(std::span<MeshCrossing> crossings) {
  points_.clear();
  table_.assign(std::bit_ceil(4 * crossings.size()), kNone);
  for (MeshCrossing& crossing : crossings) {
    crossing.from_number = number_of(crossing.from, crossing.piece);
    crossing.to_number = number_of(crossing.to, crossing.piece);
  }
}

std::uint32_t PointNumbers::number_of(const Vec3& point, std::uint32_t piece) {
  std::size_t at = hash_of(point, piece) & (table_.size() - 1);
  for (; table_[at] != kNone; at = (at + 1) & (table_.size() - 1)) {
    const Numbered& other = points_[table_[at]];
    if (other.piece == piece && bits_of(other.point) == bits_of(point)) return table_[at];
  }
  table_[at] = static_cast<std::uint32_t>(points_.size());
  points_.push_back({point, piece});
  return table_[at];
}

}  // namespace graze
