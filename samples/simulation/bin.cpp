#include "samples/simulation/bin.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace graze::samples {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Makes four triangles of each one, between the middles of its edges.
std::vector<TriangleIndices> halved(const std::vector<TriangleIndices>& triangles,
                                    std::vector<Eigen::Vector3d>& vertices) {
  std::map<Edge, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t i, std::uint32_t j) {
    const auto next = static_cast<std::uint32_t>(vertices.size());
    const auto [found, is_new] = middles.try_emplace(std::minmax(i, j), next);
    if (is_new) vertices.emplace_back(0.5 * (vertices[i] + vertices[j]));
    return found->second;
  };
  std::vector<TriangleIndices> result;
  for (const auto& [a, b, c] : triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    for (const TriangleIndices& part :
         {TriangleIndices{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      result.push_back(part);
    }
  }
  return result;
}

}  // namespace

Mesh make_bin(const BinSize& size) {
  // Rings go from the middle of the floor over the rim to the middle below, with the two middles.
  const struct {
    double radius, z;
  } rings[] = {{size.floor_radius, 0},
               {size.mouth_radius, size.height},
               {size.mouth_radius + size.thickness, size.height},
               {size.floor_radius + size.thickness, -size.thickness}};
  constexpr std::uint32_t kRings = 4;
  const auto sides = static_cast<std::uint32_t>(size.sides);
  std::vector<Eigen::Vector3d> vertices;
  for (const auto& ring : rings) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * 3.14159265358979323846 * i / sides;
      vertices.emplace_back(ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.z);
    }
  }
  const auto floor = static_cast<std::uint32_t>(vertices.size());
  vertices.emplace_back(0, 0, 0);
  vertices.emplace_back(0, 0, -size.thickness);
  std::vector<TriangleIndices> triangles;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    triangles.push_back({floor, i, next});
    for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring) {
      const std::uint32_t low = ring * sides;
      const std::uint32_t high = low + sides;
      triangles.push_back({low + i, high + i, low + next});
      triangles.push_back({low + next, high + i, high + next});
    }
    const std::uint32_t last = (kRings - 1) * sides;
    triangles.push_back({last + i, floor + 1, last + next});
  }
  for (int i = 0; i < size.halvings; ++i)
    triangles = halved(triangles, vertices);
  return Mesh(vertices, triangles);
}

double inner_radius(const BinSize& size, double z) {
  const double share = std::clamp(z / size.height, 0.0, 1.0);
  return size.floor_radius + share * (size.mouth_radius - size.floor_radius);
}

}  // namespace graze::samples
