// Bodies that a world sweeps, beside every pair asked alone, and beside finer steps (law 14).

#include <graze/engine/world/shape_motion.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "tests/engine/motion/moving_bodies.h"
#include "tests/shapes/pose_at.h"

namespace graze {
namespace {

using tests::KnownBody;

/// Of forty bodies some are swept, some move far, some rest.
class SweptWorld {
 public:
  SweptWorld(RandomSource& source, const WorldSettings& settings)
      : source_(source), world_(settings) {
    for (int i = 0; i < 40; ++i) {
      const Shape shape = tests::random_small_shape(source, i);
      const Pose pose = tests::random_pose(source, 2);
      const auto detection = i % 3 == 0 ? Detection::Continuous : Detection::Discrete;
      const BodyId id = world_.add({shape, pose}, {.detection = detection});
      bodies_.push_back({id, shape, pose, pose, detection});
    }
    world_.update();
  }

  WorldUpdate step() {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      KnownBody& body = bodies_[i];
      body.before = body.now;
      body.has_moved = i % 4 != 3;
      if (!body.has_moved) continue;
      const bool is_far = body.detection == Detection::Continuous || i % 7 == 0;
      body.now = tests::moved(source_, body.now, is_far ? 1.5 : 0.1, i % 2 == 0 ? 2 : 0);
      body.now.translation() *= 0.9;
      world_.move(body.id, body.now);
    }
    return world_.update();
  }

  const std::vector<KnownBody>& bodies() const { return bodies_; }

 private:
  RandomSource& source_;
  World world_;
  std::vector<KnownBody> bodies_;
};

TEST(Law14SweptWorld, SaysWhatEveryPairSays) {
  RandomSource source(901);
  std::size_t listed = 0;
  for (int n = 0; n < 20; ++n) {
    const RigidContactSettings sweeps{.clearance = n % 3 == 0 ? 0.02 : 0, .tolerance = 1e-5};
    SweptWorld world(source, {.sweeps = sweeps});
    for (int step = 0; step < 4; ++step) {
      const WorldUpdate update = world.step();
      const std::vector<BodyFirstContact> truth = tests::ask_every_pair(world.bodies(), sweeps);
      // What a shape comes to that slides along a mesh stands behind what it touches at 0.
      std::vector<BodyFirstContact> listed_now;
      for (const BodyFirstContact& each : update.first_contacts) {
        if (listed_now.empty() || listed_now.back().pair != each.pair) listed_now.push_back(each);
      }
      ASSERT_EQ(listed_now.size(), truth.size());
      for (std::size_t i = 0; i < truth.size(); ++i) {
        const BodyFirstContact& found = listed_now[i];
        EXPECT_EQ(found.pair, truth[i].pair);
        EXPECT_EQ(found.contact, truth[i].contact);
        EXPECT_EQ(found.is_at_start, truth[i].is_at_start);
        EXPECT_NEAR(found.normal.norm(), 1, 1e-9);
      }
      EXPECT_GE(update.work.pairs_swept, truth.size());
      EXPECT_LT(update.work.pairs_swept, std::size_t{40 * 39 / 2});
      listed += truth.size();
    }
  }
  EXPECT_GT(listed, 300u);
}

/// The same ways in a thousand steps: what touches in one of them was listed, and not later.
TEST(Law14SweptWorld, FinerStepsFindNothingMore) {
  constexpr int kSteps = 1000;
  RandomSource source(902);
  int touching = 0;
  for (int n = 0; n < 6; ++n) {
    SweptWorld world(source, {});
    const WorldUpdate update = world.step();
    std::map<BodyPair, RigidContact> listed;
    for (const BodyFirstContact& each : update.first_contacts)
      listed.emplace(each.pair, each.contact);
    World fine(WorldSettings{.contacts = false});
    std::vector<RigidMotion> motions;
    for (const KnownBody& body : world.bodies()) {
      ASSERT_EQ(fine.add({body.shape, body.before}), body.id);
      motions.push_back(body.motion());
    }
    for (int k = 0; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      for (std::size_t i = 0; i < motions.size(); ++i)
        fine.move(world.bodies()[i].id, motions[i].at(t));
      for (const BodyPair& pair : fine.update().begun) {
        const auto of = [&](BodyId id) { return world.bodies()[id.index]; };
        const auto is_swept = [](const KnownBody& body) {
          return body.has_moved && body.detection == Detection::Continuous;
        };
        if (!is_swept(of(pair.a)) && !is_swept(of(pair.b))) continue;
        ASSERT_TRUE(listed.contains(pair));
        EXPECT_LE(listed.at(pair).low, t);
        ++touching;
      }
    }
  }
  EXPECT_GT(touching, 50);
}

TEST(Law14SweptWorldThreads, ChangeNothing) {
  RandomSource one(903), more(903);
  SweptWorld world(one, {}), shared(more, {.threads = 4});
  std::size_t listed = 0;
  for (int step = 0; step < 6; ++step) {
    const WorldUpdate of_one = world.step(), of_more = shared.step();
    EXPECT_TRUE(std::equal(of_one.first_contacts.begin(), of_one.first_contacts.end(),
                           of_more.first_contacts.begin(), of_more.first_contacts.end()));
    EXPECT_EQ(of_one.work, of_more.work);
    listed += of_one.first_contacts.size();
  }
  EXPECT_GT(listed, 20u);
}

}  // namespace
}  // namespace graze
