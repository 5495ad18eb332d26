// graze::View: what its pages hold, beside what was put in.

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/view/view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/engine/view/unpacked_page.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::tests {
namespace {

using Eigen::Vector3d;

Pose pose_at(const Vector3d& place, double angle = 0) {
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = place;
  return pose;
}

Mesh scaled(const Mesh& mesh, double factor, const Vector3d& offset) {
  std::vector<Vector3d> vertices;
  for (const Vector3d& vertex : mesh.vertices())
    vertices.emplace_back(factor * vertex + offset);
  return Mesh(vertices, mesh.triangles());
}

/// Of the corners of all triangles, which are told in the order of the mesh.
double largest_difference(const std::vector<Vector3d>& found, const Mesh& mesh, const Pose& pose) {
  EXPECT_EQ(found.size(), 3 * mesh.triangles().size());
  double most = 0;
  for (std::size_t i = 0; i < std::min(found.size(), 3 * mesh.triangles().size()); ++i) {
    const Vector3d& vertex = mesh.vertices()[mesh.triangles()[i / 3][i % 3]];
    most = std::max(most, (found[i] - pose * vertex).cwiseAbs().maxCoeff());
  }
  return most;
}

TEST(View, VerticesAreWherePosesTakeThemWhateverTheScale) {
  const Mesh torus = make_torus(1, 0.3, 20, 12);
  for (const double factor : {1.0, 1e-3, 1e-200, 1e-310, 1e200, 1e306}) {
    for (const double far : {0.0, 100.0}) {
      const Mesh mesh = scaled(torus, factor, Vector3d(far, -far, 0) * factor / 10);
      View view;
      const ViewBody body = view.add(mesh);
      std::vector<Pose> poses;
      for (int i = 0; i < 3; ++i) {
        poses.push_back(pose_at(Vector3d(i, 2 * i, -i) * factor, 0.7 * i));
        view.begin_frame();
        view.place(body, poses.back());
      }
      const UnpackedPage page(view.page());
      // Floats of the mesh, of the quaternion and of the frame, which is some ten times as large.
      const double most = factor * (far + 20) * 0x1p-22;
      for (std::size_t frame = 0; frame < poses.size(); ++frame)
        EXPECT_LE(largest_difference(page.corners(0, frame), mesh, poses[frame]), most)
            << factor << " " << far;
    }
  }
}

TEST(View, VerticesWithoutATriangleDoNotCount) {
  const std::vector<Vector3d> vertices = {{1e300, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<TriangleIndices> triangles = {{1, 2, 3}};
  View view;
  view.place(view.add(Mesh(vertices, triangles)), Pose::Identity());
  const std::vector<Vector3d> found = UnpackedPage(view.page()).vertices(0, 0);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_LE((found[1] - vertices[2]).norm(), 1e-6);
}

TEST(View, EachShapeIsKeptOnce) {
  const Mesh torus = make_torus(1, 0.3, 20, 12);
  View view;
  for (int i = 0; i < 3; ++i) {
    view.add(torus);
    view.add(Box{{1, 2, 3}});
    view.add(Sphere{Vector3d::Zero(), 1});
  }
  view.add(Box{{1, 2, 4}});
  view.begin_frame();
  const UnpackedPage page(view.page());
  EXPECT_EQ(page.json()["bodies"].size(), 10u);
  EXPECT_EQ(page.json()["meshes"].size(), 4u);
  EXPECT_EQ(page.json()["bodies"][3]["name"], "mesh 3");
}

/// Of the surface of a body in a frame, by the divergence theorem: positive if it is closed and
/// turns counter-clockwise as seen from outside.
double volume_of(const UnpackedPage& page, std::size_t body) {
  const std::vector<Vector3d> v = page.vertices(body, 0);
  const auto& mesh = page.json()["meshes"][page.json()["bodies"][body]["mesh"].get<std::size_t>()];
  const std::vector<std::uint32_t> t = page.words(mesh["indices"]);
  double volume = 0;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3)
    volume += v[t[i]].dot(v[t[i + 1]].cross(v[t[i + 2]])) / 6;
  return volume;
}

/// Every edge has just one triangle on each side.
bool is_closed(const UnpackedPage& page, std::size_t body) {
  const auto& mesh = page.json()["meshes"][page.json()["bodies"][body]["mesh"].get<std::size_t>()];
  const std::vector<std::uint32_t> t = page.words(mesh["indices"]);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::size_t i = 0; i < t.size(); ++i)
    edges.emplace_back(t[i], t[i / 3 * 3 + (i + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) == edges.end() &&
         std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
           return std::binary_search(edges.begin(), edges.end(),
                                     std::pair(edge.second, edge.first));
         });
}

TEST(View, ShapesAreClosedAndAsLargeAsTheirFormulas) {
  const double pi = std::numbers::pi;
  const std::vector<Vector3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const std::vector<std::pair<Shape, double>> shapes = {
      {Sphere{{5, 0, 0}, 2}, 4 * pi / 3 * 8},
      {Ellipsoid{{0, 1, 0}, {1, 2, 3}}, 4 * pi / 3 * 6},
      {Box{{1, 2, 3}}, 48},
      {Capsule{0.5, 2}, 4 * pi / 3 * 0.125 + pi * 0.25 * 4},
      {Capsule{0.5, 0}, 4 * pi / 3 * 0.125},
      {Cylinder{2, 3}, pi * 4 * 6},
      {Cone{2, 3}, pi * 4 * 6 / 3},
      {ConvexHull(corners), 0.5}};
  View view({.segments = 256});
  for (const auto& [shape, volume] : shapes)
    view.place(view.add(shape), Pose::Identity());
  const UnpackedPage page(view.page());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string name = page.json()["bodies"][i]["name"];
    EXPECT_TRUE(is_closed(page, i)) << name;
    EXPECT_NEAR(volume_of(page, i) / shapes[i].second, 1, 5e-4) << name;
    EXPECT_LE(volume_of(page, i), shapes[i].second * (1 + 1e-5)) << name << ": corners are on it";
  }
}

TEST(View, HalfSpacesAreSquaresOnTheirPlanesAndFramesDoNotFollowThem) {
  const HalfSpace plane{{0, 3, 4}, 10};
  View view;
  const ViewBody floor = view.add(plane, {.half_space_extent = 1000});
  const ViewBody ball = view.add(Sphere{Vector3d::Zero(), 1});
  view.place(floor, Pose::Identity());
  view.place(ball, Pose::Identity());
  const UnpackedPage page(view.page());
  EXPECT_TRUE(page.json()["meshes"][0]["boundless"].get<bool>());
  ASSERT_EQ(page.vertices(0, 0).size(), 4u);
  for (const Vector3d& corner : page.vertices(0, 0))
    EXPECT_NEAR(corner.dot(Vector3d(0, 0.6, 0.8)), 2, 1e-3);
  EXPECT_LE(page.json()["places"][0]["scale"].get<double>(), 2);
}

TEST(View, HeightFieldsAreTheirMeshes) {
  const std::vector<float> heights = {0, 1, 0, 2, 3, 2};
  const HeightField field(3, 2, heights);
  View view;
  view.place(view.add(field), Pose::Identity());
  EXPECT_LE(
      largest_difference(UnpackedPage(view.page()).corners(0, 0), field.mesh(), Pose::Identity()),
      1e-6);
}

TEST(View, BodiesStandWhereTheyArePlacedAlone) {
  View view;
  const ViewBody a = view.add(Box{{1, 1, 1}}), b = view.add(Box{{1, 1, 1}});
  view.place(a, Pose::Identity());
  view.begin_frame();
  view.place(b, pose_at({1, 0, 0}));
  view.place(b, pose_at({2, 0, 0}));
  view.begin_frame();
  const UnpackedPage page(view.page());
  EXPECT_EQ(page.json()["frames"].size(), 3u);
  EXPECT_EQ(page.vertices(0, 0).size(), 8u);
  EXPECT_TRUE(page.vertices(0, 1).empty());
  ASSERT_EQ(page.vertices(1, 1).size(), 8u);
  EXPECT_NEAR(page.vertices(1, 1)[0].x(), 1, 1e-6) << "the last pose counts";
  EXPECT_TRUE(page.vertices(1, 2).empty());
}

TEST(View, FramesApartHaveAMiddleAndAScaleOfTheirOwn) {
  View view;
  const ViewBody small = view.add(Box{{1e-9, 1e-9, 1e-9}}), large = view.add(Box{{1e9, 1e9, 1e9}});
  view.place(small, pose_at({7, 0, 0}));
  view.begin_frame({.is_apart = true});
  view.place(large, Pose::Identity());
  view.begin_frame();
  const UnpackedPage page(view.page());
  EXPECT_EQ(page.json()["places"].size(), 2u);
  EXPECT_EQ(page.json()["frames"][2]["place"], 1);
  EXPECT_NEAR((page.vertices(0, 0)[7] - page.vertices(0, 0)[0]).x(), 2e-9, 1e-14);
  EXPECT_NEAR((page.vertices(1, 1)[7] - page.vertices(1, 1)[0]).x(), 2e9, 1e3);
}

TEST(View, MarksAreWhereTheyWerePut) {
  View view;
  const ViewBody box = view.add(Box{{1, 1, 1}});
  view.begin_frame();
  view.place(box, Pose::Identity());
  view.begin_frame({.label = "<b>",
                    .state = ViewState::Touching,
                    .says = "deep",
                    .facts = {{"depth", 0.125, true}, {"pairs", 3}},
                    .note = "why"});
  view.place(box, Pose::Identity());
  const std::vector<std::uint32_t> first = {5, 1}, second = {1, 3};
  view.mark_triangles(box, first);
  view.mark_triangles(box, second);
  const std::vector<Vector3d> curve = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  view.add_curve(curve);
  view.add_line({0, 0, 1}, {0, 0, -1});
  view.add_contact({0.5, 0, 0}, {0, 0, 5}, 0.125);
  view.add_gap({0, 0, 0}, {0, 0.5, 0}, 0.5);
  view.add_label({0, 0, 1}, "</script>");
  const UnpackedPage page(view.page());
  const auto frame = page.json()["frames"][1];
  EXPECT_EQ(frame["label"], "<b>");
  EXPECT_EQ(frame["state"], "touching");
  EXPECT_EQ(frame["note"], "why");
  EXPECT_EQ(frame["facts"][0]["value"], 0.125);
  EXPECT_FALSE(frame["facts"][1]["length"].get<bool>());
  const auto marked = page.json()["marks"]["triangles"][0];
  EXPECT_EQ(page.words(marked["frames"]), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(page.words(marked["list"]), (std::vector<std::uint32_t>{1, 3, 5}));
  EXPECT_TRUE(page.marks("curves", 6, 0).empty());
  ASSERT_EQ(page.marks("curves", 6, 1).size(), 12u);
  EXPECT_EQ(
      page.world(1, Vector3d(page.marks("curves", 6, 1)[9], page.marks("curves", 6, 1)[10], 0)),
      Vector3d(1, 1, 0));
  EXPECT_EQ(page.marks("lines", 6, 1).size(), 6u);
  const std::vector<float> contact = page.marks("contacts", 7, 1);
  ASSERT_EQ(contact.size(), 7u);
  EXPECT_EQ((std::vector<float>{contact.begin() + 3, contact.begin() + 6}),
            (std::vector<float>{0, 0, 1}));
  const double scale = page.json()["places"][0]["scale"];
  EXPECT_EQ(contact[6] * scale, 0.125);
  EXPECT_EQ(page.marks("gaps", 7, 1)[6] * scale, 0.5);
  EXPECT_EQ(page.json()["marks"]["labels"][0]["text"], "</script>");
}

TEST(View, NamesAreTextAndNothingIsLoaded) {
  View view(
      {.title = "</title><script>alert('t')</script>", .notes = {"<script>alert('n')</script>"}});
  const ViewBody body =
      view.add(Box{{1, 1, 1}}, {.name = "<script>alert('b')</script>", .color = {{255, 0, 10}}});
  view.begin_frame({.label = "<img src=x onerror=alert('l')>"});
  view.place(body, Pose::Identity());
  const std::string page = view.page();
  EXPECT_EQ(page.find("alert('"), page.find("alert('t')"));
  EXPECT_NE(page.find("<title>&lt;/title&gt;&lt;script&gt;alert('t')"), page.npos);
  EXPECT_NE(page.find("Content-Security-Policy\" content=\"default-src 'none'"), page.npos);
  for (const char* link : {"<link", "src=\"http", "href=\"http", "@import", "url(http"})
    EXPECT_EQ(page.find(link), page.npos) << link;
  const UnpackedPage unpacked(page);
  EXPECT_EQ(unpacked.json()["bodies"][0]["name"], "<script>alert('b')</script>");
  EXPECT_EQ(unpacked.json()["bodies"][0]["color"], "#ff000a");
}

TEST(View, NamesThatAreNoUtf8AreShownAsFarAsTheyAre) {
  View view;
  view.place(view.add(Box{{1, 1, 1}}, {.name = "bolt\xff.obj"}), Pose::Identity());
  EXPECT_EQ(UnpackedPage(view.page()).json()["bodies"][0]["name"], "bolt\xEF\xBF\xBD.obj");
}

TEST(View, TheSameCallsGiveTheSameBytes) {
  const auto make = [] {
    View view({.title = "twice"});
    const ViewBody body = view.add(make_torus(1, 0.3, 20, 12));
    for (int i = 0; i < 5; ++i) {
      view.begin_frame();
      view.place(body, pose_at({0.1 * i, 0, 0}, i));
    }
    return view.page();
  };
  const std::string first = make();
  EXPECT_EQ(make(), first);
}

}  // namespace
}  // namespace graze::tests
