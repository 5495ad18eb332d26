#pragma once

// What the handles of one mesh share. Private to engine/mesh.

#include <graze/engine/mesh/mesh.h>
#include <mutex>
#include <vector>

namespace graze {

struct Mesh::Data {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  Aabb bounds;
};

}  // namespace graze
