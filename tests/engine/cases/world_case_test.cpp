// What a world says of its bodies becomes cases, which the queries of shapes answer again, bit for
// bit.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/world_case.h>
#include <gtest/gtest.h>
#include <cmath>
#include <set>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze {
namespace {

/// Shapes of all kinds, some of which go around among the others.
class WorldCases : public testing::Test {
 protected:
  WorldCases() {
    const std::vector<Eigen::Vector3d> corners = {{0, 0, 0}, {0.75, 0, 0}, {0, 0.5, 0}, {0, 0, 1}};
    const std::vector<Shape> shapes = {Sphere{{0.1, 0, 0}, 0.5},
                                       Box{{0.4, 0.3, 0.5}},
                                       Capsule{0.3, 0.2},
                                       Cylinder{0.3, 0.4},
                                       Cone{0.4, 0.5},
                                       Ellipsoid{{0, 0.1, 0}, {0.5, 0.4, 0.3}},
                                       ConvexHull(corners),
                                       Mesh(tests::make_torus(0.5, 0.2, 12, 8)),
                                       Mesh(tests::make_box({0.4, 0.4, 0.4}))};
    for (std::size_t i = 0; i < shapes.size(); ++i)
      bodies_.push_back(world_.add({shapes[i], pose_at(i, 0)}));
    world_.add({HalfSpace{{0, 0, 1}, -0.75}, Pose::Identity()}, {.kind = BodyKind::Static});
  }

  static Pose pose_at(std::size_t i, int step) {
    const double angle = 0.7 * static_cast<double>(i) + 0.05 * step;
    Pose pose = Pose::Identity();
    pose.linear() =
        Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    pose.translation() << std::cos(angle), std::sin(angle), 0.3 * std::sin(3 * angle);
    return pose;
  }

  /// It can be written, read, and asked of the shapes alone.
  void expect_replay(const Case& query) {
    const std::string text = to_json(query);
    const Case back = parse_case(text, "memory");
    EXPECT_EQ(to_json(back), text);
    EXPECT_TRUE(is_same(answer_case(back), *query.answer)) << text;
    asked_.insert(query.ask);
    if (query.answer->says) said_.insert(*query.answer->says);
  }

  World world_;
  std::vector<BodyId> bodies_;
  std::set<Ask> asked_;
  std::set<bool> said_;
};

TEST_F(WorldCases, UpdatesReplayStepByStep) {
  std::size_t contacts = 0;
  for (int step = 0; step < 40; ++step) {
    for (std::size_t i = 0; i < bodies_.size(); i += 2)
      world_.move(bodies_[i], pose_at(i, step));
    const WorldUpdate update = world_.update();
    for (const BodyPair& pair : update.begun)
      expect_replay(to_case(world_, pair, true));
    for (const BodyPair& pair : update.ended)
      expect_replay(to_case(world_, pair, false));
    for (const BodyPair& pair : update.moved)
      expect_replay(to_case(world_, pair, true));
    for (const BodyContact& contact : update.contacts) {
      expect_replay(to_case(world_, contact));
      contacts += contact.manifold.size();
    }
  }
  EXPECT_GT(contacts, 100u);
  EXPECT_EQ(said_.size(), 2u) << "some began to touch, some ceased";
  EXPECT_EQ(asked_, (std::set<Ask>{Ask::Any, Ask::Contacts}));
}

TEST_F(WorldCases, WhatIsAskedOfAWorldReplays) {
  world_.update();
  const CaseBody asked(Capsule{0.2, 0.3}, pose_at(3, 7));
  const std::vector<BodyId> touching = world_.find_touching({asked.shape, asked.pose});
  EXPECT_FALSE(touching.empty());
  for (const BodyId id : bodies_) {
    const bool touches = std::find(touching.begin(), touching.end(), id) != touching.end();
    expect_replay(to_case(world_, asked, id, touches));
  }
  const std::optional<BodyDistance> closest = world_.find_closest({asked.shape, asked.pose});
  ASSERT_TRUE(closest);
  expect_replay(to_case(world_, asked, *closest));
  for (const BodyDistance& found : world_.find_within({asked.shape, asked.pose}, 2))
    expect_replay(to_case(world_, asked, found));
  const Ray ray{{-3, 0.2, 0.1}, {2, 0.1, 0}};
  const std::vector<BodyRayHit> hits = world_.cast_ray_all(ray);
  EXPECT_GT(hits.size(), 1u);
  for (const BodyRayHit& hit : hits)
    expect_replay(to_case(world_, ray, hit));
  const std::optional<BodyRayHit> first = world_.cast_ray(ray);
  ASSERT_TRUE(first);
  expect_replay(to_case(world_, ray, *first));
  EXPECT_EQ(asked_, (std::set<Ask>{Ask::Any, Ask::Distance, Ask::Ray}));
}

/// A shape of a user's own: nothing that a file could hold.
class Nowhere : public BodyShape {
 public:
  Aabb bounds(const Pose&) const override { return {{0, 0, 0}, {1, 1, 1}}; }
  bool touches(const Pose&, const BodyShape&, const Pose&) const override { return false; }
};

TEST_F(WorldCases, WhatIsInNoFileIsRefused) {
  const BodyId own = world_.add({std::make_shared<Nowhere>(), Pose::Identity()});
  EXPECT_THROW(to_case(world_, {bodies_[0], own}, false), UnsupportedPairError);
  world_.remove(bodies_[0]);
  EXPECT_THROW(to_case(world_, {bodies_[0], bodies_[1]}, false), StaleIdError);
}

}  // namespace
}  // namespace graze
