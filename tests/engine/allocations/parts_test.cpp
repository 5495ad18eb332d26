// Compounds, maps of voxels and height fields while their n-th allocation fails: what is changed is
// then as it was, and can be changed after all.

#include <graze/engine/world/compound.h>
#include <graze/engine/world/height_field.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/engine/allocations/failing_new.h"
#include "tests/engine/first_touch/digest.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/pose_at.h"

namespace graze::tests {
namespace {

Digest told_of(const Compound& compound) {
  Digest digest;
  for (const std::uint32_t part : compound.parts()) {
    digest << part << compound.settings(part).material << compound.settings(part).user_data;
    digest << Eigen::Vector3d(compound.part(part).pose.translation());
  }
  World world;
  world.add({share(compound), at(0)});
  for (const BodyRayHit& hit : world.cast_ray_all(Ray{{-5, 0.1, 0.05}, {1, 0.01, 0}}))
    digest << hit.hit.distance << hit.part;
  return digest << compound.size();
}

Digest told_of(const VoxelMap& map) {
  Digest digest;
  for (const Voxel& voxel : map.voxels())
    digest << voxel.i << voxel.j << voxel.k;
  return digest << map.size();
}

Digest told_of(const HeightField& field) {
  Digest digest;
  for (std::uint32_t row = 0; row < field.rows(); ++row) {
    for (std::uint32_t column = 0; column < field.columns(); ++column)
      digest << field.vertex(column, row);
  }
  const Shape ball = Sphere{{0, 0, 0}, 0.75};
  for (const ShapeContact& contact : find_contacts({field, at(0)}, {ball, at(2, 2, 0.5)}))
    digest << contact.depth << contact.point;
  digest << distance({field, at(0)}, {ball, at(1, 2, 9)}).distance;
  if (const auto hit = cast_ray({field, at(0)}, {{1.1, 1.2, 9}, {0, 0, -1}}))
    digest << hit->distance << hit->triangle;
  return digest;
}

/// What is left of a change that could not be made.
enum class Left : std::uint8_t {
  Nothing,  ///< all is as it was
  Part      ///< the change can be made once more, and is then whole
};

/// Lets each allocation of one change fail.
template <typename Object>
void fail_each_allocation_of_change(const char* name, const Object& before, Left left,
                                    const std::function<void(Object&)>& change) {
  const auto changed = [&] {
    Object copy = before;
    change(copy);
    return copy;
  };
  Object counted = before;
  const long count = allocations_of([&] { change(counted); });
  EXPECT_GT(count, 0) << name;
  const Digest was = told_of(before), is = told_of(changed());
  EXPECT_FALSE(was == is) << name;
  for (long n = 1; n <= count && !testing::Test::HasFailure(); ++n) {
    SCOPED_TRACE(std::string(name) + ", allocation " + std::to_string(n));
    const long blocks = live_blocks();
    {
      Object lost = before;
      EXPECT_TRUE(attempt(n, [&] { change(lost); }).has_failed);
    }
    EXPECT_EQ(live_blocks(), blocks);
    Object other = before;
    const Attempt made = attempt(n, [&] { change(other); });
    if (made.has_ended || left == Left::Nothing) {
      EXPECT_TRUE(told_of(other) == (made.has_ended ? is : was));
    }
    if (!made.has_ended) change(other);
    EXPECT_TRUE(told_of(other) == is);
  }
}

TEST(Allocations, OfCompoundsMayFail) {
  const Mesh box = make_box({0.5, 0.5, 0.5});
  Compound compound;
  for (int i = 0; i < 20; ++i)
    compound.add({Sphere{{0, 0, 0}, 0.25}, at(0.5 * i)}, {.user_data = 7});
  const std::uint32_t last = compound.add({box, at(-2)}, {.material = 3});
  const auto change = [&](const char* name, const std::function<void(Compound&)>& task) {
    fail_each_allocation_of_change<Compound>(name, compound, Left::Nothing, task);
  };
  change("a part is added", [](Compound& c) { c.add({Box{{0.5, 0.25, 0.25}}, at(0, 2)}); });
  change("a mesh is added", [&](Compound& c) {
    c.add({Mesh(box.vertices(), box.triangles()), at(1, 2)});
  });
  change("a part goes", [&](Compound& c) { c.remove(last); });
}

TEST(Allocations, OfVoxelMapsMayFail) {
  VoxelMap map({{0, 0, 0}, 0.25, {64, 64, 64}});
  map.add_block({3, 3, 3}, {30, 20, 20});
  const auto change = [&](const char* name, const std::function<void(VoxelMap&)>& task) {
    fail_each_allocation_of_change<VoxelMap>(name, map, Left::Part, task);
  };
  const std::vector<Voxel> some = {{1, 1, 1}, {60, 60, 60}, {33, 2, 7}, {4, 4, 4}};
  change("voxels are added", [&](VoxelMap& m) { m.add(some); });
  change("a block is added", [](VoxelMap& m) { m.add_block({10, 30, 10}, {50, 50, 40}); });
}

TEST(Allocations, OfHeightFieldsMayFail) {
  std::vector<float> heights(9 * 9);
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = 0.125F * static_cast<float>(i * i % 7);
  const HeightField field(9, 9, std::span<const float>(heights), {.spacing_x = 0.5});
  const std::vector<float> hill(4 * 4, 2);
  fail_each_allocation_of_change<HeightField>(
      "heights change", field, Left::Nothing, [&](HeightField& f) {
        f = f.with_heights({.first_column = 2, .first_row = 3, .columns = 4, .rows = 4},
                           std::span<const float>(hill));
      });
  fail_each_allocation_of_change<HeightField>(
      "another field", field, Left::Nothing, [&](HeightField& f) {
        f = HeightField(9, 9, std::span<const float>(heights), {.spacing_x = 0.25});
      });
}

}  // namespace
}  // namespace graze::tests
