// Batches that are watched and stopped: there is a whole answer or none.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/mesh_ray.h>
#include <graze/engine/mesh/pose_batch.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <gtest/gtest.h>

#include <functional>
#include <stop_token>
#include <thread>
#include <vector>

#include "tests/engine/callbacks/fuse.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

/// A batch of each kind, of so many elements; says what it is wrong about.
struct Kind {
  const char* name;
  std::function<void(std::size_t count, const BatchSettings& batch)> ask;
};

std::vector<Pose> steps(std::size_t count) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < count; ++i)
    poses.push_back(at(0.01 * static_cast<double>(i), 0, 0));
  return poses;
}

std::vector<Kind> kinds() {
  const Mesh a = make_sphere(1, 12, 12);
  const Mesh b = make_box({0.5, 0.5, 0.5});
  const auto in_poses = [=](const auto& query, const auto& same) {
    return [=](std::size_t count, const BatchSettings& batch) {
      const std::vector<Pose> poses = steps(count);
      const auto all = query(MeshInPoses(b, poses), batch);
      ASSERT_EQ(all.size(), count);
      for (std::size_t i = 0; i < count; i += 7)
        EXPECT_TRUE(all[i] == same(PlacedMeshView(b, poses[i])));
    };
  };
  const auto points = [](std::size_t count) {
    std::vector<Eigen::Vector3d> all;
    for (const Pose& pose : steps(count))
      all.emplace_back(pose.translation());
    return all;
  };
  std::vector<Kind> all;
  all.push_back(
      {"intersects",
       in_poses([=](const MeshInPoses& many,
                    const BatchSettings& batch) { return intersects({a}, many, {}, batch); },
                [=](const PlacedMeshView& one) { return intersects({a}, one); })});
  all.push_back(
      {"interiors",
       in_poses([=](const MeshInPoses& many,
                    const BatchSettings& batch) { return interiors_intersect({a}, many, batch); },
                [=](const PlacedMeshView& one) { return interiors_intersect({a}, one); })});
  all.push_back({"within", in_poses(
                               [=](const MeshInPoses& many, const BatchSettings& batch) {
                                 return within({a}, many, 0.25, {}, batch);
                               },
                               [=](const PlacedMeshView& one) { return within({a}, one, 0.25); })});
  all.push_back({"distance", in_poses(
                                 [=](const MeshInPoses& many, const BatchSettings& batch) {
                                   return distance({a}, many, {}, batch);
                                 },
                                 [=](const PlacedMeshView& one) { return distance({a}, one); })});
  all.push_back({"points", [=](std::size_t count, const BatchSettings& batch) {
                   const auto where = points(count);
                   const std::vector<bool> inside = contains_points({a}, where, batch);
                   for (std::size_t i = 0; i < count; i += 7)
                     EXPECT_EQ(inside[i], contains({a}, where[i]));
                 }});
  all.push_back({"rays", [=](std::size_t count, const BatchSettings& batch) {
                   std::vector<Ray> rays;
                   for (const Eigen::Vector3d& origin : points(count))
                     rays.push_back({origin, {-1, 0.1, 0.2}});
                   const auto hits = cast_rays({a}, rays, batch);
                   ASSERT_EQ(hits.size(), count);
                   for (std::size_t i = 0; i < count; i += 7)
                     EXPECT_TRUE(hits[i] == cast_ray({a}, rays[i]));
                 }});
  all.push_back({"motions", [=](std::size_t count, const BatchSettings& batch) {
                   std::vector<RigidMotion> motions;
                   for (const Pose& pose : steps(count))
                     motions.push_back(RigidMotion::between(at(0, 0, 3), pose));
                   const RigidMotion rest{Pose::Identity()};
                   const std::vector<bool> free = is_free({a, rest}, {b, motions}, {}, batch);
                   for (std::size_t i = 0; i < count; i += 7)
                     EXPECT_EQ(free[i], is_free({a, rest}, {b, motions[i]}));
                 }});
  return all;
}

TEST(StoppedBatch, BeforeItBeginsHasNoAnswer) {
  std::stop_source source;
  source.request_stop();
  for (const Kind& kind : kinds()) {
    for (const int threads : {1, 3}) {
      SCOPED_TRACE(kind.name);
      bool is_told = false;
      const BatchSettings batch{.threads = threads,
                                .stop = source.get_token(),
                                .on_progress = [&](std::size_t, std::size_t) { is_told = true; }};
      try {
        kind.ask(50, batch);
        FAIL() << "an answer of a batch that was stopped";
      } catch (const StoppedError& error) {
        EXPECT_EQ(error.done(), 0u);
        EXPECT_EQ(error.total(), 50u);
        EXPECT_STREQ(error.what(), "stopped: 0 of 50 are done");
      }
      EXPECT_FALSE(is_told);
    }
  }
}

TEST(StoppedBatch, InTheMiddleHasNoAnswer) {
  for (const Kind& kind : kinds()) {
    for (const int threads : {1, 3}) {
      SCOPED_TRACE(kind.name);
      std::stop_source source;
      std::size_t told = 0;
      const BatchSettings batch{.threads = threads,
                                .stop = source.get_token(),
                                .on_progress = [&](std::size_t done, std::size_t) {
                                  told = done;
                                  source.request_stop();
                                }};
      try {
        kind.ask(300, batch);
        // Where other threads had done the rest, there is nothing left to stop.
        EXPECT_GT(threads, 1);
        EXPECT_EQ(told, 300u);
      } catch (const StoppedError& error) {
        EXPECT_GT(told, 0u);
        EXPECT_LT(told, 300u);
        EXPECT_GE(error.done(), told);
        EXPECT_LT(error.done(), 300u);
        if (threads == 1) {
          EXPECT_EQ(error.done(), told);
        }
      }
    }
  }
}

TEST(StoppedBatch, AfterItEndedOrWithoutElementsIsWhole) {
  std::stop_source source;
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    kind.ask(20,
             {.stop = source.get_token(), .on_progress = [&](std::size_t done, std::size_t total) {
                if (done == total) source.request_stop();
              }});
    EXPECT_TRUE(source.stop_requested());
    kind.ask(0, {.stop = source.get_token()});
    source = {};
  }
}

TEST(WatchedBatch, IsToldOnTheCallersThreadAndRises) {
  for (const Kind& kind : kinds()) {
    for (const int threads : {0, 1, 3}) {
      SCOPED_TRACE(kind.name);
      std::vector<std::size_t> told;
      const auto caller = std::this_thread::get_id();
      kind.ask(500, {.threads = threads, .on_progress = [&](std::size_t done, std::size_t total) {
                       EXPECT_EQ(std::this_thread::get_id(), caller);
                       EXPECT_EQ(total, 500u);
                       EXPECT_GT(done, told.empty() ? 0 : told.back());
                       told.push_back(done);
                     }});
      ASSERT_FALSE(told.empty());
      EXPECT_EQ(told.back(), 500u);
      EXPECT_GE(told.size(), threads == 1 ? 2u : 1u) << "not told after the first answer";
    }
    bool is_told = false;
    kind.ask(0, {.on_progress = [&](std::size_t, std::size_t) { is_told = true; }});
    EXPECT_FALSE(is_told);
  }
}

TEST(WatchedBatch, WhatTheCallbackThrowsComesOut) {
  for (const Kind& kind : kinds()) {
    for (const int threads : {1, 3}) {
      for (const long call : {1L, 2L}) {
        SCOPED_TRACE(kind.name);
        Fuse fuse;
        fuse.light(call);
        const auto burn = [&](std::size_t, std::size_t) { fuse.burn(); };
        try {
          kind.ask(300, {.threads = threads, .on_progress = burn});
          EXPECT_EQ(fuse.calls(), 1) << "it threw, and nothing came out";
          EXPECT_GT(threads, 1);
        } catch (const Burnt&) {
          EXPECT_EQ(fuse.calls(), call);
        }
        kind.ask(30, {.threads = threads});  // as if there had been none
      }
    }
  }
}

}  // namespace
}  // namespace graze::tests
