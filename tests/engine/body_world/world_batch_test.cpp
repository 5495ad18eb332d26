// Many rays, poses and motions in one call: the single questions bit for bit, whatever the threads.

#include <graze/bvh/error.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/world_batch.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <stop_token>
#include <thread>
#include <vector>

#include "tests/engine/body_world/users_ball.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using Eigen::Vector3d;
using tests::at;

constexpr int kSomeThreads[] = {0, 1, 2, 5};

class WorldBatch : public testing::Test {
 protected:
  WorldBatch() {
    const Shape torus(tests::make_torus(1, 0.25, 24, 12));
    for (int i = 0; i < 60; ++i) {
      const double x = 2.25 * (i % 10), y = 2.25 * (i / 10);
      const Shape shape = i % 3 == 0   ? torus
                          : i % 3 == 1 ? Shape(Box{{0.5, 0.75, 1}})
                                       : Shape(Sphere{{0, 0, 0}, 1});
      const BodySettings settings{.role = i % 5 == 0 ? Role::Sensor : Role::Solid};
      ids_.push_back(world_.add({shape, at(x, y, 0.125 * i)}, settings));
    }
    world_.update();
    world_.move(ids_[7], at(3, 3, 0.5));  // which no update knows of
    RandomSource source(11);
    for (int i = 0; i < 3000; ++i) {
      const Vector3d origin{source.uniform(-3, 25), source.uniform(-3, 15), source.uniform(8, 12)};
      rays_.push_back({origin, {source.uniform(-1, 1), source.uniform(-1, 1), -1}});
    }
    for (int i = 0; i < 500; ++i)
      poses_.push_back(
          at({source.uniform(-3, 25), source.uniform(-3, 15), source.uniform(-3, 12)}));
    for (int i = 0; i < 300; ++i) {  // across or above the bodies, every third turning
      const Vector3d way{source.uniform(-4, 4), source.uniform(-4, 4), source.uniform(-20, 4)};
      motions_.emplace_back(poses_[i], RigidCourse{.centre = poses_[i].translation(),
                                                   .shift = way,
                                                   .axis = {1, 2, 3},
                                                   .angle = i % 3 == 0 ? 1.5 : 0.0});
    }
  }

  World world_{{.threads = 1}};
  std::vector<BodyId> ids_;
  std::vector<Ray> rays_;
  std::vector<Pose> poses_;
  std::vector<RigidMotion> motions_;
};

TEST_F(WorldBatch, RaysAreTheSingleOnes) {
  const BodyQuerySettings solid{.role = Role::Solid};
  std::size_t hits = 0;
  std::vector<std::optional<BodyRayHit>> expected;
  for (const Ray& ray : rays_) {
    expected.push_back(world_.cast_ray(ray, solid));
    hits += expected.back().has_value();
  }
  EXPECT_TRUE(hits > 300 && hits < 2900) << hits;
  for (const int threads : kSomeThreads)
    EXPECT_EQ(cast_rays(world_, rays_, solid, {.threads = threads}), expected) << threads;
  EXPECT_TRUE(cast_rays(world_, {}).empty());
}

TEST_F(WorldBatch, AllThatRaysMeetIsAsOfSingleOnes) {
  const BodyQuerySettings solid{.role = Role::Solid};
  std::vector<std::vector<BodyRayHit>> expected;
  std::size_t most = 0;
  for (const Ray& ray : rays_) {
    expected.push_back(world_.cast_ray_all(ray, solid));
    most = std::max(most, expected.back().size());
  }
  EXPECT_GT(most, 2u);
  for (const int threads : kSomeThreads)
    EXPECT_EQ(cast_ray_all(world_, rays_, solid, {.threads = threads}), expected) << threads;
  EXPECT_TRUE(cast_ray_all(world_, {}).empty());
}

TEST_F(WorldBatch, MotionsAreTheSingleOnes) {
  Compound parts;
  parts.add({Box{{1, 1, 0.25}}, at(0, 0, 2)});
  parts.add({Sphere{{0, 0, 0}, 1}, at(1, 1, -1)});
  world_.add({share(parts), at(12, 7, 1)});
  const RigidContactSettings contact{.clearance = 0.0625, .tolerance = 1e-4};
  const BodyQuerySettings solid{.role = Role::Solid};
  const Shape shapes[] = {Shape(Capsule{0.25, 0.5}), Shape(tests::make_torus(0.5, 0.125, 12, 8))};
  for (const Shape& shape : shapes) {
    std::vector<std::optional<BodyCast>> first;
    std::vector<std::vector<BodyCast>> all;
    std::size_t hits = 0, most = 0;
    for (const RigidMotion& motion : motions_) {
      first.push_back(world_.cast({shape, motion}, contact, solid));
      all.push_back(world_.cast_all({shape, motion}, contact, solid));
      hits += first.back().has_value();
      most = std::max(most, all.back().size());
    }
    EXPECT_TRUE(hits > 50 && hits < 290) << hits;
    EXPECT_GT(most, 2u);
    for (const int threads : kSomeThreads) {
      const BatchSettings batch{.threads = threads};
      EXPECT_EQ(cast(world_, {shape, motions_}, contact, solid, batch), first) << threads;
      EXPECT_EQ(cast_all(world_, {shape, motions_}, contact, solid, batch), all) << threads;
    }
    EXPECT_TRUE(cast(world_, {shape, {}}).empty());
  }
}

TEST_F(WorldBatch, TheFirstBadMotionIsNamed) {
  const Shape probe(Sphere{{0, 0, 0}, 1});
  motions_[211] = RigidMotion(at(0), {.shift = {0x1p700, 0, 0}});
  motions_[250] = motions_[211];
  for (const int threads : kSomeThreads) {
    const BatchSettings batch{.threads = threads};
    try {
      cast(world_, {probe, motions_}, {}, {}, batch);
      ADD_FAILURE() << "a motion that goes too far";
    } catch (const PoseError& error) {
      EXPECT_EQ(error.place().element, "motion");
      EXPECT_EQ(error.place().index, 211u);
      EXPECT_TRUE(std::string(error.what()).starts_with("motion 211")) << error.what();
    }
    EXPECT_THROW(cast_all(world_, {probe, motions_}, {}, {}, batch), PoseError);
  }
  EXPECT_THROW(cast(world_, {probe, {}}, {.clearance = -1}), InputError);
  EXPECT_THROW(cast_all(world_, {probe, {}}, {}, {}, {.threads = -1}), InputError);
}

TEST_F(WorldBatch, PosesAreTheSingleOnes) {
  const Shape probe(Capsule{0.5, 1});
  std::vector<std::vector<BodyId>> touching;
  std::vector<std::vector<BodyDistance>> near;
  std::vector<std::optional<BodyDistance>> closest;
  std::size_t touches = 0;
  for (const Pose& pose : poses_) {
    touching.push_back(world_.find_touching({probe, pose}));
    near.push_back(world_.find_within({probe, pose}, 0.75));
    closest.push_back(world_.find_closest({probe, pose}));
    touches += touching.back().size();
    EXPECT_GE(near.back().size(), touching.back().size());
  }
  EXPECT_GT(touches, 50u);
  for (const int threads : kSomeThreads) {
    const BatchSettings batch{.threads = threads};
    EXPECT_EQ(find_touching(world_, {probe, poses_}, {}, batch), touching) << threads;
    EXPECT_EQ(find_within(world_, {probe, poses_}, 0.75, {}, batch), near) << threads;
    EXPECT_EQ(find_closest(world_, {probe, poses_}, {}, batch), closest) << threads;
  }
  const BodyQuerySettings nobody{.filter = Filter{.category = 2, .mask = 0}};
  EXPECT_FALSE(find_closest(world_, {probe, poses_}, nobody)[0]);
  EXPECT_TRUE(find_touching(world_, {probe, poses_}, nobody)[0].empty());
}

TEST_F(WorldBatch, BadElementsAreNamed) {
  rays_[1234].direction.setZero();
  rays_[2000].origin.x() = std::numeric_limits<double>::quiet_NaN();
  try {
    cast_rays(world_, rays_);
    ADD_FAILURE() << "a ray without a direction";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().index, 1234u);
    EXPECT_TRUE(std::string(error.what()).starts_with("ray 1234")) << error.what();
  }
  poses_[321].linear() *= 2;
  const Shape probe(Sphere{{0, 0, 0}, 1});
  for (const int threads : kSomeThreads) {
    try {
      find_closest(world_, {probe, poses_}, {}, {.threads = threads});
      ADD_FAILURE() << "a pose that is not rigid";
    } catch (const PoseError& error) {
      EXPECT_EQ(error.place().index, 321u);
      EXPECT_TRUE(std::string(error.what()).starts_with("pose 321")) << error.what();
    }
  }
  EXPECT_THROW(cast_rays(world_, {}, {}, {.threads = -1}), InputError);
  const std::vector<Pose> one = {at(0)};
  EXPECT_THROW(find_within(world_, {probe, one}, -1), InputError);
}

TEST_F(WorldBatch, ItStopsAndTellsOfProgress) {
  std::stop_source stop;
  stop.request_stop();
  const Shape probe(Sphere{{0, 0, 0}, 1});
  EXPECT_THROW(cast_rays(world_, rays_, {}, {.stop = stop.get_token()}), StoppedError);
  EXPECT_THROW(cast_ray_all(world_, rays_, {}, {.stop = stop.get_token()}), StoppedError);
  EXPECT_THROW(cast(world_, {probe, motions_}, {}, {}, {.stop = stop.get_token()}), StoppedError);
  EXPECT_THROW(cast_all(world_, {probe, motions_}, {}, {}, {.stop = stop.get_token()}),
               StoppedError);
  std::size_t last = 0;
  cast_rays(world_, rays_, {}, {.on_progress = [&](std::size_t done, std::size_t total) {
              EXPECT_GE(done, last);
              EXPECT_EQ(total, rays_.size());
              last = done;
            }});
  EXPECT_EQ(last, rays_.size());
}

TEST_F(WorldBatch, MotionsAreStoppedInTheMidst) {
  const Shape probe(tests::make_torus(0.5, 0.125, 24, 12));
  std::vector<RigidMotion> many;
  for (int i = 0; i < 100; ++i)
    many.insert(many.end(), motions_.begin(), motions_.end());
  for (const int threads : {1, 2}) {
    std::stop_source stop;
    std::size_t last = 0;
    const BatchSettings batch{.threads = threads,
                              .stop = stop.get_token(),
                              .on_progress = [&](std::size_t done, std::size_t total) {
                                EXPECT_EQ(total, many.size());
                                EXPECT_GE(done, last);
                                last = done;
                                stop.request_stop();
                              }};
    EXPECT_THROW(cast(world_, {probe, many}, {}, {}, batch), StoppedError);
    EXPECT_TRUE(last > 0 && last < many.size()) << last;
  }
}

/// Notes whether it was asked by two threads at once, or by another than the caller.
class OneAtATime : public tests::UsersBall {
 public:
  OneAtATime() : UsersBall(1) {}
  std::optional<RayHit> cast_ray(const Pose&, const Ray&) const override {
    note();
    return std::nullopt;
  }
  bool is_asked_elsewhere() const { return is_asked_elsewhere_; }
  int questions() const { return questions_; }

 private:
  void note() const override {
    ++questions_;
    if (std::this_thread::get_id() != mine_) is_asked_elsewhere_ = true;
  }

  std::thread::id mine_ = std::this_thread::get_id();
  mutable std::atomic<bool> is_asked_elsewhere_ = false;
  mutable std::atomic<int> questions_ = 0;
};

TEST_F(WorldBatch, AUsersShapeIsAskedByTheCallerAlone) {
  const tbb::global_control enough(tbb::global_control::max_allowed_parallelism, 4);
  const auto ball = std::make_shared<OneAtATime>();
  world_.add({ball, at(11, 6, 2)});
  cast_rays(world_, rays_, {}, {.threads = 4});
  const Shape probe(Sphere{{0, 0, 0}, 3});
  find_touching(world_, {probe, poses_}, {}, {.threads = 4});
  cast_ray_all(world_, rays_, {}, {.threads = 4});
  EXPECT_GT(ball->questions(), 10);
  EXPECT_FALSE(ball->is_asked_elsewhere());
}

}  // namespace
}  // namespace graze
