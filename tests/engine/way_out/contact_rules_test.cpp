// Which change of depth or normal a contact may go on through: law 15, by contacts that a shape of
// the test's own says.

#include <graze/engine/world/contact_tracker.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::at;

/// A shape that says where it touches, whatever the poses.
class SaidShape final : public BodyShape {
 public:
  Aabb bounds(const Pose& /*pose*/) const override { return {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}; }
  bool touches(const Pose&, const BodyShape&, const Pose&) const override { return true; }
  Manifold contacts(const Pose&, const BodyShape&, const Pose&) const override { return said; }
  Manifold said;
};

/// Whether a contact that is deeper by so much, or turns by so many degrees, is another one, while
/// the body moves by so much.
bool is_new(double deeper, double degrees, double moved) {
  World world;
  ContactTracker tracker;
  const auto shape = std::make_shared<SaidShape>();
  ShapeContact contact{.point = {0, 0, 0},
                       .point_a = {0, 0, 0},
                       .point_b = {0, 0, 0},
                       .normal = {0, 0, 1},
                       .depth = 0.01,
                       .feature = {1, 2},
                       .region = 0,
                       .material_a = 0,
                       .material_b = 0};
  shape->said.add(contact);
  const BodyId body = world.add(PlacedBodyShape{shape, at(0)});
  world.add(PlacedBodyShape{std::make_shared<SaidShape>(), at(0)});
  tracker.take(world, world.update());
  const std::uint64_t first = tracker.ids(0)[0];
  world.move(body, at(0.5));  // the law counts from the last update, not from the first
  tracker.take(world, world.update());
  const double angle = degrees * std::numbers::pi / 180;
  contact.depth += deeper;
  contact.normal = {std::sin(angle), 0, std::cos(angle)};
  shape->said.clear();
  shape->said.add(contact);
  world.move(body, at(0.5 + moved));
  tracker.take(world, world.update());
  return tracker.ids(0)[0] != first;
}

// Both bodies are cubes of a diagonal of the root of 3.
TEST(ContactTracker, Law15SaysWhatAContactMayDo) {
  const double size = std::sqrt(3.0), fine = 0.9e-4 * size;
  EXPECT_FALSE(is_new(0, 0, 0));
  EXPECT_FALSE(is_new(0.9e-6 * size, 0, 0));
  EXPECT_TRUE(is_new(1.1e-6 * size, 0, 0));
  EXPECT_TRUE(is_new(-1.1e-6 * size, 0, 0));
  EXPECT_FALSE(is_new(1.9 * fine, 0, fine));
  EXPECT_TRUE(is_new(2.1 * fine, 0, fine));
  for (const double moved : {0.0, fine}) {
    EXPECT_FALSE(is_new(0, 0.99, moved));
    EXPECT_TRUE(is_new(0, 1.01, moved));
  }
  EXPECT_FALSE(is_new(0, 9.9, 10e-4 * size));
  EXPECT_TRUE(is_new(0, 10.1, 10e-4 * size));
  EXPECT_FALSE(is_new(0, 29, 0.1));
  EXPECT_TRUE(is_new(0, 31, 0.1));
}

}  // namespace
}  // namespace graze
