#pragma once

#include <graze/graze.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace examples {

/// Ends the program with exit code 1 if what it shows is not so.
inline void expect(bool is_so, const char* what) {
  if (is_so) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::exit(1);
}

inline graze::Pose at(double x, double y, double z) {
  graze::Pose pose = graze::Pose::Identity();
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

/// The cube from the origin to (edge, edge, edge), its triangles counter-clockwise from outside.
inline graze::Mesh cube(double edge) {
  std::vector<Eigen::Vector3d> vertices;
  for (int i = 0; i < 8; ++i)
    vertices.push_back(edge * Eigen::Vector3d(i & 1, i >> 1 & 1, i >> 2));
  const std::array<graze::TriangleIndices, 12> triangles{{{0, 2, 1},
                                                          {1, 2, 3},
                                                          {4, 5, 6},
                                                          {5, 7, 6},
                                                          {0, 1, 4},
                                                          {1, 5, 4},
                                                          {2, 6, 3},
                                                          {3, 6, 7},
                                                          {0, 4, 2},
                                                          {2, 4, 6},
                                                          {1, 3, 5},
                                                          {3, 7, 5}}};
  return {vertices, triangles};
}

}  // namespace examples
