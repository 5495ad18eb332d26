// Volumes around meshes and how well they fit.

#include <graze/bvh/error.h>
#include <graze/bvh/fit/measure.h>
#include <graze/engine/mesh/fit.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_meshes.h"

namespace graze::tests {
namespace {

using Vertices = std::vector<Eigen::Vector3d>;
using Triangles = std::vector<TriangleIndices>;

Mesh changed(const Mesh& mesh, double factor, const Eigen::Vector3d& offset) {
  Vertices vertices(mesh.vertices().begin(), mesh.vertices().end());
  for (Eigen::Vector3d& vertex : vertices)
    vertex = factor * vertex + offset;
  return Mesh(vertices, mesh.triangles());
}

Mesh inside_out(const Mesh& mesh) {
  Triangles triangles(mesh.triangles().begin(), mesh.triangles().end());
  for (TriangleIndices& triangle : triangles)
    std::swap(triangle[0], triangle[1]);
  return Mesh(mesh.vertices(), triangles);
}

TEST(MeshFit, EnclosedVolumes) {
  EXPECT_NEAR(signed_volume(make_box({1, 2, 0.5})), 8, 1e-14);
  EXPECT_NEAR(signed_volume(inside_out(make_box({1, 2, 0.5}))), -8, 1e-14);
  EXPECT_NEAR(signed_volume(make_sphere(1, 200, 200)), 4 * std::numbers::pi / 3, 1e-3);
  EXPECT_NEAR(signed_volume(make_torus(2, 0.5, 300, 200)), std::numbers::pi * std::numbers::pi,
              1e-2);
}

TEST(MeshFit, EnclosedVolumeScalesAndMoves) {
  const Mesh torus = make_torus(2, 0.5, 40, 20);
  const double expected = signed_volume(torus);
  EXPECT_EQ(signed_volume(changed(torus, 0x1p-200, {0, 0, 0})), expected * 0x1p-600);
  EXPECT_NEAR(signed_volume(changed(torus, 1, {1e6, -2e6, 3e6})), expected, 1e-8);
  EXPECT_EQ(signed_volume(changed(make_box({1, 1, 1}), 1e300, {0, 0, 0})), HUGE_VAL);
}

TEST(MeshFit, VolumesContainTheMesh) {
  const Mesh torus = make_torus(2, 0.5, 40, 20);
  const Sphere sphere = bounding_sphere(torus);
  const Obb box = bounding_obb(torus);
  const KDop<18> kdop = bounding_kdop(torus);
  for (const Eigen::Vector3d& vertex : torus.vertices()) {
    EXPECT_LE((vertex - sphere.centre).norm(), sphere.radius);
    const Eigen::Vector3d local = box.pose.inverse() * vertex;
    EXPECT_TRUE((local.cwiseAbs().array() <= box.half_extents.array()).all());
    for (int i = 0; i < KDop<18>::kSlabs; ++i) {
      const auto& d = kKDopDirections<18>[i];
      const double height = vertex.dot(Eigen::Vector3d(d[0], d[1], d[2]));
      EXPECT_LE(height, kdop.max[i]);
      EXPECT_GE(height, kdop.min[i]);
    }
  }
  EXPECT_NEAR(sphere.radius, 2.5, 1e-2);
}

TEST(MeshFit, VerticesThatNoTriangleUsesDoNotCount) {
  const Mesh box = make_box({1, 1, 1});
  Vertices vertices(box.vertices().begin(), box.vertices().end());
  vertices.push_back({100, 100, 100});
  const Mesh with_stray(vertices, box.triangles());
  EXPECT_EQ(bounding_sphere(with_stray).radius, bounding_sphere(box).radius);
  EXPECT_EQ(bounding_obb(with_stray).half_extents, bounding_obb(box).half_extents);
  EXPECT_EQ(bounding_kdop(with_stray).max, bounding_kdop(box).max);
}

TEST(MeshFit, ClosedMeshesHaveEmptyShares) {
  const MeshFit box = measure_fit(make_box({1, 2, 0.5}));
  ASSERT_TRUE(box.enclosed_volume);
  EXPECT_NEAR(*box.enclosed_volume, 8, 1e-14);
  EXPECT_EQ(box.volumes[0].type, Volume::Aabb);
  EXPECT_EQ(box.volumes[0].volume, 8);
  EXPECT_EQ(box.volumes[0].surface, 28);
  EXPECT_NEAR(box.volumes[0].empty_share.value(), 0, 1e-14);
  EXPECT_EQ(box.volumes[1].type, Volume::Sphere);
  const double sphere_volume = 4 * std::numbers::pi / 3 * std::pow(5.25, 1.5);
  EXPECT_NEAR(box.volumes[1].volume, sphere_volume, 1e-12);
  EXPECT_NEAR(box.volumes[1].empty_share.value(), 1 - 8 / sphere_volume, 1e-14);
  EXPECT_EQ(box.volumes[2].type, Volume::Obb);
  EXPECT_NEAR(box.volumes[2].empty_share.value(), 0, 1e-14);
  EXPECT_EQ(box.volumes[3].type, Volume::KDop);
  EXPECT_NEAR(box.volumes[3].empty_share.value(), 0, 1e-14);
  for (const VolumeFit& fit : box.volumes) {
    EXPECT_GE(fit.empty_share.value(), 0);
    EXPECT_FALSE(fit.relative_volume);
  }
}

TEST(MeshFit, InsideOutIsAsGood) {
  const Mesh torus = make_torus(2, 0.5, 40, 20);
  const MeshFit fit = measure_fit(torus);
  const MeshFit turned = measure_fit(inside_out(torus));
  EXPECT_NEAR(*fit.enclosed_volume, *turned.enclosed_volume, 1e-14);
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(*fit.volumes[i].empty_share, *turned.volumes[i].empty_share, 1e-14);
}

TEST(MeshFit, WhatIsEnclosedTwiceLeavesNothingEmpty) {
  const Mesh box = make_box({1, 1, 1});
  Triangles twice(box.triangles().begin(), box.triangles().end());
  twice.insert(twice.end(), box.triangles().begin(), box.triangles().end());
  const MeshFit fit = measure_fit(Mesh(box.vertices(), twice));
  EXPECT_NEAR(fit.enclosed_volume.value(), 16, 1e-13);
  EXPECT_EQ(fit.volumes[0].empty_share.value(), 0);
}

TEST(MeshFit, OpenMeshesAreMeasuredAgainstTheirBounds) {
  const Mesh box = make_box({1, 2, 0.5});
  const Mesh open(box.vertices(), box.triangles().first(10));
  const MeshFit fit = measure_fit(open);
  EXPECT_FALSE(fit.enclosed_volume);
  EXPECT_EQ(fit.volumes[0].relative_volume.value(), 1);
  EXPECT_NEAR(fit.volumes[1].relative_volume.value(), fit.volumes[1].volume / 8, 1e-14);
  EXPECT_FALSE(fit.volumes[1].empty_share);
}

TEST(MeshFit, FlatMeshesHaveNoShares) {
  const MeshFit row = measure_fit(make_row(3));
  EXPECT_EQ(row.volumes[0].volume, 0);
  EXPECT_GT(row.volumes[1].volume, 0);
  for (const VolumeFit& fit : row.volumes) {
    EXPECT_FALSE(fit.relative_volume);
    EXPECT_FALSE(fit.empty_share);
  }
}

TEST(MeshFit, WhatOverflowsIsRefused) {
  const double big = std::numeric_limits<double>::max();
  const Mesh huge(Vertices{{-big, -big, 0}, {big, 0, 0}, {0, big, 0}}, Triangles{{0, 1, 2}});
  EXPECT_THROW(bounding_sphere(huge), InputError);
  EXPECT_THROW(measure_fit(huge), InputError);
}

}  // namespace
}  // namespace graze::tests
