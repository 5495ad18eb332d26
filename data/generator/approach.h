#pragma once

#include <graze/engine/mesh/mesh.h>

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>

#include "data/generator/dice.h"
#include "data/generator/poses.h"

namespace graze::generator {

/// How B comes towards A: turned, and then moved so that the middle of its bounds goes straight
/// from `start` in `direction`, a unit vector, for at most `length`. Metres, in A's frame.
struct Approach {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d start;
  Eigen::Vector3d direction;
  double length;
};

/// Two meshes, and how one draws a way for them to meet. `size` is what distances are measured in,
/// metres.
struct ApproachPair {
  Mesh mesh_a;
  Mesh mesh_b;
  double size;
  std::function<Approach(Dice&)> draw;
};

/// The pose after B has come this far.
Eigen::Isometry3d at_distance(const ApproachPair& pair, const Approach& approach, double distance);

/// How far B comes until it first touches A: at this distance the meshes intersect, and by a part
/// in 10^12 before it they do not. The way is looked at every 1/32 of the size; nothing if no touch
/// is seen, or if the meshes intersect at the start.
std::optional<double> first_touch(const ApproachPair& pair, const Approach& approach);

/// What the poses of a list have in common: clear or intersecting, and how far beyond the first
/// touch. Negative steps stop short of it.
struct Regime {
  std::string file;
  bool is_hit;
  std::function<double(Dice&, int index)> step;  ///< in units of the pair's size
};

/// B stops 1 to 4 sizes before the touch.
Regime far_regime(const std::string& file);
/// B stops 0.1, 1 and 5 percent of the size before the touch, in turn.
Regime near_regime(const std::string& file);
/// B is 0.1 to 1 percent of the size too far.
Regime touch_regime(const std::string& file);
/// B is 10 to 50 percent of the size too far.
Regime deep_regime(const std::string& file);

/// As many poses, each by an approach of its own that is drawn again until the pose does as the
/// regime says. Throws std::runtime_error if the draws are nearly all in vain.
PoseList approach(const ApproachPair& pair, const Regime& regime, Dice& dice);

}  // namespace graze::generator
