#include <graze/engine/world/contacts/meshes/piece_index.h>

#include <algorithm>
#include <numeric>

namespace graze {

void PieceIndex::start(std::span<const MeshCrossing> crossings) {
  crossings_ = crossings;
  std::vector<std::uint32_t>&by_a = orders_[true].crossings, &by_b = orders_[false].crossings;
  by_a.resize(crossings.size());
  std::iota(by_a.begin(), by_a.end(), 0u);
  by_b = by_a;
  std::sort(by_b.begin(), by_b.end(), [&](std::uint32_t s, std::uint32_t t) {
    return crossings[s].pair.b != crossings[t].pair.b ? crossings[s].pair.b < crossings[t].pair.b
                                                      : s < t;
  });
  find_runs(true), find_runs(false);
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

void PieceIndex::find_runs(bool is_of_a) {
  Order& order = orders_[is_of_a];
  order.first.resize(crossings_.size()), order.last.resize(crossings_.size());
  std::uint32_t first = 0;
  for (std::uint32_t place = 0; place < order.crossings.size(); ++place) {
    const std::uint32_t crossing = order.crossings[place];
    if (triangle_of(crossing, is_of_a) != triangle_of(order.crossings[first], is_of_a))
      first = place;
    order.first[crossing] = first;
    order.last[first] = place + 1;
  }
}

std::span<const std::uint32_t> PieceIndex::on_triangle(std::uint32_t triangle, bool is_of_a) const {
  const std::vector<std::uint32_t>& order = orders_[is_of_a].crossings;
  const auto at = std::lower_bound(order.begin(), order.end(), triangle,
                                   [&](std::uint32_t crossing, std::uint32_t value) {
                                     return triangle_of(crossing, is_of_a) < value;
                                   });
  if (at == order.end() || triangle_of(*at, is_of_a) != triangle) return {};
  return on_triangle_of(*at, is_of_a);
}

std::span<const std::uint32_t> PieceIndex::in_point(std::uint32_t point) const {
  return std::span(in_points_)
      .subspan(first_in_point_[point], first_in_point_[point + 1] - first_in_point_[point]);
}

}  // namespace graze
