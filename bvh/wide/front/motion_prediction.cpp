#include <graze/bvh/wide/front/motion_prediction.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {

MotionPrediction::MotionPrediction(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                                   const WideTree& tree_a, const WideTree& tree_b, double distance,
                                   double turn)
    : step_{QueryDisplacement(before[0], now[0], tree_b, turn),
            QueryDisplacement(before[1], now[1], tree_a, turn)},
      distance_(distance) {
  const WideTree* const trees[2] = {&tree_b, &tree_a};
  for (int side = 0; side < 2; ++side) {
    const FloatBox& box = trees[side]->box();
    const double unit = now[side].units_b;
    for (int i = 0; i < 3; ++i) {
      query_[side].middle[i] = (0.5 * box.min[i] + 0.5 * box.max[i]) * unit;
      query_[side].half[i] = (0.5 * box.max[i] - 0.5 * box.min[i]) * unit;
      query_[side].translation[i] = now[side].translation[i] - before[side].translation[i];
      for (int j = 0; j < 3; ++j)
        query_[side].rotation[i][j] = now[side].rotation[i][j] - before[side].rotation[i][j];
    }
  }
}

double MotionPrediction::Query::deviation(const RelativeFrame& before, const RelativeFrame& now,
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
  // As in engine/mesh/memory/pair_cache.cpp, with differences of what is itself rounded.
  const double along = std::sqrt(off[0] * off[0] + off[1] * off[1] + off[2] * off[2]);
  return (along + turned) * (1 + 0x1p-40) + 0x1p-48 * sizes + 0x1p-500;
}

double MotionPrediction::deviation(const RelativeFrame (&before)[2], const RelativeFrame (&now)[2],
                                   double distance) const {
  const double share = distance / distance_;
  return std::max(query_[0].deviation(before[0], now[0], share),
                  query_[1].deviation(before[1], now[1], share));
}

}  // namespace graze::bvh
