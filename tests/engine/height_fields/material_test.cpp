// What is met is made of something: numbers of triangles and cells, in contacts and hits of rays.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/print.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/world.h>
#include <gtest/gtest.h>

#include <vector>

#include "tests/engine/height_fields/random_fields.h"
#include "tests/engine/world/random_shapes.h"
#include "tests/shapes/random_meshes.h"

namespace graze {
namespace {

using tests::FieldParts;
using tests::Ground;
using tests::random_pose;
using tests::random_shape;

// As before there were any: they take room that alignment left.
static_assert(sizeof(ShapeContact) == 128);

/// A field with a material for each cell, and its mesh with the same for both triangles.
struct Made {
  explicit Made(FieldParts parts, RandomSource& source) : Made(with_materials(parts, source)) {}
  explicit Made(const FieldParts& parts) : field(parts.field()), mesh(of_field(parts.field())) {}

  static FieldParts with_materials(FieldParts parts, RandomSource& source) {
    parts.materials.resize(std::size_t{parts.columns - 1} * (parts.rows - 1));
    for (std::uint8_t& material : parts.materials)
      material = static_cast<std::uint8_t>(source.integer(1, 255));
    return parts;
  }
  static Mesh of_field(const HeightField& field) {
    std::vector<std::uint16_t> materials;
    for (std::uint32_t r = 0; r + 1 < field.rows(); ++r) {
      for (std::uint32_t c = 0; c + 1 < field.columns(); ++c) {
        if (!field.is_hole(c, r)) materials.insert(materials.end(), 2, field.material(c, r));
      }
    }
    const Mesh bare = field.mesh();
    return Mesh(bare.vertices(), bare.triangles(), materials);
  }

  HeightField field;
  Mesh mesh;
};

TEST(Materials, TheMeshOfAFieldHasThoseOfItsCells) {
  RandomSource source(40);
  for (int n = 0; n < 20; ++n) {
    const Made made(tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source), source);
    const Mesh mesh = made.field.mesh();
    EXPECT_TRUE(std::equal(mesh.materials().begin(), mesh.materials().end(),
                           made.mesh.materials().begin(), made.mesh.materials().end()));
  }
  const std::vector<float> heights(4, 0);
  EXPECT_TRUE(HeightField(2, 2, heights).mesh().materials().empty());
}

TEST(Materials, ContactsHaveThoseOfTheNearestTriangle) {
  RandomSource source(41);
  int contacts = 0;
  for (int n = 0; n < 150; ++n) {
    const Made made(tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source), source);
    const tests::FieldTwins twins(made.field);
    const Shape field = made.field, mesh = made.mesh;
    const Pose pose = n % 2 == 0 ? Pose::Identity() : random_pose(3, source);
    for (const ShapeKind kind : kShapeKinds) {
      if (kind >= ShapeKind::Mesh) continue;
      const Shape shape = random_shape(kind, 0.7, source);
      const Pose at = pose_near(twins, pose, source);
      const double margin = n % 3 == 0 ? 0.1 : 0;
      const Manifold of_field = find_contacts({field, pose}, {shape, at}, {.margin = margin});
      const Manifold of_mesh = find_contacts({mesh, pose}, {shape, at}, {.margin = margin});
      const Manifold swapped = find_contacts({shape, at}, {field, pose}, {.margin = margin});
      ASSERT_EQ(of_field.size(), of_mesh.size());
      for (std::size_t i = 0; i < of_field.size(); ++i) {
        ++contacts;
        EXPECT_EQ(of_field[i].material_a, of_mesh[i].material_a) << n << name_of(kind);
        EXPECT_EQ(of_field[i].material_b, 0);
        EXPECT_EQ(swapped[i].material_b, of_field[i].material_a);
        EXPECT_EQ(swapped[i].material_a, 0);
        double least = HUGE_VAL;
        std::uint16_t wanted = 0;
        for (std::uint32_t t = 0; t < made.mesh.triangles().size(); ++t) {
          const Mesh alone(made.mesh.vertices(), made.mesh.triangles().subspan(t, 1));
          const double distance = nearest_point({alone, pose}, of_mesh[i].point_a).distance;
          if (distance < least) least = distance, wanted = made.mesh.materials()[t];
          if (made.mesh.triangles().size() > 400) break;  // by brute force only where it is cheap
        }
        if (made.mesh.triangles().size() > 400) continue;
        EXPECT_EQ(of_mesh[i].material_a, wanted) << n << name_of(kind);
      }
    }
  }
  EXPECT_GT(contacts, 500);
}

TEST(Materials, RaysHaveThoseOfTheirTriangle) {
  RandomSource source(42);
  int hits = 0;
  for (int n = 0; n < 200; ++n) {
    const Made made(tests::random_parts(static_cast<Ground>(n % tests::kGrounds), source), source);
    const Shape field = made.field, mesh = made.mesh;
    const Pose pose = n % 2 == 0 ? Pose::Identity() : random_pose(3, source);
    const Ray ray{pose * source.vector(0, 6), pose.linear() * source.vector(-1, 0)};
    const auto of_field = cast_ray({field, pose}, ray), of_mesh = cast_ray({mesh, pose}, ray);
    ASSERT_EQ(of_field.has_value(), of_mesh.has_value());
    if (!of_field) continue;
    ++hits;
    EXPECT_EQ(of_mesh->material, made.mesh.materials()[of_mesh->triangle]);
    EXPECT_EQ(of_field->material, of_mesh->material);
    EXPECT_EQ(cast_ray_all({made.mesh, pose}, ray)[0].material, of_mesh->material);
  }
  EXPECT_GT(hits, 30);
}

TEST(Materials, WorldsAndCompoundsCarryThem) {
  FieldParts parts;
  parts.columns = parts.rows = 5;
  parts.heights.assign(25, 0);
  parts.materials.assign(16, 9);
  parts.materials[5] = 4;
  const HeightField field = parts.field();
  Compound compound;
  compound.add({Box{{0.3, 0.3, 0.3}}});
  World world;
  world.add({field}, {.kind = BodyKind::Static});
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d(1.5, 1.5, 0.25);
  world.add({share(compound), pose});
  pose.translation() = Eigen::Vector3d(3.5, 3.5, 0.25);
  world.add({Sphere{{0, 0, 0}, 0.3}, pose}, {.margin = 0.1});
  const WorldUpdate update = world.update();
  ASSERT_EQ(update.contacts.size(), 2u);
  for (const ShapeContact& contact : update.contacts[0].manifold)
    EXPECT_EQ(contact.material_a, 4);
  EXPECT_EQ(update.contacts[1].manifold[0].material_a, 9);
  EXPECT_EQ(world.cast_ray({{1.5, 2.5, 1}, {0, 0, -1}})->hit.material, 9);
}

TEST(Materials, OfMeshesAreCountedAndKept) {
  const std::vector<Eigen::Vector3d> vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<TriangleIndices> triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_TRUE(Mesh(vertices, triangles).materials().empty());
  const std::vector<std::uint16_t> materials = {7, 65535};
  const Mesh mesh(vertices, triangles, materials);
  ASSERT_EQ(mesh.materials().size(), 2u);
  EXPECT_EQ(mesh.deformed(vertices).materials()[1], 65535);
  const std::vector<std::uint16_t> one = {7};
  try {
    const Mesh wrong(vertices, triangles, one);
    ADD_FAILURE() << "taken";
  } catch (const MeshError& error) {
    EXPECT_STREQ(error.what(), "1 materials for 2 triangles");
  }
  EXPECT_THROW(Mesh(vertices, triangles, std::vector<std::uint16_t>{}), MeshError);
}

}  // namespace
}  // namespace graze
