#include <numbers>

#include "data/generator/parts/thread_profile.h"
#include "data/generator/poses.h"

namespace graze::generator {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kMillimetre = 1e-3;
constexpr double kPi = std::numbers::pi;

// Where the turning begins: seven pitches up the thread, which is at its full depth there and
// as far as the nut comes down.
constexpr double kStartHeight = 7 * kM8.pitch;

// Turned by an angle around the bolt's axis, where the thread takes it, then moved by `offset`.
Isometry3d on_thread(double angle, const Vector3d& offset) {
  const double height = kStartHeight + kM8.pitch * angle / (2 * kPi);
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = (Vector3d(0, 0, height) + offset) * kMillimetre;
  return pose;
}

// Screwed on by two turns, towards the head, in steps of ten degrees.
PoseList turning() {
  PoseList list{"bolt-nut.turning.txt", {}};
  for (int i = 0; i < 72; ++i)
    list.poses.push_back(on_thread(-4 * kPi * i / 72, Vector3d::Zero()));
  return list;
}

// Tilted about an axis across the bolt, through the nut's middle, by 0 to 2 degrees.
PoseList cross() {
  const Vector3d middle(0, 0, 6.8 / 2 * kMillimetre);
  PoseList list{"bolt-nut.cross.txt", {}};
  for (int i = 0; i < 25; ++i) {
    const double angle = 2 * kPi / 180 * i / 24;
    list.poses.push_back(on_thread(0, Vector3d::Zero()) * Eigen::Translation3d(middle) *
                         AngleAxisd(angle, Vector3d::UnitX()) * Eigen::Translation3d(-middle));
  }
  return list;
}

// Far from where the thread takes it: shifted sideways, along the axis, and both.
PoseList deep() {
  return {
      "bolt-nut.deep.txt",
      {on_thread(0, {0.5, 0, 0}), on_thread(0, {0, 1.5, 0}), on_thread(0, {0, 0, kM8.pitch / 2}),
       on_thread(1, {0.7, -0.4, 0.3}), on_thread(2, {3, 2, 1}), on_thread(3, {0, 0, -10})}};
}

// Beyond the tip by a quarter of a millimetre and more, and beside the shank.
PoseList apart() {
  return {"bolt-nut.apart.txt",
          {on_thread(0, {0, 0, 11.5}), on_thread(1, {0.2, 0.1, 12}), on_thread(0, {13, 0, 0}),
           on_thread(2, {-9, 9, 2}), on_thread(0, {0, 0, 60}), on_thread(0, {80, -50, -30})}};
}

}  // namespace

std::vector<PoseList> bolt_nut_poses() {
  return {turning(), cross(), deep(), apart()};
}

}  // namespace graze::generator
