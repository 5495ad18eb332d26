// What moves does so as mechanics say: edges within a plane mean nothing, nobody gains energy.

#include <gtest/gtest.h>

#include <graze/engine/mesh/mesh_ray.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "samples/simulation/scenes/judgement.h"
#include "samples/simulation/scenes/machines.h"
#include "samples/simulation/scenes/parts.h"
#include "samples/simulation/scenes/planks.h"
#include "samples/simulation/scenes/rolling.h"
#include "samples/simulation/scenes/terrains.h"

namespace graze::samples {
namespace {

constexpr Surface kSurfaces[] = {Surface::Analytic, Surface::Mesh};

TEST(SolverScenes, ABallRollsAHundredMetresOverTrianglesAsOverAPlane) {
  for (const Surface ground : kSurfaces) {
    SCOPED_TRACE(name_of(ground));
    const Scene scene = rolling_ball(ground);
    EXPECT_EQ(scene.steps, 600);
    const Roll result = roll(scene);
    EXPECT_NEAR(result.distance, 100, 0.1);
    EXPECT_LT(result.aside, 1e-3);
    EXPECT_LT(result.height, 1e-3);
    EXPECT_LT(std::abs(result.slower), 1e-3);
    EXPECT_LT(result.unrolled, 1e-3);
  }
}

TEST(SolverScenes, AWheelClimbsAKerbAndLosesWhatTheImpactTakes) {
  for (const Surface surface : kSurfaces) {
    SCOPED_TRACE(name_of(surface));
    const Scene scene = wheel_over_kerb(surface);
    RigidBody wheel;
    const SceneReport report =
        run_scene(scene, [&](const SceneRun& run) { wheel = run.body("wheel"); });
    EXPECT_EQ(complaints(report, scene.outcome), std::vector<std::string>{});
    EXPECT_GT(wheel.at.x(), 1.2);
    EXPECT_NEAR(wheel.at.z(), 0.32, 3e-3);
    // Of a mesh's row of edges four points at most are contacts, not always as deep on both sides:
    // the wheel wobbles, which costs it some of its speed.
    const double share = surface == Surface::Analytic ? 0.95 : 0.8;
    EXPECT_GT(wheel.velocity.x(), share * speed_beyond_kerb());
    EXPECT_LT(wheel.velocity.x(), 1.01 * speed_beyond_kerb());
  }
}

/// How far a body has turned about z, radians, as its pose is looked at often enough.
class TurnMeter {
 public:
  void look(const Pose& pose) {
    const double now = std::atan2(pose(1, 0), pose(0, 0));
    if (has_looked_) turned_ += std::remainder(now - last_, 2 * std::numbers::pi);
    last_ = now, has_looked_ = true;
  }
  double turned() const { return turned_; }

 private:
  double last_ = 0, turned_ = 0;
  bool has_looked_ = false;
};

TEST(SolverScenes, AGearDrivesAPinionByTheRatioOfTheirTeeth) {
  const Scene scene = gears(Extent::Small, GRAZE_DATA_DIR);
  TurnMeter gear, pinion;
  double deepest = 0;
  run_scene(scene, [&](const SceneRun& run) {
    gear.look(run.body("gear").pose()), pinion.look(run.body("pinion").pose());
    deepest = std::max(deepest, run.depth());
  });
  EXPECT_GT(std::abs(gear.turned()), 2);
  // There is play between the teeth.
  EXPECT_NEAR(pinion.turned(), -gear.turned() * kGearTeeth / kPinionTeeth, 0.02);
  EXPECT_LT(deepest, 3e-4);  // a step takes a flank 0.2 mm on
}

TEST(SolverScenes, ANutScrewsItselfDownUnlessFrictionHoldsIt) {
  for (const double friction : {0.01, 0.3}) {
    const Scene scene = nut_on_bolt(friction, Extent::Small, GRAZE_DATA_DIR);
    TurnMeter nut;
    Eigen::Vector3d at;
    run_scene(scene, [&](const SceneRun& run) {
      nut.look(run.body("nut").pose());
      at = run.body("nut").pose().translation();
    });
    EXPECT_LT(at.head<2>().norm(), 5e-4) << friction;
    // It has sunk by the play of the thread, too.
    EXPECT_NEAR(at.z(), 8 * kPitch + kPitch * nut.turned() / (2 * std::numbers::pi), 2e-4)
        << friction;
    if (friction < 0.1) {
      EXPECT_LT(nut.turned(), -0.2);
    } else {
      EXPECT_GT(nut.turned(), -0.1);
    }
  }
}

TEST(SolverScenes, APlankWhoseMiddleHasPassedTheEdgeTips) {
  for (const Surface surface : kSurfaces) {
    const Scene scene = tipping_plank(surface);
    double height = 0;  // of the end that reaches out
    const SceneReport report = run_scene(scene, [&](const SceneRun& run) {
      height = (run.body("plank0").pose() * Eigen::Vector3d(1.2, 0, 0)).z();
    });
    EXPECT_EQ(complaints(report, scene.outcome), std::vector<std::string>{});
    EXPECT_LT(height, 0.1) << scene.name;  // it is on the floor: the table is 0.8 m high
  }
}

TEST(SolverScenes, NothingFallsThroughATerrain) {
  for (const Surface surface : kSurfaces) {
    const Scene scene = terrain(surface, Extent::Small, GRAZE_DATA_DIR);
    const Mesh ground = *scene.bodies.front().shape.as<Mesh>();
    std::vector<RigidBody> end;
    const SceneReport report = run_scene(scene, [&](const SceneRun& run) { end = run.bodies(); });
    EXPECT_EQ(complaints(report, scene.outcome), std::vector<std::string>{});
    int above = 0;
    for (std::size_t i = 1; i < end.size(); ++i) {
      const bool is_inside =
          (end[i].at.head<2>().array() > ground.bounds().min.head<2>().array()).all() &&
          (end[i].at.head<2>().array() < ground.bounds().max.head<2>().array()).all();
      if (!is_inside) continue;  // it rolled over the edge
      const auto below = cast_ray(PlacedMeshView{ground}, Ray{end[i].at, {0, 0, -1}});
      EXPECT_TRUE(below) << scene.name << ", body " << i;
      above += below.has_value();
    }
    EXPECT_GT(above, 24) << scene.name;  // of 36
  }
}

}  // namespace
}  // namespace graze::samples
