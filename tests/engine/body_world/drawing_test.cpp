// What is drawn of a world: every point of an outline lies on the shape that it shows, boxes and
// contacts are those that the world tells.

#include <graze/bvh/error.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>
#include <graze/engine/world/world_drawing.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/engine/world/random_shapes.h"
#include "tests/engine/world/surface_distance.h"
#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/shape_kinds.h"

namespace graze {
namespace {

using Eigen::Vector3d;

/// Keeps all that is drawn.
class Kept : public WorldDrawer {
 public:
  void line(const DrawnLine& line) override { lines.push_back(line); }
  void point(const DrawnPoint& point) override { points.push_back(point); }
  void label(const DrawnLabel& label) override { labels.push_back(label); }

  std::size_t count(Drawn what) const {
    std::size_t result = 0;
    for (const DrawnLine& each : lines)
      result += each.what == what;
    return result;
  }

  std::vector<DrawnLine> lines;
  std::vector<DrawnPoint> points;
  std::vector<DrawnLabel> labels;
};

Pose turned() {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = Vector3d(0.3, -4, 7);
  return pose;
}

TEST(WorldDrawing, OutlinesLieOnTheirShapes) {
  RandomSource source(5);
  for (const ShapeKind kind : tests::kOwnKinds) {
    for (int n = 0; n < 5; ++n) {
      const Shape shape = tests::random_shape(kind, 2, source);
      Kept kept;
      draw({shape, turned()}, kept, {.segments = 16}, {3, 1});
      ASSERT_FALSE(kept.lines.empty());
      const tests::Surface surface(shape);
      for (const DrawnLine& line : kept.lines) {
        EXPECT_EQ(line.what, Drawn::Shape);
        EXPECT_EQ(line.body, (BodyId{3, 1}));
        const bool is_normal = kind == ShapeKind::HalfSpace && &line == &kept.lines.back();
        EXPECT_LT(surface.distance(turned(), line.from), 1e-12) << static_cast<int>(kind);
        EXPECT_EQ(surface.distance(turned(), line.to) < 1e-12, !is_normal)
            << static_cast<int>(kind);
      }
    }
  }
}

TEST(WorldDrawing, APlaneHasBothItsNormals) {
  Kept kept;
  draw(Shape(Plane{{0, 0, 1}, 2}), kept);
  int above = 0, below = 0;
  for (const DrawnLine& line : kept.lines) {
    EXPECT_EQ(line.from.z(), 2);
    above += line.to.z() > 2;
    below += line.to.z() < 2;
  }
  EXPECT_EQ(above, 1);
  EXPECT_EQ(below, 1);
}

/// How many lines there are of a shape, and how many different ends.
std::pair<std::size_t, std::size_t> size_of_drawing(const Shape& shape) {
  Kept kept;
  draw(shape, kept);
  std::set<std::vector<double>> ends;
  for (const DrawnLine& line : kept.lines) {
    for (const Vector3d& end : {line.from, line.to})
      ends.insert({end.x(), end.y(), end.z()});
  }
  return {kept.lines.size(), ends.size()};
}

TEST(WorldDrawing, EachEdgeIsDrawnOnce) {
  EXPECT_EQ(size_of_drawing(Box{{1, 2, 3}}), std::pair(12ul, 8ul));
  EXPECT_EQ(size_of_drawing(tests::make_box({1, 2, 3})), std::pair(18ul, 8ul));
  const std::vector<Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(size_of_drawing(ConvexHull(corners)), std::pair(6ul, 4ul));
  EXPECT_EQ(size_of_drawing(Cone{1, 1}).first, 24u + 4);
  EXPECT_EQ(size_of_drawing(Sphere{{0, 0, 0}, 1}).first, 3u * 24);
}

class DrawnWorld : public testing::Test {
 protected:
  DrawnWorld() : world_({.threads = 1, .islands = true}) {
    Compound pair;
    pair.add({Box{{1, 1, 1}}});
    Pose aside = Pose::Identity();
    aside.translation().x() = 3;
    pair.add({Box{{1, 1, 1}}, aside});
    floor_ = world_.add({Box{{9, 9, 1}}, at(0, 0, -1)}, {.kind = BodyKind::Static});
    parts_ = world_.add({share(pair), at(0, 0, 0.9)});
    upper_ = world_.add({Box{{1, 1, 1}}, at(0, 0, 2.85)});
  }

  static Pose at(double x, double y, double z) {
    Pose pose = Pose::Identity();
    pose.translation() = Vector3d(x, y, z);
    return pose;
  }

  World world_;
  BodyId floor_, parts_, upper_;
};

TEST_F(DrawnWorld, ShowsWhatIsAskedFor) {
  world_.update();
  Kept kept;
  draw(world_, kept,
       {.has_shapes = true,
        .has_boxes = true,
        .has_contacts = true,
        .has_islands = true,
        .has_labels = true});
  EXPECT_EQ(kept.count(Drawn::Shape), 4u * 12) << "parts are boxes of their own";
  EXPECT_EQ(kept.count(Drawn::Box), 3u * 12);
  std::size_t contacts = 0;
  for (const BodyContact& each : world_.contacts())
    contacts += each.manifold.size();
  EXPECT_EQ(contacts, 12u) << "three faces on faces";
  EXPECT_EQ(kept.count(Drawn::Contact), contacts);
  ASSERT_EQ(kept.points.size(), contacts);
  for (const DrawnLine& line : kept.lines) {
    if (line.what != Drawn::Contact) continue;
    const double depth = (line.to - line.from).norm();
    EXPECT_TRUE(std::abs(depth - 0.1) < 1e-9 || std::abs(depth - 0.05) < 1e-9) << depth;
    EXPECT_LT(std::abs(line.from.x() - line.to.x()), 1e-9) << "upright";
  }
  EXPECT_EQ(kept.count(Drawn::Island), 1u) << "two bodies, and the floor is in none";
  ASSERT_EQ(kept.labels.size(), 3u);
  EXPECT_EQ(kept.labels[0].text, std::to_string(floor_.index) + " asleep");
  EXPECT_EQ(kept.labels[2].body, upper_);
  EXPECT_LT((kept.labels[2].at - Vector3d(0, 0, 2.85)).norm(), 1e-6);
}

TEST_F(DrawnWorld, ShowsEachVoxelOfAMap) {
  VoxelMap map(VoxelGrid{{-1, -1, -1}, 0.5, {4, 4, 4}});
  map.add(std::vector<Voxel>{{0, 0, 0}, {3, 3, 3}, {1, 0, 0}});
  World world({.threads = 1});
  const BodyId id = world.add({share(map), at(0, 0, 5)});
  world.update();
  Kept kept;
  draw(world, kept);
  ASSERT_EQ(kept.count(Drawn::Shape), 3u * 12);
  std::set<std::vector<double>> corners, wanted;
  for (const DrawnLine& line : kept.lines) {
    EXPECT_EQ(line.body, id);
    corners.insert({line.from.x(), line.from.y(), line.from.z()});
    corners.insert({line.to.x(), line.to.y(), line.to.z()});
  }
  for (const Voxel& voxel : map.voxels()) {
    const Aabb box = map.grid().box(voxel);
    for (int corner = 0; corner < 8; ++corner) {
      const auto along = [&](int axis) {
        return (corner >> axis & 1) != 0 ? box.max[axis] : box.min[axis];
      };
      wanted.insert({along(0), along(1), along(2) + 5});
    }
  }
  EXPECT_EQ(corners, wanted);
}

TEST_F(DrawnWorld, ShowsNothingElse) {
  world_.update();
  Kept kept;
  draw(world_, kept, {.has_shapes = false, .has_contacts = false});
  EXPECT_TRUE(kept.lines.empty() && kept.points.empty() && kept.labels.empty());
}

TEST_F(DrawnWorld, RefusesWhatCannotBeDrawn) {
  Kept kept;
  EXPECT_THROW(draw(world_, kept), InputError) << "contacts before an update";
  world_.update();
  EXPECT_THROW(draw(world_, kept, {.segments = 2}), InputError);
  EXPECT_THROW(draw(world_, kept, {.segments = 5000}), InputError);
  EXPECT_THROW(draw(world_, kept, {.half_space_extent = 0}), InputError);
  EXPECT_THROW(draw(world_, kept, {.half_space_extent = std::nan("")}), InputError);
  World plain({.threads = 1});
  EXPECT_THROW(draw(plain, kept, {.has_islands = true}), InputError);
  Pose bent = Pose::Identity();
  bent.linear() *= 2;
  EXPECT_THROW(draw({Shape(Box{{1, 1, 1}}), bent}, kept), PoseError);
}

TEST_F(DrawnWorld, LetsWhatADrawerThrowsThrough) {
  class Throws : public WorldDrawer {
    void line(const DrawnLine&) override { throw std::runtime_error("no ink"); }
  };
  Throws drawer;
  world_.update();
  EXPECT_THROW(draw(world_, drawer), std::runtime_error);
  EXPECT_EQ(world_.size(), 3u);
}

}  // namespace
}  // namespace graze
