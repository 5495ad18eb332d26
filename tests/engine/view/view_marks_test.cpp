// graze::View: pairs, planes, points, boxes of trees, exact corners and what a world draws.

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/view/view.h>
#include <graze/engine/world/world.h>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/engine/view/unpacked_page.h"

namespace graze::tests {
namespace {

using Eigen::Vector3d;

Pose moved_to(const Vector3d& place) {
  Pose pose = Pose::Identity();
  pose.translation() = place;
  return pose;
}

/// The words of the marks of a kind in a frame.
std::vector<std::uint32_t> words_of(const UnpackedPage& page, const char* kind, std::size_t width,
                                    std::size_t frame) {
  const auto& mark = page.json()["marks"][kind];
  const std::vector<std::uint32_t> starts = page.words(mark["starts"]),
                                   all = page.words(mark["list"]);
  return {all.begin() + static_cast<std::ptrdiff_t>(width * starts.at(frame)),
          all.begin() + static_cast<std::ptrdiff_t>(width * starts.at(frame + 1))};
}

TEST(ViewMarks, PairsAreKeptOnceTheLowerBodyFirst) {
  View view;
  std::vector<ViewBody> bodies;
  for (int i = 0; i < 3; ++i)
    bodies.push_back(view.add(Box{{1, 1, 1}}));
  for (int frame = 0; frame < 2; ++frame) {
    view.begin_frame();
    for (const ViewBody body : bodies)
      view.place(body, moved_to({2.0 * body.index, 0, 0}));
  }
  view.add_pair(bodies[2], bodies[1]);
  view.add_pair(bodies[1], bodies[2]);
  view.add_pair(bodies[0], bodies[1]);
  const UnpackedPage page(view.page());
  EXPECT_TRUE(words_of(page, "pairs", 2, 0).empty());
  EXPECT_EQ(words_of(page, "pairs", 2, 1), (std::vector<std::uint32_t>{0, 1, 1, 2}));
}

TEST(ViewMarks, ContactsThatStayStandThereOnce) {
  View view;
  const ViewBody body = view.add(Box{{1, 1, 1}});
  // Of frame 1 the first of frame 0, of frame 2 both the other way round and one that is new.
  const std::vector<std::vector<double>> depths = {{0.5, 0.25}, {0.5}, {0.25, 0.5, 0.125}};
  for (const std::vector<double>& of_frame : depths) {
    view.begin_frame();
    view.place(body, Pose::Identity());
    for (const double depth : of_frame)
      view.add_contact({depth, 0, 1}, {1, 2, 2}, depth);
  }
  const UnpackedPage page(view.page());
  EXPECT_EQ(page.words(page.json()["marks"]["contacts"]["list"]).size(), 3 * 7u);
  const double scale = page.json()["places"][0]["scale"];
  for (std::size_t f = 0; f < depths.size(); ++f) {
    const std::vector<float> found = page.marks("contacts", 7, f);
    ASSERT_EQ(found.size(), 7 * depths[f].size());
    for (std::size_t i = 0; i < depths[f].size(); ++i) {
      const float* contact = found.data() + 7 * i;
      EXPECT_EQ(contact[6] * scale, depths[f][i]);
      EXPECT_EQ(page.world(f, Vector3d(contact[0], contact[1], contact[2])).x(), depths[f][i]);
      // A normal is drawn, and rounded for that.
      const Vector3d normal(contact[3], contact[4], contact[5]);
      EXPECT_LT((normal - Vector3d(1, 2, 2) / 3).norm(), 2.5e-4);
    }
  }
}

TEST(ViewMarks, PlanesAndPointsAreWhereTheyWerePut) {
  View view;
  view.place(view.add(Box{{1, 1, 1}}), Pose::Identity());
  view.add_point({0.5, 0.25, -1});
  view.add_plane({.point = {0, 0, 1}, .normal = {0, 3, 4}, .half_extent = 0.5});
  const UnpackedPage page(view.page());
  const double scale = page.json()["places"][0]["scale"];
  const std::vector<float> point = page.marks("points", 3, 0), plane = page.marks("planes", 7, 0);
  ASSERT_EQ(point.size(), 3u);
  EXPECT_EQ(page.world(0, Vector3d(point[0], point[1], point[2])), Vector3d(0.5, 0.25, -1));
  ASSERT_EQ(plane.size(), 7u);
  EXPECT_EQ(page.world(0, Vector3d(plane[0], plane[1], plane[2])), Vector3d(0, 0, 1));
  EXPECT_NEAR(plane[4], 0.6, 1e-7);
  EXPECT_NEAR(plane[5], 0.8, 1e-7);
  EXPECT_EQ(plane[6] * scale, 0.5);
}

TEST(ViewMarks, BoxesGoWithTheirBodyLevelByLevel) {
  View view;
  const ViewBody body = view.add(Box{{2, 2, 2}});
  view.place(body, moved_to({5, 0, 0}));
  Obb turned{Pose::Identity(), {1, 0.5, 0.25}};
  turned.pose.linear() = Eigen::AngleAxisd(0.3, Vector3d::UnitZ()).toRotationMatrix();
  turned.pose.translation() = Vector3d(0.5, 0, 0);
  const std::vector<Obb> root = {{Pose::Identity(), {2, 2, 2}}}, below = {turned, root[0]};
  view.add_boxes(body, 0, root);
  view.add_boxes(body, 1, below);
  view.add_boxes(body, 1, root);
  const UnpackedPage page(view.page());
  const auto boxes = page.json()["marks"]["boxes"];
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[1]["level"], 1);
  const double scale = page.json()["meshes"][0]["scale"];
  const std::vector<float> numbers = page.floats(boxes[1]["list"]);
  ASSERT_EQ(numbers.size(), 36u) << "three boxes";
  EXPECT_NEAR(numbers[0] * scale, 0.5, 1e-6);
  EXPECT_NEAR(numbers[3] * scale, std::cos(0.3), 1e-6);
  EXPECT_NEAR(numbers[4] * scale, std::sin(0.3), 1e-6);
  EXPECT_NEAR(numbers[6] * scale, -0.5 * std::sin(0.3), 1e-6);
  EXPECT_NEAR(numbers[11] * scale, 0.25, 1e-6);
}

TEST(ViewMarks, SmallMeshesKeepTheirCornersToTheLastBit) {
  const std::vector<Vector3d> vertices = {
      {0.1, -1.0 / 3, 5e-324}, {1, 0, -0.0}, {0, 1 + 0x1p-52, std::numeric_limits<double>::max()}};
  const std::vector<TriangleIndices> triangles = {{0, 1, 2}};
  for (const std::uint32_t most : {3u, 2u}) {
    View view({.most_exact_vertices = most});
    view.begin_frame();
    view.add(Mesh(vertices, triangles));
    const UnpackedPage page(view.page());
    const auto mesh = page.json()["meshes"][0];
    ASSERT_EQ(mesh.contains("exact"), most == 3);
    if (most < 3) continue;
    const std::vector<std::uint32_t> words = page.words(mesh["exact"]);
    ASSERT_EQ(words.size(), 18u);
    for (std::size_t i = 0; i < 9; ++i)
      EXPECT_EQ(std::uint64_t{words[2 * i + 1]} << 32 | words[2 * i],
                std::bit_cast<std::uint64_t>(vertices[i / 3][static_cast<Eigen::Index>(i % 3)]));
  }
}

/// Counts what a world draws.
class Count final : public WorldDrawer {
 public:
  void line(const DrawnLine&) override { ++lines; }
  void point(const DrawnPoint&) override { ++points; }
  void label(const DrawnLabel&) override { ++labels; }

  std::size_t lines = 0, points = 0, labels = 0;
};

TEST(ViewMarks, AWorldIsDrawnAsItDrawsItself) {
  World world;
  world.add({Box{{1, 1, 1}}, Pose::Identity()});
  world.add({Box{{1, 1, 1}}, moved_to({0.5, 0.5, 1.99})});
  world.update();
  const WorldDrawingSettings settings = {.has_boxes = true, .has_labels = true};
  Count count;
  draw(world, count, settings);
  View view;
  view.begin_frame({.label = "step 1"});
  view.draw(world, settings);
  const UnpackedPage page(view.page());
  EXPECT_GT(count.points, 0u);
  EXPECT_EQ(page.marks("lines", 6, 0).size(), 6 * count.lines);
  EXPECT_EQ(page.marks("points", 3, 0).size(), 3 * count.points);
  EXPECT_EQ(page.json()["marks"]["labels"].size(), count.labels);
  EXPECT_EQ(count.labels, 2u);
}

}  // namespace
}  // namespace graze::tests
