// The sign of an enclosed volume, beside the volume in rational numbers.

#include <graze/engine/mesh/health/volume_sign.h>
#include <gtest/gtest.h>

#include <gmpxx.h>
#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "tests/shapes/formula_meshes.h"
#include "tests/shapes/random_source.h"

namespace graze {
namespace {

int sign_in_rationals(const Mesh& mesh) {
  mpq_class sum;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = mesh.triangle(i);
    std::array<mpq_class, 3> a, b, c;
    for (int k = 0; k < 3; ++k)
      a[k] = t.a[k], b[k] = t.b[k], c[k] = t.c[k];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sgn(sum);
}

int sign_of(const Mesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles().size());
  std::iota(all.begin(), all.end(), 0u);
  return static_cast<int>(volume_sign(mesh, all));
}

/// Its inside out.
Mesh turned(const Mesh& mesh) {
  std::vector<TriangleIndices> triangles(mesh.triangles().begin(), mesh.triangles().end());
  for (TriangleIndices& triangle : triangles)
    std::swap(triangle[1], triangle[2]);
  return {mesh.vertices(), triangles};
}

/// A closed surface with the vertices at random: of a tetrahedron, or of an octahedron that may
/// cross itself.
Mesh random_closed(RandomSource& source, bool is_on_lattice, double scale) {
  const bool is_octahedron = source.integer(0, 1) == 0;
  std::vector<Eigen::Vector3d> vertices;
  for (int i = 0; i < (is_octahedron ? 6 : 4); ++i)
    vertices.push_back(scale *
                       (is_on_lattice ? source.lattice_point(-1, 1) : source.vector(-1, 1)));
  if (!is_octahedron) {
    const std::vector<TriangleIndices> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return {vertices, faces};
  }
  std::vector<TriangleIndices> faces;
  for (std::uint32_t i = 0; i < 4; ++i) {
    faces.push_back({i, (i + 1) % 4, 4});
    faces.push_back({(i + 1) % 4, i, 5});
  }
  return {vertices, faces};
}

TEST(VolumeSign, IsThatOfRationalNumbers) {
  RandomSource source(7);
  std::array<int, 3> seen{};
  for (int n = 0; n < 3000; ++n) {
    constexpr std::array kScales{1.0, 0x1p-340, 0x1p+330, 1e-308, 1e307, 0.1};
    const Mesh mesh = random_closed(source, n % 2 == 0, kScales[static_cast<std::size_t>(n) % 6]);
    const int sign = sign_in_rationals(mesh);
    EXPECT_EQ(sign_of(mesh), sign) << n;
    EXPECT_EQ(sign_of(turned(mesh)), -sign) << n;
    ++seen[static_cast<std::size_t>(sign + 1)];
  }
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), 300);
}

// Products of two differences are lost before they meet a large third.
TEST(VolumeSign, OfWhatUnderflowsBesideWhatIsLarge) {
  const double l = 0x1p600, w = 0x1p-540, s = 0x1p-200;
  const std::vector<Eigen::Vector3d> vertices = {{0, 0, 0},  {l, 0, 0},  {0, w, 0}, {0, 0, w},
                                                 {-s, 0, 0}, {-s, 0, s}, {-s, s, 0}};
  const std::vector<TriangleIndices> triangles = {{0, 1, 3}, {0, 2, 1}, {1, 2, 3}, {0, 3, 6},
                                                  {0, 6, 4}, {2, 0, 4}, {2, 4, 5}, {3, 2, 5},
                                                  {3, 5, 6}, {4, 6, 5}};
  const Mesh mesh(vertices, triangles);
  EXPECT_EQ(sign_of(mesh), 1);
  EXPECT_EQ(sign_of(mesh), sign_in_rationals(mesh));
  EXPECT_EQ(sign_of(turned(mesh)), -1);
}

// A sheet of two sides that are apart by one unit in the last place, far from the origin: rounded
// sums say nothing.
TEST(VolumeSign, OfWhatIsThinAndFarAway) {
  const Mesh sphere = tests::make_sphere(1, 8, 8);
  for (const double thickness : {0x1p-22, 0.0, -0x1p-22}) {
    std::vector<Eigen::Vector3d> vertices(sphere.vertices().begin(), sphere.vertices().end());
    for (Eigen::Vector3d& vertex : vertices) {
      vertex.z() = 1e9 + (vertex.z() > 0 ? thickness : 0.0);
      vertex.x() += 1e9 / 3;
    }
    const Mesh sheet(vertices, sphere.triangles());
    EXPECT_EQ(sign_of(sheet), sign_in_rationals(sheet)) << thickness;
  }
}

}  // namespace
}  // namespace graze
