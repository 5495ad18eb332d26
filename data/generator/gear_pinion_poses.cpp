#include <numbers>

#include "data/generator/parts/gear.h"
#include "data/generator/poses.h"

namespace graze::generator {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kMillimetre = 1e-3;
constexpr double kPitch = 2 * std::numbers::pi / kGear.gear.teeth;

// The pinion beside the gear when the gear, standing on its axis, has turned by `angle`. A tooth of
// the gear points at the pinion at angle 0; the pinion, with an odd number of teeth, turns a gap
// towards it without being turned. Seen from the gear, the pinion rolls around it backwards.
Isometry3d rolled(double angle, double extra_distance) {
  const double distance =
      kGear.gear.reference_radius() + kPinion.gear.reference_radius() + extra_distance;
  const double pinion_angle = -angle * kGear.gear.teeth / kPinion.gear.teeth;
  return AngleAxisd(-angle, Vector3d::UnitZ()) *
         Eigen::Translation3d(distance * kMillimetre, 0, 0) *
         AngleAxisd(pinion_angle, Vector3d::UnitZ());
}

// Over one pitch of the teeth, at the nominal distance.
PoseList mesh() {
  PoseList list{"gear-pinion.mesh.txt", {}};
  for (int i = 0; i < 60; ++i)
    list.poses.push_back(rolled(kPitch * i / 60, 0));
  return list;
}

// From 0.1 mm beyond the nominal distance to 0.4 mm within it.
PoseList tight() {
  PoseList list{"gear-pinion.tight.txt", {}};
  for (int i = 0; i < 26; ++i)
    list.poses.push_back(rolled(kPitch / 3, 0.1 - 0.02 * i));
  return list;
}

PoseList deep() {
  return {"gear-pinion.deep.txt",
          {rolled(0, -0.6), rolled(kPitch / 2, -1.5), rolled(kPitch / 4, -3), rolled(1, -8)}};
}

// Teeth out of mesh, by a hair and by far.
PoseList apart() {
  return {"gear-pinion.apart.txt",
          {rolled(0, 4.2), rolled(kPitch / 2, 5), rolled(2, 10), rolled(3, 200)}};
}

}  // namespace

std::vector<PoseList> gear_pinion_poses() {
  return {mesh(), tight(), deep(), apart()};
}

}  // namespace graze::generator
