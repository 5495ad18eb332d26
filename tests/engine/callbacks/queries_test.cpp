// What queries call back may throw at any call, on one thread and on many: what it threw comes out,
// and the next query is as if there had been none.

#include <graze/engine/mesh/mesh_health.h>
#include <graze/engine/mesh/voxels.h>
#include <graze/engine/mesh/write_voxels.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/engine/callbacks/fuse.h"
#include "tests/files/temporary_directory.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

/// Asks with the fuse lit for each call in turn, until the query ends before its turn comes.
/// Returns how often it threw.
long throw_at_every_call(Fuse& fuse, const std::function<void()>& ask) {
  long thrown = 0;
  for (;; ++thrown) {
    fuse.light(thrown + 1);
    try {
      ask();
    } catch (const Burnt&) {
      continue;
    }
    fuse.douse();
    return thrown;
  }
}

TEST(QueryCallbacks, ProgressOfVoxelsMayThrowAtEveryCall) {
  const Mesh mesh = make_sphere(1, 20, 20);
  const auto count = [&](int threads, VoxelFill fill, const auto& on_progress) {
    return find_voxels(
               mesh,
               {.resolution = 24, .fill = fill, .threads = threads, .on_progress = on_progress})
        .size();
  };
  for (const VoxelFill fill : {VoxelFill::Surface, VoxelFill::Solid}) {
    const std::size_t expected = count(1, fill, std::function<void(std::size_t, std::size_t)>());
    for (const int threads : {1, 4}) {
      Fuse fuse;
      bool has_thrown = false;
      const long thrown = throw_at_every_call(fuse, [&] {
        has_thrown = false;
        const auto on_progress = [&](std::size_t done, std::size_t total) {
          EXPECT_FALSE(has_thrown) << "called again after it threw";
          EXPECT_LE(done, total);
          has_thrown = true;
          fuse.burn();
          has_thrown = false;
        };
        EXPECT_EQ(count(threads, fill, on_progress), expected);
      });
      EXPECT_GT(thrown, 5);
    }
  }
}

TEST(QueryCallbacks, ProgressOfACheckMayThrowAtEveryCall) {
  const Mesh mesh = make_sphere(1, 20, 20);
  Fuse fuse;
  const long thrown = throw_at_every_call(fuse, [&] {
    const MeshHealth health =
        check(mesh, {.on_progress = [&](std::size_t, std::size_t) { fuse.burn(); }});
    EXPECT_TRUE(health.is_healthy());
  });
  EXPECT_GT(thrown, 100);
}

TEST(QueryCallbacks, AFileIsRemovedWhereverItsProgressThrows) {
  const TemporaryDirectory folder;
  const Voxels voxels = find_voxels(make_sphere(1, 20, 20), {.resolution = 90});
  for (const char* name : {"voxels.ply", "voxels.obj"}) {
    const std::string path = folder.path(name);
    Fuse fuse;
    const long thrown = throw_at_every_call(fuse, [&] {
      EXPECT_FALSE(std::filesystem::exists(path));
      write_voxels(path, voxels,
                   {.on_progress = [&](std::uint64_t, std::uint64_t) { fuse.burn(); }});
    });
    EXPECT_GE(thrown, 2);
    EXPECT_GT(std::filesystem::file_size(path), 1000u);
  }
}

TEST(QueryCallbacks, AVisitorOfBoxesMayThrowAtEveryCall) {
  BroadPhase boxes;
  for (int i = 0; i < 100; ++i)
    boxes.add({{1.0 * i, 0, 0}, {1.0 * i + 0.5, 1, 1}});
  const Ray ray{{-1, 0.5, 0.5}, {1, 0, 0}, 1000};
  Fuse fuse;
  const long thrown = throw_at_every_call(fuse, [&] {
    boxes.visit_along(ray, [&](std::uint32_t) {
      fuse.burn();
      return 1000.0;
    });
  });
  EXPECT_EQ(thrown, 100);
  boxes.add({{-0.5, 0, 0}, {0, 1, 1}});
  boxes.update();
  std::size_t seen = 0;
  boxes.visit_along(ray, [&](std::uint32_t) { return ++seen, 1000.0; });
  EXPECT_EQ(seen, 101u);
}

/// A world of bodies that throw, and all that can be asked of it while it stays as it is.
struct Questions {
  std::shared_ptr<Fuse> fuse = std::make_shared<Fuse>();
  World world;

  Questions() {
    for (int i = 0; i < 12; ++i) {
      const Shape shape = i % 2 == 0 ? Shape(Sphere{{0, 0, 0}, 1}) : Shape(Box{{1, 1, 1}});
      const auto look = i % 3 == 0 ? FusedShape::Look::Transparent : FusedShape::Look::Opaque;
      world.add({std::make_shared<FusedShape>(shape, fuse, look), at(1.5 * i)});
    }
    world.update();
  }

  std::string ask(int question) const {
    std::string said;
    const auto say = [&](double x) { said += std::to_string(x) + " "; };
    const Ray ray{{-5, 0.2, 0.3}, {1, 0, 0}, 100};
    if (question == 0) {
      for (const BodyContact& c : world.contacts())
        say(c.pair.a.index), say(c.manifold.size());
    } else if (question == 1) {
      for (const BodyId id : world.find_touching({Sphere{{0, 0, 0}, 3}, at(6)}))
        say(id.index);
    } else if (question == 2) {
      const auto hit = world.cast_ray(ray);
      if (hit) say(hit->id.index), say(hit->hit.distance);
    } else {
      for (const BodyRayHit& hit : world.cast_ray_all(ray))
        say(hit.id.index), say(hit.hit.distance);
    }
    return said;
  }
};

constexpr int kQuestions = 4;

TEST(QueryCallbacks, QueriesOfAWorldMayBeThrownOutOfAtEveryCall) {
  Questions questions;
  for (int question = 0; question < kQuestions; ++question) {
    const std::string expected = questions.ask(question);
    EXPECT_FALSE(expected.empty()) << question;
    const long thrown =
        throw_at_every_call(*questions.fuse, [&] { EXPECT_EQ(questions.ask(question), expected); });
    EXPECT_GT(thrown, 0) << question;
  }
}

/// Each exception comes out of exactly one of the queries that run at the same time.
TEST(QueryCallbacksThreads, WhatIsThrownComesOutOfOneOfManyThreads) {
  const Questions questions;
  std::vector<std::string> expected;
  for (int question = 0; question < kQuestions; ++question)
    expected.push_back(questions.ask(question));
  for (long n = 1; n <= 40; ++n) {
    questions.fuse->light(n);
    std::atomic<int> thrown = 0, answered = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) {
      threads.emplace_back([&, question = i % kQuestions] {
        try {
          answered += questions.ask(question) == expected[static_cast<std::size_t>(question)];
        } catch (const Burnt&) {
          ++thrown;
        }
      });
    }
    for (std::thread& thread : threads)
      thread.join();
    EXPECT_EQ(thrown, 1) << n;
    EXPECT_EQ(answered, 7) << n;
  }
}

}  // namespace
}  // namespace graze::tests
