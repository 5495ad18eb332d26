#include "tests/shapes/formula_meshes.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace graze::tests {
namespace {

using Vertices = std::vector<Eigen::Vector3d>;
using Triangles = std::vector<TriangleIndices>;

void add_quad(Triangles& triangles, std::uint32_t a, std::uint32_t b, std::uint32_t c,
              std::uint32_t d) {
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

double turn(int part, int parts) {
  return 2 * std::numbers::pi * part / parts;
}

}  // namespace

Mesh make_box(const Eigen::Vector3d& half_extents) {
  Vertices vertices;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    vertices.push_back(half_extents.cwiseProduct(signs));
  }
  Triangles triangles;
  add_quad(triangles, 0, 4, 6, 2);
  add_quad(triangles, 1, 3, 7, 5);
  add_quad(triangles, 0, 1, 5, 4);
  add_quad(triangles, 2, 6, 7, 3);
  add_quad(triangles, 0, 2, 3, 1);
  add_quad(triangles, 4, 5, 7, 6);
  return Mesh(vertices, triangles);
}

Mesh make_sphere(double radius, int rings, int sectors) {
  Vertices vertices = {{0, 0, radius}};
  for (int i = 1; i <= rings; ++i) {
    const double polar = std::numbers::pi * i / (rings + 1);
    for (int k = 0; k < sectors; ++k) {
      const double s = radius * std::sin(polar);
      vertices.emplace_back(s * std::cos(turn(k, sectors)), s * std::sin(turn(k, sectors)),
                            radius * std::cos(polar));
    }
  }
  vertices.emplace_back(0, 0, -radius);
  const auto at = [&](int ring, int sector) {
    return static_cast<std::uint32_t>(1 + ring * sectors + sector % sectors);
  };
  const auto south = static_cast<std::uint32_t>(vertices.size() - 1);
  Triangles triangles;
  for (int k = 0; k < sectors; ++k)
    triangles.push_back({0, at(0, k), at(0, k + 1)});
  for (int i = 0; i + 1 < rings; ++i) {
    for (int k = 0; k < sectors; ++k) {
      add_quad(triangles, at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
    }
  }
  for (int k = 0; k < sectors; ++k) {
    triangles.push_back({south, at(rings - 1, k + 1), at(rings - 1, k)});
  }
  return Mesh(vertices, triangles);
}

Mesh make_torus(double radius, double tube_radius, int sectors, int tube_sectors) {
  Vertices vertices;
  for (int i = 0; i < sectors; ++i) {
    for (int k = 0; k < tube_sectors; ++k) {
      const double r = radius + tube_radius * std::cos(turn(k, tube_sectors));
      vertices.emplace_back(r * std::cos(turn(i, sectors)), r * std::sin(turn(i, sectors)),
                            tube_radius * std::sin(turn(k, tube_sectors)));
    }
  }
  const auto at = [&](int sector, int tube_sector) {
    return static_cast<std::uint32_t>((sector % sectors) * tube_sectors +
                                      tube_sector % tube_sectors);
  };
  Triangles triangles;
  for (int i = 0; i < sectors; ++i) {
    for (int k = 0; k < tube_sectors; ++k) {
      add_quad(triangles, at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
    }
  }
  return Mesh(vertices, triangles);
}

Mesh make_row(int count) {
  Vertices vertices;
  Triangles triangles;
  for (int i = 0; i < count; ++i) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.emplace_back(10 * i, 0, 0);
    vertices.emplace_back(10 * i + 1, 0, 0);
    vertices.emplace_back(10 * i, 1, 0);
    triangles.push_back({first, first + 1, first + 2});
  }
  return Mesh(vertices, triangles);
}

}  // namespace graze::tests
