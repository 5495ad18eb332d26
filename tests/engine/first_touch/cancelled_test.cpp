// A user may ask from within a group of oneTBB's tasks that is cancelled, or of which another has
// thrown. What a mesh computes then, for all who ask it later, is whole.

#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/world/broad_phase.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <functional>

#include "tests/engine/first_touch/questions.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

/// Runs the task where nothing that belongs to its group of tasks is run any more.
void within_cancelled_group(const std::function<void()>& task) {
  tbb::task_group_context context;
  bool has_run = false;
  tbb::parallel_for(
      0, 1,
      [&](int) {
        context.cancel_group_execution();
        task();
        has_run = true;
      },
      context);
  EXPECT_TRUE(has_run);
}

TEST(FirstTouch, WithinACancelledGroupOfTasks) {
  for (const FirstQuestion& question : first_questions()) {
    const auto ask = [&](const auto& within) {
      // Of several treelets, so that there is something to share.
      const Mesh a = make_sphere(1, 36, 40), b = make_torus(1, 0.3, 60, 40);
      Digest first;
      within([&] { first = question.ask(a, b); });
      EXPECT_TRUE(first == question.ask(a, b)) << question.name;
      return first;
    };
    const Digest expected = ask([](const auto& task) { task(); });
    EXPECT_TRUE(ask(within_cancelled_group) == expected) << question.name;
  }
}

TEST(FirstTouch, OfDeformedMeshesWithinACancelledGroupOfTasks) {
  const Mesh a = make_sphere(1, 36, 40), b = make_torus(1, 0.3, 60, 40);
  for (const Mesh& mesh : {a, b})
    prepare(mesh), tree_of(mesh);
  for (const FirstQuestion& question : first_questions()) {
    const auto bent = [](const Mesh& mesh) {
      std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
      for (Eigen::Vector3d& v : vertices)
        v += Eigen::Vector3d(0.05 * v.y() * v.y(), 0.03 * v.z(), 0.02 * v.x() * v.z());
      return mesh.deformed(vertices);
    };
    const Digest expected = question.ask(bent(a), bent(b));
    Digest answer;
    within_cancelled_group([&] { answer = question.ask(bent(a), bent(b)); });
    EXPECT_TRUE(answer == expected) << question.name;
  }
}

TEST(FirstTouch, OfBoxesWithinACancelledGroupOfTasks) {
  constexpr int kBoxes = 20000;  // that threads share
  const auto pairs = [](const auto& within) {
    BroadPhase boxes({.threads = 2});
    std::vector<BoxPair> found;
    within([&] {
      for (int i = 0; i < kBoxes; ++i) {
        const Eigen::Vector3d low(i % 100, i / 100 % 100, i / 10000);
        boxes.add({low, low + Eigen::Vector3d::Constant(1.0 - 0.25 * (i % 2))});
      }
      boxes.update();
      found.assign(boxes.sorted_pairs().begin(), boxes.sorted_pairs().end());
    });
    return found;
  };
  const std::vector<BoxPair> expected = pairs([](const auto& task) { task(); });
  EXPECT_GT(expected.size(), 10000u);
  EXPECT_TRUE(pairs(within_cancelled_group) == expected);
}

TEST(FirstTouch, OfAWorldWithinACancelledGroupOfTasks) {
  const auto pairs = [](const auto& within) {
    World world({.threads = 2});
    std::vector<BodyPair> found;
    std::size_t contacts = 0;
    within([&] {
      const Mesh ball = make_sphere(0.6, 6, 8);
      for (int i = 0; i < 4000; ++i) {
        const Shape shape = i % 9 == 0 ? Shape(ball) : Shape(Box{{0.5, 0.5, 0.5}});
        world.add({shape, at(0.9 * (i % 20), 0.9 * (i / 20 % 20), 1.1 * (i / 400))});
      }
      const WorldUpdate update = world.update();
      found.assign(update.moved.begin(), update.moved.end());
      contacts = update.contacts.size();
    });
    EXPECT_EQ(contacts, found.size());
    return found;
  };
  const std::vector<BodyPair> expected = pairs([](const auto& task) { task(); });
  EXPECT_GT(expected.size(), 8000u);
  EXPECT_TRUE(pairs(within_cancelled_group) == expected);
}

}  // namespace
}  // namespace graze::tests
