// Every kind of question, asked while its n-th allocation fails: std::bad_alloc comes out, nothing
// is leaked, and the same question, asked again of the same meshes, has the answer of new ones.

#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/world/convex_hull.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_pairs.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "tests/engine/allocations/failing_new.h"
#include "tests/engine/first_touch/questions.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

struct Meshes {
  Mesh a, b;
};

Mesh anew(const Mesh& mesh) {
  return Mesh(mesh.vertices(), mesh.triangles());
}

std::vector<Eigen::Vector3d> bent(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& v : vertices)
    v += Eigen::Vector3d(0.05 * v.y() * v.y(), 0.03 * v.z(), 0.02 * v.x() * v.z());
  return vertices;
}

Meshes fresh() {
  static const Mesh sphere = make_sphere(1, 6, 8), torus = make_torus(1, 0.3, 9, 6);
  return {anew(sphere), anew(torus)};
}

/// Trees of several treelets.
Meshes fine() {
  static const Mesh sphere = make_sphere(1, 40, 60), torus = make_torus(1, 0.3, 60, 40);
  return {anew(sphere), anew(torus)};
}

/// Refitted from meshes all of whose trees are built.
Meshes deformed() {
  const Meshes before = fresh();
  for (const Mesh& mesh : {before.a, before.b})
    prepare(mesh), tree_of(mesh);
  return {before.a.deformed(bent(before.a)), before.b.deformed(bent(before.b))};
}

using Maker = Meshes (*)();

/// Returns how many attempts an allocation failed in.
long fail_each_allocation_of(const FirstQuestion& question, Maker make, long most) {
  Digest expected;
  long count = 0;
  {
    const Meshes meshes = make();  // also warms up what threads keep
    expected = question.ask(meshes.a, meshes.b);
    const Meshes others = make();
    count = allocations_of([&] { question.ask(others.a, others.b); });
  }
  long failed = 0;
  for (long n = 1; n <= count; n = next_failure(n, count, most)) {
    const long before = live_blocks();
    {
      const Meshes meshes = make();
      Digest answer;
      const Attempt made = attempt(n, [&] { answer = question.ask(meshes.a, meshes.b); });
      failed += made.has_failed;
      if (made.has_ended) {
        EXPECT_TRUE(answer == expected) << question.name << ", allocation " << n;
      }
      EXPECT_TRUE(question.ask(meshes.a, meshes.b) == expected)
          << question.name << ", asked again after allocation " << n;
    }
    EXPECT_EQ(live_blocks(), before) << question.name << ", allocation " << n;
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GT(failed, count == 0 ? -1 : 0) << question.name;
  return failed;
}

/// Threads that build trees keep memory of their own: which of many come to have some is chance.
void fail_each_allocation(std::span<const Maker> makers, long most) {
  const tbb::global_control few(tbb::global_control::max_allowed_parallelism, 2);
  long failed = 0;
  for (const Maker make : makers) {
    for (const FirstQuestion& question : first_questions()) {
      failed += fail_each_allocation_of(question, make, most);
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(failed, 100);
}

constexpr Maker kSmall[] = {fresh, deformed};
constexpr Maker kAll[] = {fresh, deformed, fine};
constexpr long kEach = std::numeric_limits<long>::max() / 4;

TEST(Allocations, OfQuestionsMayFail) {
  fail_each_allocation(kSmall, 16);
}

TEST(AllocationsSlow, OfQuestionsMayFail) {
  fail_each_allocation(kSmall, kEach);
  fail_each_allocation(kAll, 200);
}

/// What is made, and not asked.
template <typename Make>
void fail_making(const char* name, long most, const Make& make) {
  const auto expected = make();
  const long count = allocations_of([&] { make(); });
  EXPECT_GT(count, 0) << name;
  for (long n = 1; n <= count; n = next_failure(n, count, most)) {
    const long before = live_blocks();
    bool is_as_expected = true;  // where an algorithm does without the memory that it asked for
    const Attempt made = attempt(n, [&] { is_as_expected = make() == expected; });
    ASSERT_EQ(live_blocks(), before) << name << ", allocation " << n;
    ASSERT_TRUE(made.has_failed) << name << ", allocation " << n;
    ASSERT_TRUE(is_as_expected) << name << ", allocation " << n;
    ASSERT_TRUE(make() == expected) << name << ", allocation " << n;
  }
}

Digest told_of(const Mesh& mesh) {
  Digest digest;
  for (const Eigen::Vector3d& vertex : mesh.vertices())
    digest << vertex;
  digest << mesh.triangles().size();
  return digest;
}

TEST(Allocations, OfMeshesMayFail) {
  const Meshes meshes = fresh();
  const std::vector<Eigen::Vector3d> elsewhere = bent(meshes.a);
  fail_making("a mesh", kEach, [&] { return told_of(anew(meshes.a)); });
  fail_making("a deformed mesh", kEach, [&] { return told_of(meshes.a.deformed(elsewhere)); });
  prepare(meshes.a), tree_of(meshes.a);
  fail_making("a deformed mesh with trees", kEach,
              [&] { return told_of(meshes.a.deformed(elsewhere)); });
}

TEST(Allocations, OfShapesMayFail) {
  const Mesh points = make_sphere(1, 6, 8);
  const auto hull = [&] { return ConvexHull(points.vertices()); };
  const Pose here = at(0), there = at(1.5, 0.1, 0.2), apart = at(2.5, 0.1, 0.2);
  fail_making("a hull and its answers", 150, [&] {
    const Shape a(hull()), b(Cone{0.6, 0.5});
    Digest digest;
    for (const ShapeContact& contact : find_contacts({a, here}, {b, there}))
      digest << contact.depth << contact.normal << contact.point;
    return digest << distance({a, here}, {b, apart}).distance << intersects({a, here}, {b, there});
  });
}

}  // namespace
}  // namespace graze::tests
