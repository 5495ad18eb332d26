#include "data/generator/parts/geodesic.h"

#include <Eigen/Geometry>
#include <cmath>

#include "data/generator/dice.h"

namespace graze::generator {
namespace {

using Eigen::Vector3d;

struct Face {
  Vector3d a, b, c;
};

std::vector<Vector3d> icosahedron_corners() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vector3d> corners;
  for (double p : {1.0, -1.0}) {
    for (double q : {golden, -golden}) {
      corners.insert(corners.end(), {{0, p, q}, {p, q, 0}, {q, 0, p}});
    }
  }
  return corners;
}

// Edges of this icosahedron have length 2, other distances of corners are above 3.
bool is_edge(const Vector3d& p, const Vector3d& q) {
  return squared_length(p - q) < 5;
}

bool is_counter_clockwise(const Vector3d& p, const Vector3d& q, const Vector3d& r) {
  return p.dot(q.cross(r)) > 0;
}

std::vector<Face> icosahedron_faces() {
  const std::vector<Vector3d> corners = icosahedron_corners();
  std::vector<Face> faces;
  for (auto p = corners.begin(); p != corners.end(); ++p) {
    for (auto q = p + 1; q != corners.end(); ++q) {
      for (auto r = q + 1; r != corners.end(); ++r) {
        if (!is_edge(*p, *q) || !is_edge(*q, *r) || !is_edge(*r, *p)) continue;
        faces.push_back(is_counter_clockwise(*p, *q, *r) ? Face{*p, *q, *r} : Face{*p, *r, *q});
      }
    }
  }
  return faces;
}

// Faces that share an edge compute equal points on it: with one weight zero, the sum has two terms,
// whose order does not matter.
Vector3d on_sphere(const Face& face, double weight_a, double weight_b, double weight_c) {
  const Vector3d p = weight_a * face.a + weight_b * face.b + weight_c * face.c;
  return p / std::sqrt(squared_length(p));
}

}  // namespace

Surface make_geodesic_sphere(int frequency) {
  Surface surface;
  for (const Face& face : icosahedron_faces()) {
    const auto vertex = [&](int i, int j) {
      return surface.vertex(on_sphere(face, frequency - i - j, i, j));
    };
    for (int i = 0; i < frequency; ++i) {
      for (int j = 0; i + j < frequency; ++j) {
        // One at a time: in which order arguments are computed is up to the compiler.
        const std::uint32_t a = vertex(i, j);
        const std::uint32_t b = vertex(i + 1, j);
        const std::uint32_t c = vertex(i, j + 1);
        surface.triangle(a, b, c);
        if (i + j + 1 < frequency) surface.triangle(b, vertex(i + 1, j + 1), c);
      }
    }
  }
  return surface;
}

}  // namespace graze::generator
