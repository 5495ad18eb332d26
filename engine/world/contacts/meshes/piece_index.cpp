#include <graze/engine/world/contacts/meshes/piece_index.h>

#include <algorithm>
#include <numeric>

namespace graze {

void PieceIndex::start(std::span<const MeshCrossing> crossings) {
  crossings_ = crossings;
  by_a_.resize(crossings.size());
  std::iota(by_a_.begin(), by_a_.end(), 0u);
  by_b_ = by_a_;
  std::sort(by_b_.begin(), by_b_.end(), [&](std::uint32_t s, std::uint32_t t) {
    return crossings[s].pair.b != crossings[t].pair.b ? crossings[s].pair.b < crossings[t].pair.b
                                                      : s < t;
  });
  std::uint32_t points = 0;
  for (const MeshCrossing& each : crossings)
    points = std::max({points, each.from_number, each.to_number});
  points += 1 - first_point();
  first_in_point_.assign(points + 1, 0);
  const auto for_each_end = [&](auto&& visit) {
    for (std::uint32_t i = 0; i < crossings.size(); ++i) {
      visit(crossings[i].from_number - first_point(), i);
      if (crossings[i].to_number != crossings[i].from_number)
        visit(crossings[i].to_number - first_point(), i);
    }
  };
  for_each_end([&](std::uint32_t point, std::uint32_t) { ++first_in_point_[point + 1]; });
  std::partial_sum(first_in_point_.begin(), first_in_point_.end(), first_in_point_.begin());
  in_points_.resize(first_in_point_.back());
  // Filling moves each beginning on to the next one's, and they are moved back.
  for_each_end(
      [&](std::uint32_t point, std::uint32_t i) { in_points_[first_in_point_[point]++] = i; });
  std::move_backward(first_in_point_.begin(), first_in_point_.end() - 1, first_in_point_.end());
  first_in_point_[0] = 0;
}

std::span<const std::uint32_t> PieceIndex::on_triangle(std::uint32_t triangle, bool is_of_a) const {
  const std::vector<std::uint32_t>& order = is_of_a ? by_a_ : by_b_;
  const auto of = [&](std::uint32_t i) {
    return is_of_a ? crossings_[i].pair.a : crossings_[i].pair.b;
  };
  const auto first =
      std::lower_bound(order.begin(), order.end(), triangle,
                       [&](std::uint32_t i, std::uint32_t value) { return of(i) < value; });
  auto last = first;
  while (last != order.end() && of(*last) == triangle)
    ++last;
  return {first, last};
}

std::span<const std::uint32_t> PieceIndex::in_point(std::uint32_t point) const {
  return std::span(in_points_)
      .subspan(first_in_point_[point], first_in_point_[point + 1] - first_in_point_[point]);
}

}  // namespace graze
