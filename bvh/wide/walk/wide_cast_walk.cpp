#include <graze/bvh/value/dot.h>
#include <graze/bvh/wide/walk/wide_cast_walk.h>

#include <algorithm>
#include <cmath>

namespace graze::bvh {
namespace {

// Of two unit vectors: 4 degrees.
constexpr double kNearlyAlike = 0.9976;

// Normals that are closer to being across the direction tell too little of when.
constexpr double kLeastAlong = 0x1p-10;

// What the motion is along an axis, both being off by a few 2^-53, as a share.
constexpr double kAlongShare = 1 - 0x1p-20;

}  // namespace

WideCastWalk::State::State(const WideTree& tree_a, const WideTree& tree_b,
                           const RelativeFrame& frame)
    : tree{&tree_a, &tree_b},
      b_in_a(frame),
      scale_b(static_cast<float>(frame.units_b / frame.units_a)) {
  open.push({tree_a.root(), tree_b.root(), 0});
}

// Of the slack, once more for what B goes along axes across the direction (wide_bounds.h).
WideCastWalk::WideCastWalk(const WideTree& tree_a, const WideTree& tree_b,
                           const RelativeFrame& b_in_a, const double (&direction)[3])
    : state_(tree_a, tree_b, b_in_a) {
  state_.b_in_a.slack *= 4.0 / 3;
  double axes[3][3];
  set_axes(axes, direction);
  std::copy(axes[0], axes[0] + 3, state_.direction);
  std::copy(axes[1], axes[1] + 3, state_.across[0]);
  std::copy(axes[2], axes[2] + 3, state_.across[1]);
  const double centre[3] = {0, 0, 0};
  align_to(state_.straight, state_.b_in_a, axes, centre);
  turn();
}

void WideCastWalk::turn() {
  double axes[3][3];
  for (int i = 0; i < 3; ++i) {
    axes[0][i] = state_.normal[i];
    axes[1][i] = std::sqrt(0.5) * (state_.across[0][i] + state_.across[1][i]);
    axes[2][i] = std::sqrt(0.5) * (state_.across[0][i] - state_.across[1][i]);
  }
  const double centre[3] = {0, 0, 0};
  align_to(state_.turned, state_.b_in_a, axes, centre);
}

void WideCastWalk::take_normal(const double (&normal)[3]) {
  const double along = dot(normal, state_.direction);
  if (!(std::abs(along) > kLeastAlong)) return;
  const double sense = along < 0 ? -1 : 1;
  if (sense * dot(normal, state_.normal) > kNearlyAlike) return;
  for (int i = 0; i < 3; ++i)
    state_.normal[i] = sense * normal[i];
  state_.per_normal = static_cast<float>(kAlongShare / std::abs(along));
  ++state_.normals;
  turn();
}

}  // namespace graze::bvh
