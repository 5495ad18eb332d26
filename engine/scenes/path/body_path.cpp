#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/scenes/body_path.h>
#include <graze/engine/scenes/path/turn.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace graze {
namespace {

using scenes::Quaternion;

Pose pose_on(const KeyPath& path, double time) {
  const auto after = std::upper_bound(path.keys.begin(), path.keys.end(), time,
                                      [](double t, const PoseKey& key) { return t < key.time; });
  if (after == path.keys.begin()) return path.keys.front().pose;
  const PoseKey& from = *std::prev(after);
  if (after == path.keys.end() || from.time == time) return from.pose;
  const PoseKey& to = *after;
  const double fraction = (time - from.time) / (to.time - from.time);
  const Quaternion rotation =
      scenes::between(scenes::quaternion_of(from.pose.matrix().topLeftCorner<3, 3>()),
                      scenes::quaternion_of(to.pose.matrix().topLeftCorner<3, 3>()), fraction);
  Pose pose = Pose::Identity();
  pose.matrix().topLeftCorner<3, 3>() = scenes::matrix_of(rotation);
  for (int i = 0; i < 3; ++i) {
    const double start = from.pose(i, 3), end = to.pose(i, 3);
    // This is not start + (end - start) f, whose difference may overflow where the result does not.
    pose.matrix()(i, 3) = start * (1 - fraction) + end * fraction;
  }
  return pose;
}

Pose pose_on(const SteadyPath& path, const Pose& start, double time) {
  Pose pose = start;
  for (int i = 0; i < 3; ++i)
    pose.matrix()(i, 3) = start(i, 3) + path.velocity.data()[i] * time;
  const double turns = path.rate * time;
  if (turns == 0) return pose;
  if (!std::isfinite(turns)) {
    pose.matrix()(0, 0) = std::numeric_limits<double>::quiet_NaN();  // is refused where poses are
    return pose;
  }
  pose.matrix().topLeftCorner<3, 3>() = scenes::product(
      scenes::matrix_of(scenes::turned_by(path.axis, turns)), start.matrix().topLeftCorner<3, 3>());
  return pose;
}

}  // namespace

Pose pose_at(const BodyPath& path, const Pose& start, double time) {
  return bvh::in_standard_arithmetic([&]() -> Pose {
    if (const auto* keys = std::get_if<KeyPath>(&path)) return pose_on(*keys, time);
    if (const auto* steady = std::get_if<SteadyPath>(&path)) return pose_on(*steady, start, time);
    return start;
  });
}

}  // namespace graze
