// The parts of samples/simulation against what is known of them.

#include <gtest/gtest.h>

#include <graze/bvh/error.h>
#include <graze/engine/mesh/self.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "samples/simulation/bin.h"
#include "samples/simulation/gltf_writer.h"
#include "samples/simulation/mass_properties.h"
#include "tests/files/temporary_directory.h"

namespace graze::samples {
namespace {

// Half the box [0, 2] x [0, 4] x [0, 6], cut along a diagonal of its base, and the other half.
Mesh prism(double sign) {
  const double s = sign;
  const std::vector<Eigen::Vector3d> vertices{{0, 0, 0},     {2 * s, 0, 0},     {0, 4 * s, 0},
                                              {0, 0, 6 * s}, {2 * s, 0, 6 * s}, {0, 4 * s, 6 * s}};
  std::vector<TriangleIndices> triangles{{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                                         {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  for (TriangleIndices& triangle : triangles) {
    if (sign < 0) std::swap(triangle[1], triangle[2]);
  }
  return Mesh(vertices, triangles);
}

TEST(MassProperties, OfAPrismAreThoseOfTheFormulas) {
  const MassProperties m = mass_properties(prism(1), 10);
  EXPECT_NEAR(m.mass, 240, 1e-9);
  EXPECT_TRUE(m.centre.isApprox(Eigen::Vector3d(2.0 / 3, 4.0 / 3, 3), 1e-12));
  // About the centre of a right triangle: the integral of x^2 is area a^2 / 18, of xy -area ab
  // / 36.
  EXPECT_NEAR(m.inertia(0, 0), 240 * (16.0 / 18 + 36.0 / 12), 1e-9);
  EXPECT_NEAR(m.inertia(1, 1), 240 * (4.0 / 18 + 36.0 / 12), 1e-9);
  EXPECT_NEAR(m.inertia(2, 2), 240 * 20.0 / 18, 1e-9);
  EXPECT_NEAR(m.inertia(0, 1), 240 * 8.0 / 36, 1e-9);
  EXPECT_NEAR(m.inertia(0, 2), 0, 1e-9);
  EXPECT_TRUE((m.inertia * m.inverse_inertia).isIdentity(1e-12));
}

TEST(MassProperties, AMirroredMeshIsAsHeavy) {
  EXPECT_NEAR(mass_properties(prism(-1), 10).mass, 240, 1e-9);
}

TEST(Bin, IsClosedAndHoldsWhatItsWallsDo) {
  const BinSize size{.halvings = 1};
  const Mesh bin = make_bin(size);
  EXPECT_TRUE(bin.topology().is_closed);
  EXPECT_FALSE(self_intersects(bin));
  EXPECT_GT(mass_properties(bin, 1).mass, 0);
  EXPECT_DOUBLE_EQ(inner_radius(size, 0), size.floor_radius);
  EXPECT_DOUBLE_EQ(inner_radius(size, size.height), size.mouth_radius);
}

TEST(Gltf, HoldsEachMeshOnceAndTwoChannelsForEachBodyThatMoves) {
  const Mesh mesh = prism(1);
  Pose half_way = Pose::Identity();
  half_way.translation() = Eigen::Vector3d(1, 2, 3);
  half_way.linear() = Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const GltfBody moving{0, {Pose::Identity(), half_way, Pose::Identity()}};
  GltfScene scene{{{"prism", mesh, {1, 0, 0}}}, {moving, {0, {half_way}}, moving}, {0, 0.5, 1}};
  const tests::TemporaryDirectory directory;
  write_gltf(directory.path("scene.gltf"), scene);
  std::ifstream stream(directory.path("scene.gltf"));
  const nlohmann::json file = nlohmann::json::parse(stream);
  EXPECT_EQ(file["asset"]["version"], "2.0");
  EXPECT_EQ(file["meshes"].size(), 1u);
  EXPECT_EQ(file["nodes"].size(), 4u);  // and the one that turns the world
  ASSERT_EQ(file["animations"].size(), 1u);
  EXPECT_EQ(file["animations"][0]["channels"].size(), 4u);
  const std::size_t bytes = file["buffers"][0]["byteLength"];
  const std::string uri = file["buffers"][0]["uri"];
  EXPECT_EQ(uri.size() - uri.find(',') - 1, (bytes + 2) / 3 * 4);
  for (const auto& accessor : file["accessors"]) {
    const auto& view = file["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t width = accessor["type"] == "SCALAR" ? 1 : accessor["type"] == "VEC3" ? 3 : 4;
    EXPECT_EQ(view["byteLength"], 4 * width * accessor["count"].get<std::size_t>());
    EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(), bytes);
  }
  scene.bodies[0].poses.pop_back();
  EXPECT_THROW(write_gltf(directory.path("bad.gltf"), scene), InputError);
  EXPECT_THROW(write_gltf(directory.path("no/such/folder.gltf"), {}), Error);
}

}  // namespace
}  // namespace graze::samples
