#include <graze/bvh/value/local_frame.h>
#include <graze/bvh/wide/front/front_planes.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {

namespace {

/// Motions that are larger are not kept in floats.
constexpr double kLargest = 0x1p60;

}  // namespace

QueryDisplacement::QueryDisplacement(const RelativeFrame& first, const RelativeFrame& now,
                                     const WideTree& query, double all_changes)
    : rotation_sum(static_cast<float>(all_changes)) {
  const FloatBox& box = query.box();
  double sizes = 0;
  for (int i = 0; i < 3; ++i) {
    const double came = now.translation[i] - first.translation[i];
    translation_change[i] = static_cast<float>(came);
    sizes += std::abs(came);
    for (int j = 0; j < 3; ++j) {
      const double change = now.rotation[i][j] - first.rotation[i][j];
      rotation_change[i][j] = static_cast<float>(change);
      const float largest = std::max(std::abs(box.min[j]), std::abs(box.max[j]));
      sizes += std::abs(change) * static_cast<double>(largest) * now.units_b;
    }
  }
  if (!(sizes < kLargest)) {
    // Nothing is known, in numbers that stay finite.
    std::fill_n(&rotation_change[0][0], 9, 0.0f);
    std::fill_n(translation_change, 3, 0.0f);
    error = 0x1p120f;
    return;
  }
  // Each of the five sums of three or four products of floats rounds by less than 8 u of what it
  // adds up, u = 2^-24, and the centre by u; the doubles above count for nothing beside that.
  error = rounded_up(sizes * 0x1p-20 + 0x1p-100);
}

MotionPrediction::MotionPrediction(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                                   const WideTree& tree_a, const WideTree& tree_b, double distance,
                                   double rotation_change)
    : displacement_{QueryDisplacement(before[0], now[0], tree_b, rotation_change),
                    QueryDisplacement(before[1], now[1], tree_a, rotation_change)},
      distance_(distance) {
  const WideTree* const trees[2] = {&tree_b, &tree_a};
  for (int side = 0; side < 2; ++side) {
    const FloatBox& box = trees[side]->box();
    const double unit = now[side].units_b;
    for (int i = 0; i < 3; ++i) {
      query_trees_[side].middle[i] = (0.5 * box.min[i] + 0.5 * box.max[i]) * unit;
      query_trees_[side].half[i] = (0.5 * box.max[i] - 0.5 * box.min[i]) * unit;
      query_trees_[side].translation[i] = now[side].translation[i] - before[side].translation[i];
      for (int j = 0; j < 3; ++j)
        query_trees_[side].rotation[i][j] = now[side].rotation[i][j] - before[side].rotation[i][j];
    }
  }
}

double MotionPrediction::QueryTree::deviation(const RelativeFrame& before, const RelativeFrame& now,
                                              double share) const {
  double off[3];
  double sizes = 0;
  double turned = 0;
  for (int i = 0; i < 3; ++i) {
    const double came = now.translation[i] - before.translation[i];
    off[i] = came - share * translation[i];
    sizes += std::abs(came) + std::abs(share * translation[i]);
  }
  for (int j = 0; j < 3; ++j) {
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      const double came = now.rotation[i][j] - before.rotation[i][j];
      const double change = came - share * rotation[i][j];
      off[i] += change * middle[j];
      square += change * change;
      sizes +=
          (std::abs(came) + std::abs(share * rotation[i][j])) * (std::abs(middle[j]) + half[j]);
    }
    turned += half[j] * std::sqrt(square);
  }
  // These bounds are as in engine/mesh/memory/pair_cache.cpp, with differences of what is itself
  // rounded.
  const double along = std::sqrt(off[0] * off[0] + off[1] * off[1] + off[2] * off[2]);
  return (along + turned) * (1 + 0x1p-40) + 0x1p-48 * sizes + 0x1p-500;
}

double MotionPrediction::deviation(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                                   double distance) const {
  const double share = distance / distance_;
  return std::max(query_trees_[0].deviation(before[0], now[0], share),
                  query_trees_[1].deviation(before[1], now[1], share));
}

QueryBall::QueryBall(const WideChildRef& child, float units, int side_of_tested)
    : tested_side(static_cast<std::uint16_t>(side_of_tested)) {
  const WideNode& node = *child.node;
  const std::uint32_t lane = child.lane;
  float square = 0;
  float sizes = 0;
  for (int i = 0; i < 3; ++i) {
    const auto origin = static_cast<float>(node.origin[i]);
    float middle = origin;
    sizes += std::abs(origin);
    for (int k = 0; k < 3; ++k) {
      const float step = node.axes[i][k] * node.centre[k][lane];
      middle += step;
      sizes += std::abs(step);
    }
    centre[i] = middle * units;
    square += node.half[i][lane] * node.half[i][lane];
  }
  // The axes are at right angles and of length 1 but for 2.01 u, and a root is taken; the centre is
  // off by less than 8 u of what it adds up.
  const float radius = (std::sqrt(square) * (1 + 0x1p-18f) + sizes * 0x1p-20f + 0x1p-60f) * units;
  constexpr std::uint32_t kLowerHalf = 0xffff;
  upper_radius =
      static_cast<std::uint16_t>((std::bit_cast<std::uint32_t>(radius) + kLowerHalf) >> 16);
}

FrontPlane::FrontPlane(const double (&direction)[3], double gap_now, const QueryBall& query,
                       const QueryDisplacement& displacement) {
  float displaced[3];
  set_displacement(displaced, query, displacement);
  double kept = gap_now;
  for (int i = 0; i < 3; ++i) {
    normal[i] = static_cast<float>(direction[i]);
    kept -= static_cast<double>(normal[i]) * static_cast<double>(displaced[i]);
  }
  kept += static_cast<double>(query.radius()) *
          static_cast<double>(displacement.rotation_sum * kRoundPlanes);
  gap = rounded_down(kept - static_cast<double>(displacement.error));
}

float FrontPlane::gap_after(const QueryBall& query, const QueryDisplacement& displacement) const {
  float displaced[3];
  set_displacement(displaced, query, displacement);
  const float along =
      gap + normal[0] * displaced[0] + normal[1] * displaced[1] + normal[2] * displaced[2];
  return (along -
          (query.radius() * displacement.rotation_sum * (1 / kRoundPlanes) + displacement.error)) *
         kRoundPlanes;
}

}  // namespace graze::bvh
