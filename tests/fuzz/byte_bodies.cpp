#include "tests/fuzz/byte_bodies.h"

#include <graze/engine/world/shape_bounds.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace graze::fuzz {

double length(ByteShapes& bytes) {
  const int choice = bytes.byte();
  if (choice % 8 == 7) return bytes.coordinate();
  return (1 + choice % 8) * 0.125;
}

Mesh mesh(ByteShapes& bytes) {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  for (int count = bytes.byte() % 4; count >= 0; --count) {
    const Triangle t = bytes.triangle();
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {t.a, t.b, t.c});
    triangles.push_back({first, first + 1, first + 2});
  }
  return Mesh(vertices, triangles);
}

Shape shape(ByteShapes& bytes) {
  switch (bytes.byte() % 9) {
    case 0:
      return Sphere{{0, 0, 0}, length(bytes)};
    case 1: {
      const double x = length(bytes), y = length(bytes);
      return Box{{x, y, length(bytes)}};
    }
    case 2: {
      const double radius = length(bytes);
      return Capsule{radius, length(bytes)};
    }
    case 3: {
      const double radius = length(bytes);
      return Cylinder{radius, length(bytes)};
    }
    case 4: {
      const double radius = length(bytes);
      return Cone{radius, length(bytes)};
    }
    case 5: {
      const double x = length(bytes), y = length(bytes);
      return Ellipsoid{{0, 0, 0}, {x, y, length(bytes)}};
    }
    case 6: {
      const Triangle s = bytes.triangle(), t = bytes.triangle();
      return ConvexHull(std::vector<Eigen::Vector3d>{s.a, s.b, s.c, t.a, t.b, t.c});
    }
    case 7: {
      const Triangle t = bytes.triangle();
      return HalfSpace{t.a, t.b.x()};
    }
    default:
      return mesh(bytes);
  }
}

void fail_if(bool is_wrong, const char* what) {
  if (!is_wrong) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

bool is_ordinary(const PlacedShapeView& shape) {
  constexpr double kMost = 1000;
  if (shape.pose.translation().cwiseAbs().maxCoeff() > kMost) return false;
  if (const auto* plane = shape.shape.as<HalfSpace>()) return std::abs(plane->offset) < kMost;
  const Aabb box = bounding_aabb(shape);
  return box.min.cwiseAbs().maxCoeff() < kMost && box.max.cwiseAbs().maxCoeff() < kMost;
}

}  // namespace graze::fuzz
