// What a mesh computes when first asked for it, asked for first by many threads at the same moment:
// all get, bit for bit, what one thread alone gets of meshes of its own.

#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <barrier>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/engine/first_touch/questions.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

constexpr std::size_t kThreads = 32;

/// Runs the task on all threads, which wait for each other before they begin.
void at_the_same_moment(const std::function<void(std::size_t thread)>& task) {
  std::barrier begin(static_cast<std::ptrdiff_t>(kThreads));
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < kThreads; ++i) {
    threads.emplace_back([&, i] {
      begin.arrive_and_wait();
      task(i);
    });
  }
  for (std::thread& thread : threads)
    thread.join();
}

struct Meshes {
  Mesh a, b;
};

/// Other data than any mesh before it.
Mesh anew(const Mesh& mesh) {
  return Mesh(mesh.vertices(), mesh.triangles());
}

std::vector<Eigen::Vector3d> bent(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& v : vertices)
    v += Eigen::Vector3d(0.05 * v.y() * v.y(), 0.03 * v.z(), 0.02 * v.x() * v.z());
  return vertices;
}

Mesh sphere() {
  return make_sphere(1, 10, 12);
}
Mesh torus() {
  return make_torus(1, 0.3, 14, 8);
}

Meshes fresh() {
  return {anew(sphere()), anew(torus())};
}

/// Refitted from meshes all of whose trees are built.
Meshes deformed() {
  const Meshes before = fresh();
  for (const Mesh& mesh : {before.a, before.b})
    prepare(mesh), tree_of(mesh);
  return {before.a.deformed(bent(before.a)), before.b.deformed(bent(before.b))};
}

/// Refitted from meshes of whose trees one query has built what it came by, twice over.
Meshes deformed_in_part() {
  const Meshes before = fresh();
  intersects({before.a}, {before.b, at(1.2, 0.1, 0.2)});
  const Mesh a = before.a.deformed(bent(before.a)), b = before.b.deformed(bent(before.b));
  return {a.deformed(bent(a)), b.deformed(bent(b))};
}

/// All that oneTBB has a hand in is built, and nothing else.
Meshes built() {
  const Meshes meshes = fresh();
  for (const Mesh& mesh : {meshes.a, meshes.b})
    prepare(mesh, {.queries = PreparedFor::All}), obb_skin_of(mesh);
  return meshes;
}

using Maker = Meshes (*)();
constexpr Maker kMakers[] = {fresh, deformed, deformed_in_part};

std::vector<FirstQuestion> questions_by(WorkedOutBy most) {
  std::vector<FirstQuestion> questions;
  for (const FirstQuestion& question : first_questions())
    if (question.by <= most) questions.push_back(question);
  return questions;
}

/// One question, put by all threads.
void all_ask_one_question(Maker make, WorkedOutBy most) {
  for (const FirstQuestion& question : questions_by(most)) {
    const Meshes alone = make(), shared = make();
    const Digest expected = question.ask(alone.a, alone.b);
    EXPECT_GT(expected.size(), 0u) << question.name;
    std::vector<Digest> answers(kThreads);
    at_the_same_moment([&](std::size_t i) { answers[i] = question.ask(shared.a, shared.b); });
    for (const Digest& answer : answers)
      EXPECT_TRUE(answer == expected) << question.name;
  }
}

/// Each thread asks something else, of the same meshes: each question meets each other one.
void all_ask_different_questions(std::span<const Maker> makers, std::size_t rounds,
                                 WorkedOutBy most) {
  const std::vector<FirstQuestion> questions = questions_by(most);
  for (const Maker make : makers) {
    std::vector<Digest> expected;
    for (const FirstQuestion& question : questions) {
      const Meshes alone = make();
      expected.push_back(question.ask(alone.a, alone.b));
    }
    for (std::size_t round = 0; round < rounds; ++round) {
      const Meshes shared = make();
      at_the_same_moment([&](std::size_t i) {
        const std::size_t n = (i * (2 * round + 1) + round) % questions.size();
        EXPECT_TRUE(questions[n].ask(shared.a, shared.b) == expected[n]) << questions[n].name;
      });
    }
  }
}

// Watched by ThreadSanitizer, which takes what oneTBB hands from one builder of trees to another
// for races: so the trees are there. That many threads may begin a tree is shown by what is not
// watched.
TEST(FirstTouchThreads, OfMeshesWhoseTreesAreThere) {
  all_ask_one_question(built, WorkedOutBy::Asker);
}

TEST(FirstTouchThreads, OfMeshesWhoseTreesAreThereByManyQuestions) {
  constexpr Maker kBuilt[] = {built};
  all_ask_different_questions(kBuilt, 6, WorkedOutBy::Asker);
}

TEST(FirstTouch, ByAnyQuestion) {
  for (const Maker make : kMakers)
    all_ask_one_question(make, WorkedOutBy::OneTbbToo);
}

TEST(FirstTouch, ByAllQuestionsAtOnce) {
  all_ask_different_questions(kMakers, 6, WorkedOutBy::OneTbbToo);
}

TEST(FirstTouchSlow, ByAllQuestionsAtOnce) {
  all_ask_different_questions(kMakers, 2000, WorkedOutBy::OneTbbToo);
}

/// Meshes are deformed while others are the first to walk the mesh before.
TEST(FirstTouch, WhileTheMeshIsDeformed) {
  const Meshes before_alone = fresh();
  const Meshes alone{before_alone.a.deformed(bent(before_alone.a)),
                     before_alone.b.deformed(bent(before_alone.b))};
  const Digest expected = first_questions()[5].ask(alone.a, alone.b);
  for (int round = 0; round < 10; ++round) {
    const Meshes shared = fresh();
    const std::vector<Eigen::Vector3d> elsewhere_a = bent(shared.a), elsewhere_b = bent(shared.b);
    const Meshes still = fresh();
    const Digest before = first_questions()[5].ask(still.a, still.b);
    at_the_same_moment([&](std::size_t i) {
      if (i % 2 == 0) {
        EXPECT_TRUE(first_questions()[5].ask(shared.a, shared.b) == before);
        return;
      }
      const Mesh a = shared.a.deformed(elsewhere_a), b = shared.b.deformed(elsewhere_b);
      EXPECT_TRUE(first_questions()[5].ask(a, b) == expected);
    });
  }
}

/// Some of what a world can be asked while it stays as it is.
Digest ask(const World& world, std::size_t kind) {
  Digest digest;
  if (kind == 0) {
    for (const BodyId id : world.find_in_box({{0, 0, -1}, {5, 5, 1}}))
      digest << id.index;
  } else if (kind == 1) {
    for (const BodyId id : world.find_touching({Sphere{{0, 0, 0}, 2}, at(3, 0.5)}))
      digest << id.index;
  } else if (kind == 2) {
    for (const BodyRayHit& hit : world.cast_ray_all(Ray{{-5, 0.1, 0.1}, {1, 0.01, 0}}))
      digest << hit.id.index << hit.hit.distance;
  } else {
    const auto closest = world.find_closest({Box{{0.1, 0.1, 0.1}}, at(4, 20)});
    digest << closest->id.index << closest->distance.distance;
  }
  return digest;
}

/// The first queries after changes bring boxes into order.
TEST(FirstTouchThreads, OfAWorldAfterItsBodiesMoved) {
  World shared, alone;
  std::vector<BodyId> ids;
  for (int i = 0; i < 200; ++i) {
    const Shape ball(Sphere{{0, 0, 0}, 0.5});
    const Pose pose = at(0.7 * (i % 20), 0.9 * (i / 20));
    ids.push_back(shared.add({i % 20 == 0 ? Shape(built().a) : ball, pose}));
    alone.add({i % 20 == 0 ? Shape(built().a) : ball, pose});
  }
  shared.update(), alone.update();
  for (int round = 0; round < 10; ++round) {
    std::vector<Pose> poses;
    for (int i = 0; i < 200; ++i)
      poses.push_back(at(0.7 * ((i + round) % 20), 0.9 * ((i * (round + 3)) % 10)));
    shared.move(ids, poses), alone.move(ids, poses);
    std::vector<Digest> answers(kThreads);
    at_the_same_moment([&](std::size_t i) { answers[i] = ask(shared, i % 4); });
    for (std::size_t i = 0; i < kThreads; ++i) {
      EXPECT_GT(answers[i].size(), 0u) << i % 4;
      EXPECT_TRUE(answers[i] == ask(alone, i % 4)) << i % 4;
    }
  }
}

}  // namespace
}  // namespace graze::tests
