// Bodies that move and turn: where they are, when they meet first, and which of many motions are
// free.

#include <cmath>
#include <numbers>

#include "samples/examples/example.h"

using examples::expect;

int main() {
  const graze::Mesh cube = examples::cube(1);
  const double turn = 2 * std::numbers::pi;

  // Two turns about a line along z while it rises by a metre for each.
  const graze::RigidMotion screw = graze::RigidMotion::screw(
      examples::at(2, 0, 0), {.point = {2.5, 0.5, 0}, .angle = 2 * turn, .pitch = 1});
  expect(screw.axis().z() == 1 && screw.angle() == 2 * turn, "it is kept as it was made");
  expect((screw.shift() - Eigen::Vector3d(0, 0, 2)).norm() < 1e-14, "a shift along the axis");
  expect(graze::are_equal(screw.at(0), screw.start()), "it starts where it was told");
  expect((screw.at(1).translation() - Eigen::Vector3d(2, 0, 2)).norm() < 1e-14, "two metres up");
  expect(screw.centre().x() == 2.5, "and turns about a point of the line");

  // It passes beside a cube at rest. "Free" is proved for all times, not for samples.
  const graze::RigidMotion rest(graze::Pose::Identity());
  expect(graze::is_free({cube, rest}, {cube, screw}), "free, with a clearance of nothing");
  expect(!graze::is_free({cube, rest}, {cube, screw}, {.clearance = 0.9}),
         "but not with one of 0.9 m");

  // The proof as plain numbers, and a check of it that trusts nobody.
  const std::optional<graze::FreedomCertificate> proof =
      graze::certify_free({cube, rest}, {cube, screw});
  expect(proof && graze::proves_freedom(*proof, {cube, rest}, {cube, screw}), "it is a proof");
  expect(!graze::proves_freedom(*proof, {cube, rest}, {cube, rest}),
         "of this motion, not of another");

  // From one pose to another, the centre of the body straight: it meets the cube halfway.
  const graze::RigidMotion slide =
      graze::RigidMotion::between(examples::at(2, 0, 0), examples::at(0, 0, 0), {0.5, 0.5, 0.5});
  const graze::RigidContact met = graze::first_contact({cube, rest}, {cube, slide});
  expect(met.status == graze::RigidStatus::Hit, "a contact is proved");
  expect(met.low <= 0.5 && met.high >= 0.5 && met.high - met.low < 1e-5, "never late, and near");
  expect(graze::intersects({cube, rest.at(met.high)}, {cube, slide.at(met.high)}),
         "and anybody can see it in the poses of its witness");
  const std::optional<double> last = graze::last_free({cube, rest}, {cube, slide});
  expect(last && *last < met.low, "how far a planner may go");

  // The same two poses as a screw, and a body with velocities for two seconds.
  const graze::RigidMotion turned = graze::RigidMotion::screw_between(
      examples::at(2, 0, 0), graze::Pose(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitZ())));
  const graze::RigidMotion thrown = graze::RigidMotion::from_velocities(
      examples::at(0, 0, 2), {.linear = {0, 0, 1}, .angular = {0, 3, 0}, .duration = 2});

  // Shapes as well: a ball that falls half a metre onto a floor.
  const graze::RigidMotion falls(examples::at(0, 0, 1), {.shift = {0, 0, -1}});
  const graze::RigidContact landed = graze::first_contact({graze::HalfSpace{{0, 0, 1}}, rest},
                                                          {graze::Sphere{{0, 0, 0}, 0.5}, falls});
  expect(landed.status == graze::RigidStatus::Hit && landed.low <= 0.5, "halfway, never late");

  // What goes straight needs no motion: never late, and exact for meshes, balls and boxes.
  const std::optional<graze::ShapeCast> slid = graze::cast(
      {graze::Box{{1, 1, 1}}}, {graze::Capsule{0.5, 1}, examples::at(4, 0, 0)}, {-5, 0, 0});
  expect(slid && slid->time <= 0.5 && slid->time > 0.4999999, "two and a half metres of five");
  expect(slid->normal.x() > 0.999999, "towards the capsule");

  // Edges of a roadmap, on all threads.
  const std::vector<graze::RigidMotion> edges{screw, slide, turned, thrown};
  const std::vector<bool> free = graze::is_free({cube, rest}, {cube, edges});
  expect(free == std::vector<bool>{true, false, false, true}, "each edge as if asked alone");
  expect(graze::first_contact({cube, rest}, {cube, edges})[1] == met, "likewise");

  // Or of many bodies, each in its own motion.
  const std::vector<graze::RigidPair> pairs{{{cube, rest}, {cube, slide}},
                                            {{cube, screw}, {cube, rest}}};
  expect(graze::first_contact(pairs)[0] == met, "each pair as if asked alone");
  expect(graze::is_free(pairs) == std::vector<bool>{false, true}, "likewise");
}
