// What scenes are made of: masses by formulas beside those of fine meshes, and bodies that spin.

#include <gtest/gtest.h>

#include <graze/bvh/error.h>
#include <graze/engine/world/compound.h>

#include <vector>

#include "samples/simulation/contact_solver.h"
#include "samples/simulation/integrator.h"
#include "samples/simulation/pellet_watch.h"
#include "samples/simulation/scenes/parts.h"
#include "samples/simulation/shape_mass.h"

namespace graze::samples {
namespace {

const Shape kSolids[] = {Box{{0.1, 0.2, 0.3}}, Sphere{{0.1, 0, 0.2}, 0.3},
                         Capsule{0.1, 0.2},    Cylinder{0.2, 0.3},
                         Cone{0.2, 0.3},       Ellipsoid{{0, 0.1, 0}, {0.1, 0.2, 0.3}},
                         drum(0.3, 0.2)};

TEST(ShapeMass, IsThatOfTheMeshOfItsSurface) {
  for (const Shape& shape : kSolids) {
    SCOPED_TRACE(name_of(shape.kind()));
    const Mesh surface = surface_of(shape, {.sectors = 400, .rings = 200});
    EXPECT_TRUE(surface.topology().is_closed);
    const MassProperties by_formula = mass_properties(shape, 700);
    const MassProperties by_mesh = mass_properties(surface, 700);
    EXPECT_NEAR(by_formula.mass, by_mesh.mass, 3e-4 * by_mesh.mass);
    EXPECT_LT((by_formula.centre - by_mesh.centre).norm(), 1e-4);
    EXPECT_LT((by_formula.inertia - by_mesh.inertia).norm(), 1e-3 * by_mesh.inertia.norm());
    EXPECT_TRUE((by_formula.inertia * by_formula.inverse_inertia).isIdentity(1e-9));
    for (const Eigen::Vector3d& vertex : surface.vertices())
      EXPECT_LE((vertex - by_formula.centre).norm(),
                bounding_radius_about(shape, by_formula.centre) * (1 + 1e-12));
  }
  EXPECT_THROW(mass_properties(Shape(HalfSpace{{0, 0, 1}}), 1), InputError);
  EXPECT_THROW(surface_of(HalfSpace{{0, 0, 1}}), InputError);
  EXPECT_THROW(bounding_radius_about(HalfSpace{{0, 0, 1}}, {0, 0, 0}), InputError);
}

TEST(Integrator, ATumblingBodyGainsNoEnergyAndKeepsMostOfIt) {
  const MassProperties mass = mass_properties(Shape(Box{{0.3, 0.1, 0.2}}), 1000);
  RigidBody body{.id = {},
                 .mass = &mass,
                 .at = {0, 0, 0},
                 .turn = Eigen::Quaterniond::Identity(),
                 .spin = {0.1, 0.2, 3},  // about the axis between the least and the greatest
                 .bounding_radius = 0.4};
  const double first = body.kinetic_energy();
  double before = first;
  for (int i = 0; i < 2000; ++i) {
    precess(body, 1.0 / 600);
    advance(body, 1.0 / 600);
    EXPECT_LT(body.kinetic_energy(), before * (1 + 1e-6));
    before = body.kinetic_energy();
  }
  EXPECT_GT(before, 0.9 * first);
  EXPECT_GT((body.spin - Eigen::Vector3d(0.1, 0.2, 3)).norm(), 1e-3);
}

// Of a compound each part has contacts of its own: those of the last part took the place of all.
TEST(ContactSolver, HoldsWhatStandsOnSeveralParts) {
  World world;
  Compound table;
  for (const double x : {-1.0, 0.0, 1.0}) {
    Pose at = Pose::Identity();
    at.translation().x() = x;
    table.add({Sphere{{0, 0, 0}, 0.25}, at});
  }
  world.add({HalfSpace{{0, 0, 1}}}, {.kind = BodyKind::Static, .user_data = ContactSolver::kFixed});
  const MassProperties mass = mass_properties(Shape(Box{{1, 0.25, 0.25}}), 1000);
  std::vector<RigidBody> bodies(1, {.id = {},
                                    .mass = &mass,
                                    .at = {0, 0, 0.249},
                                    .turn = Eigen::Quaterniond::Identity(),
                                    .bounding_radius = 1.25});
  bodies[0].id = world.add(PlacedBodyShape{share(table), bodies[0].pose()}, {.user_data = 0});
  ContactSolver solver({.step = 1.0 / 150, .keeps_push = true});
  std::vector<std::size_t> woken;
  for (int step = 0; step < 60; ++step) {
    solver.take(world, world.update(), bodies, woken);
    EXPECT_EQ(solver.contact_count(), 3u);
    bodies[0].velocity.z() -= 9.81 / 150;
    solver.solve(bodies, woken);
    advance(bodies[0], 1.0 / 150);
    solver.relax(bodies);
    world.move(bodies[0].id, bodies[0].pose());
  }
  EXPECT_NEAR(bodies[0].at.z(), 0.25, 2e-3);
  EXPECT_LT(bodies[0].velocity.norm() + bodies[0].spin.norm(), 1e-3);
}

TEST(PelletWatch, TellsAJumpOverTheRimFromAWayThroughTheWall) {
  const BinSize size;
  const double above = 1.5 * size.height, low = 0.5 * size.height, far = 2 * size.mouth_radius;
  PelletWatch over, through, below;
  for (const Eigen::Vector3d& at :
       {Eigen::Vector3d(0, 0, above), Eigen::Vector3d(0, 0, low), Eigen::Vector3d(far, 0, above)})
    over.see(size, at);
  EXPECT_FALSE(over.has_jumped_out());
  over.see(size, {far, 0, low});
  over.see(size, {far, 0, -1});
  EXPECT_TRUE(over.has_jumped_out());
  EXPECT_FALSE(over.has_gone_through());
  for (const Eigen::Vector3d& at : {Eigen::Vector3d(0, 0, low), Eigen::Vector3d(far, 0, low)})
    through.see(size, at);
  EXPECT_TRUE(through.has_gone_through());
  for (const Eigen::Vector3d& at : {Eigen::Vector3d(0, 0, low), Eigen::Vector3d(0, 0, -low)})
    below.see(size, at);
  EXPECT_TRUE(below.has_gone_through());
  EXPECT_FALSE(below.has_jumped_out());
}

}  // namespace
}  // namespace graze::samples
