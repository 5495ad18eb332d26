// What the bodies of histories look like.

#include <algorithm>
#include <cmath>

#include "tests/engine/histories/history.h"
#include "tests/engine/histories/parts_plan.h"

namespace graze::tests {
namespace {

using Eigen::Vector3d;

/// A closed surface of 8 * 4^level triangles: an octahedron divided, its corners on a ball.
Mesh ball_mesh(double radius, int level) {
  std::vector<Vector3d> corners{{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  std::vector<TriangleIndices> faces{{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2},
                                     {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  const auto between = [&](std::uint32_t a, std::uint32_t b) {
    const Vector3d sum = corners[a] + corners[b];
    const double length = std::sqrt(sum.x() * sum.x() + sum.y() * sum.y() + sum.z() * sum.z());
    const Vector3d point(sum.x() / length, sum.y() / length, sum.z() / length);
    const auto found = std::find(corners.begin(), corners.end(), point);
    if (found == corners.end()) corners.push_back(point);
    return static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), point) -
                                      corners.begin());
  };
  for (; level > 0; --level) {
    std::vector<TriangleIndices> finer;
    for (const auto& [a, b, c] : faces) {
      const std::uint32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = finer;
  }
  for (Vector3d& corner : corners)
    corner *= radius;
  return Mesh(corners, faces);
}

/// An open surface of 2 * cells^2 triangles, whole heights 0 and 1.
Mesh plate_mesh(double size, std::uint32_t cells) {
  std::vector<Vector3d> corners;
  std::vector<TriangleIndices> faces;
  for (std::uint32_t y = 0; y <= cells; ++y) {
    for (std::uint32_t x = 0; x <= cells; ++x)
      corners.emplace_back(size * x, size * y, size * ((x * y) % 3 == 1 ? 0.25 : 0));
  }
  for (std::uint32_t y = 0; y < cells; ++y) {
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t at = y * (cells + 1) + x;
      faces.push_back({at, at + 1, at + cells + 2});
      faces.push_back({at, at + cells + 2, at + cells + 1});
    }
  }
  return Mesh(corners, faces);
}

ConvexHull corners_of_box(double x, double y, double z) {
  return ConvexHull(std::vector<Vector3d>{{x, y, z},
                                          {x, y, -z},
                                          {x, -y, z},
                                          {x, -y, -z},
                                          {-x, y, z},
                                          {-x, y, -z},
                                          {-x, -y, z},
                                          {-x, -y, -z}});
}

void add_kinds(std::vector<Shape>& shapes, double s) {
  const std::vector<Vector3d> octahedron{{s, 0, 0},  {0, s, 0},  {0, 0, s},
                                         {-s, 0, 0}, {0, -s, 0}, {0, 0, -s}};
  shapes.insert(shapes.end(),
                {Sphere{{0, 0, 0}, s}, Sphere{{0.5 * s, 0, -s}, 0.5 * s}, Box{{s, s, s}},
                 Box{{0.5 * s, s, 2 * s}}, Capsule{0.5 * s, s}, Cylinder{s, s}, Cone{s, s},
                 Ellipsoid{{0, 0, 0}, {s, 0.5 * s, s}}, ConvexHull(octahedron),
                 corners_of_box(s, s, 0.5 * s), ball_mesh(s, 1), plate_mesh(0.5 * s, 4)});
}

/// Five by four heights on a lattice: steps, a flat part, slopes.
HeightField terrain(double size, bool has_floats) {
  std::vector<float> floats;
  std::vector<std::uint16_t> shorts;
  for (std::uint32_t row = 0; row < 4; ++row) {
    for (std::uint32_t column = 0; column < 5; ++column) {
      const std::uint32_t height = (row * column) % 3 == 1 ? 2 : column > 3 ? 1 : 0;
      floats.push_back(static_cast<float>(height));
      shorts.push_back(static_cast<std::uint16_t>(height));
    }
  }
  const HeightFieldSettings settings{
      .spacing_x = size, .spacing_y = size, .height_scale = size / 4};
  return has_floats ? HeightField(5, 4, floats, settings) : HeightField(5, 4, shorts, settings);
}

/// Where shapes stand in the palette of Setting::Parts: of each kind a large one and a small one.
enum PartShape : std::uint32_t {
  kPartBall = 0,
  kPartBox = 2,
  kPartSlab = 3,
  kPartCapsule = 4,
  kPartCylinder = 5,
  kPartCone = 6,
  kPartEllipsoid = 7,
  kPartOctahedron = 8,
  kPartBallMesh = 10,
  kPartPlateMesh = 11,
  kPartSmall = 12,  // as an offset
  kPartField = 2 * kPartSmall,
  kPaintedMesh,
  kVoxelBox
};

constexpr double kFineEdge = 0.1, kCoarseEdge = 0.25;  // of voxels, one of them rounded

/// Each triangle of another material.
Mesh painted(const Mesh& mesh) {
  std::vector<std::uint16_t> materials(mesh.triangles().size());
  for (std::size_t i = 0; i < materials.size(); ++i)
    materials[i] = static_cast<std::uint16_t>(1 + i % 7);
  return Mesh(mesh.vertices(), mesh.triangles(), materials);
}

void add_shapes_of_parts(std::vector<Shape>& shapes) {
  add_kinds(shapes, 0.125);
  shapes.emplace_back(terrain(0.25, true));
  shapes.emplace_back(painted(ball_mesh(0.375, 1)));
  shapes.emplace_back(Box{Vector3d::Constant(kFineEdge / 2)});
}

Pose turned_at(double x, double y, double z, int turn) {
  constexpr double kTurns[4][9] = {
      {1, 0, 0, 0, 1, 0, 0, 0, 1},  // none, two right angles, and one in thirds
      {0, -1, 0, 1, 0, 0, 0, 0, 1},
      {1, 0, 0, 0, 0, -1, 0, 1, 0},
      {2.0 / 3, -1.0 / 3, 2.0 / 3, 2.0 / 3, 2.0 / 3, -1.0 / 3, -1.0 / 3, 2.0 / 3, 2.0 / 3}};
  Pose pose = Pose::Identity();
  for (int i = 0; i < 9; ++i)
    pose.matrix()(i / 3, i % 3) = kTurns[turn][i];
  pose.translation() = Vector3d(x, y, z);
  return pose;
}

/// A dumbbell, which touches itself.
PartsPlan dumbbell() {
  return {.parts = {{kPartSmall + kPartBall, turned_at(-0.5, 0, 0, 0)},
                    {kPartSmall + kPartSlab, turned_at(0, 0, 0, 1)},
                    {kPartSmall + kPartBox, turned_at(0.5, 0, 0, 0), Filter{2, 3, 0}, 7}}};
}

/// Meshes in meshes, and round things among them, some for few to meet.
PartsPlan nest() {
  return {.parts = {{kPartBallMesh, turned_at(0, 0, 0, 0)},
                    {kPartSmall + kPartBallMesh, turned_at(0, 0, 0.25, 3)},
                    {kPaintedMesh, turned_at(0.5, 0, 0, 1), {}, 3},
                    {kPartSmall + kPartCone, turned_at(0, 0.5, 0, 2), Filter{1, 4, 0}},
                    {kPartSmall + kPartCylinder, turned_at(0, -0.5, 0, 3), Filter{4, ~0u, 0}},
                    {kPartSmall + kPartEllipsoid, turned_at(0.25, 0.25, 0.5, 0)},
                    {kPartOctahedron, turned_at(-0.5, 0, 0, 3), Filter{1, ~0u, 2}, 9}}};
}

/// So many that they are looked up: stairs of boxes with balls on them, face to face.
PartsPlan stairs() {
  PartsPlan plan;
  for (int i = 0; i < 10; ++i) {
    const double x = 0.25 * i - 1.125;
    plan.parts.push_back({kPartSmall + kPartBox, turned_at(x, 0, 0.125 * i - 0.5, 0), {}, 1});
    plan.parts.push_back({kPartSmall + kPartBall, turned_at(x, 0, 0.125 * i - 0.25, i % 4)});
  }
  return plan;
}

/// Ground with things that stand on it.
PartsPlan plot() {
  return {.parts = {{kPartField, turned_at(-0.5, -0.375, 0, 0)},
                    {kPartSmall + kPartPlateMesh, turned_at(-0.25, -0.25, 0.5, 0)},
                    {kPartSmall + kPartCapsule, turned_at(0.25, 0, 0.25, 2)},
                    {kPartSmall + kPartOctahedron, turned_at(0.25, 0.25, 0.125, 0)}}};
}

/// Voxels on both sides of where blocks of 16 meet, about the frame's origin.
PartsPlan lump() {
  PartsPlan plan;
  const Vector3d corner = Vector3d::Constant(-16 * kFineEdge);
  plan.grid = VoxelGrid{corner, kFineEdge, {40, 40, 40}};
  plan.voxel_shape = kVoxelBox;
  for (std::uint16_t k = 14; k < 18; ++k)
    for (std::uint16_t j = 14; j < 18; ++j)
      for (std::uint16_t i = 13; i < 19; ++i)
        if ((i + j + k) % 3 != 0) plan.voxels.push_back({i, j, k});
  return plan;
}

/// Few and coarse, far from each other; the edge is exact.
PartsPlan crumbs() {
  PartsPlan plan;
  plan.grid = VoxelGrid{Vector3d::Constant(-0.5), kCoarseEdge, {20, 6, 6}};
  plan.voxel_shape = kPartSmall + kPartBox;
  plan.voxels = {{0, 0, 0}, {1, 0, 0}, {2, 2, 2}, {3, 2, 2}, {2, 3, 2}, {5, 0, 3}, {19, 5, 5}};
  return plan;
}

}  // namespace

std::vector<PartsPlan> plans_of(Setting setting) {
  if (setting != Setting::Parts) return {};
  return {dumbbell(), nest(), stairs(), plot(), lump(), crumbs()};
}

std::vector<Shape> palette_of(Setting setting) {
  std::vector<Shape> shapes;
  if (setting == Setting::Sizes) {
    for (const double size : {1e-6, 1.0, 1e6})
      add_kinds(shapes, size);
  } else {
    add_kinds(shapes, 0.5);
  }
  if (setting == Setting::Parts) add_shapes_of_parts(shapes);
  if (setting != Setting::OnePoint) {
    shapes.emplace_back(HalfSpace{{0, 0, 1}, -1});
    shapes.emplace_back(HalfSpace{{1, 2, -2}, -6});
  }
  if (setting == Setting::Terrains) {
    shapes.emplace_back(Plane{{0, 0, 1}, -1});
    shapes.emplace_back(Plane{{2, -1, 2}, 3});
    shapes.emplace_back(terrain(0.5, true));
    shapes.emplace_back(terrain(1, false));
  }
  if (setting == Setting::Parts) shapes.emplace_back(Plane{{0, 0, 1}, -1.5});
  return shapes;
}

}  // namespace graze::tests
