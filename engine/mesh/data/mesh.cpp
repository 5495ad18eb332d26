#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/engine/mesh/mesh.h>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace graze {
namespace {

constexpr std::size_t kMaxElements = 0x7fffffff;

void check_vertices(std::span<const Eigen::Vector3d> vertices) {
  if (vertices.size() > kMaxElements) throw MeshError("more than 2^31 - 1 vertices");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const double* p = vertices[i].data();
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
      throw MeshError("vertex " + std::to_string(i) + ": a coordinate is not finite",
                      {.element = "vertex", .index = i});
    }
  }
}

/// Copies the indices, which may be signed, once each of them is known to name a vertex.
template <typename Indices>
std::vector<TriangleIndices> checked_triangles(std::span<const Indices> triangles,
                                               std::size_t vertex_count) {
  if (triangles.empty()) throw MeshError("no triangles");
  if (triangles.size() > kMaxElements) throw MeshError("more than 2^31 - 1 triangles");
  std::vector<TriangleIndices> checked(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const auto index = triangles[i][k];
      if (std::cmp_less(index, 0) || std::cmp_greater_equal(index, vertex_count)) {
        throw MeshError("triangle " + std::to_string(i) + ": index " + std::to_string(index) +
                            " is out of range, there are " + std::to_string(vertex_count) +
                            " vertices",
                        {.element = "triangle", .index = i});
      }
      checked[i][k] = static_cast<std::uint32_t>(index);
    }
  }
  return checked;
}

Aabb bounds_of(std::span<const Eigen::Vector3d> vertices,
               std::span<const TriangleIndices> triangles) {
  // There is a box for each corner: with one alone every step would wait for the one before.
  const Eigen::Vector3d& any = vertices[triangles[0][0]];
  Aabb boxes[3] = {{any, any}, {any, any}, {any, any}};
  for (const TriangleIndices& triangle : triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double* p = vertices[triangle[c]].data();
      for (int k = 0; k < 3; ++k) {
        boxes[c].min.data()[k] = std::min(boxes[c].min.data()[k], p[k]);
        boxes[c].max.data()[k] = std::max(boxes[c].max.data()[k], p[k]);
      }
    }
  }
  return {boxes[0].min.cwiseMin(boxes[1].min).cwiseMin(boxes[2].min),
          boxes[0].max.cwiseMax(boxes[1].max).cwiseMax(boxes[2].max)};
}

}  // namespace

template <typename Indices>
std::shared_ptr<const Mesh::Data> Mesh::make(std::span<const Eigen::Vector3d> vertices,
                                             std::span<const Indices> triangles) {
  return bvh::in_standard_arithmetic([&]() -> std::shared_ptr<const Mesh::Data> {
    check_vertices(vertices);
    auto data = std::make_shared<Data>();
    data->shared_triangles = std::make_shared<const std::vector<TriangleIndices>>(
        checked_triangles(triangles, vertices.size()));
    data->triangles = *data->shared_triangles;
    data->vertices.assign(vertices.begin(), vertices.end());
    data->bounds = bounds_of(data->vertices, data->triangles);
    data->ball = ball_around(data->vertices, data->bounds);
    return data;
  });
}

Mesh::Mesh(std::span<const Eigen::Vector3d> vertices, std::span<const TriangleIndices> triangles)
    : data_(make(vertices, triangles)) {}

Mesh::Mesh(std::span<const Eigen::Vector3d> vertices, std::span<const Eigen::Vector3i> triangles)
    : data_(make(vertices, triangles)) {}

Mesh::Mesh(std::span<const Eigen::Vector3d> vertices, std::span<const TriangleIndices> triangles,
           std::span<const std::uint16_t> materials) {
  const std::shared_ptr<const Data> bare = make(vertices, triangles);
  if (materials.size() != triangles.size()) {
    throw MeshError(std::to_string(materials.size()) + " materials for " +
                    std::to_string(triangles.size()) + " triangles");
  }
  auto data = std::make_shared<Data>();
  data->shared_triangles = bare->shared_triangles;
  data->triangles = bare->triangles;
  data->vertices = bare->vertices;
  data->bounds = bare->bounds;
  data->ball = bare->ball;
  data->materials =
      std::make_shared<const std::vector<std::uint16_t>>(materials.begin(), materials.end());
  data_ = std::move(data);
}

std::span<const std::uint16_t> Mesh::materials() const {
  return data_->materials == nullptr ? std::span<const std::uint16_t>() : *data_->materials;
}

namespace {

void check_columns(Eigen::Index columns, const char* what) {
  if (columns == 3) return;
  throw MeshError(std::string(what) + ": a matrix of " + std::to_string(columns) +
                  " columns, not 3");
}

std::vector<Eigen::Vector3d> rows_of(const MatrixView<double>& vertices) {
  check_columns(vertices.cols(), "vertices");
  std::vector<Eigen::Vector3d> rows(static_cast<std::size_t>(vertices.rows()));
  for (Eigen::Index i = 0; i < vertices.rows(); ++i)
    rows[static_cast<std::size_t>(i)] = vertices.row(i).transpose();
  return rows;
}

std::vector<Eigen::Vector3i> rows_of(const MatrixView<int>& triangles) {
  check_columns(triangles.cols(), "triangles");
  std::vector<Eigen::Vector3i> rows(static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index i = 0; i < triangles.rows(); ++i)
    rows[static_cast<std::size_t>(i)] = triangles.row(i).transpose();
  return rows;
}

}  // namespace

Mesh::Mesh(const MatrixView<double>& vertices, const MatrixView<int>& triangles)
    : Mesh(rows_of(vertices), rows_of(triangles)) {}

Mesh Mesh::deformed(const MatrixView<double>& vertices) const {
  return deformed(rows_of(vertices));
}

Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> Mesh::vertex_matrix()
    const {
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
  return {data_->vertices.data()->data(), static_cast<Eigen::Index>(data_->vertices.size()), 3};
}

Eigen::Map<const Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>>
Mesh::triangle_matrix() const {
  static_assert(sizeof(TriangleIndices) == 3 * sizeof(std::uint32_t));
  return {data_->triangles.data()->data(), static_cast<Eigen::Index>(data_->triangles.size()), 3};
}

Mesh Mesh::deformed(std::span<const Eigen::Vector3d> vertices) const {
  return bvh::in_standard_arithmetic([&]() -> Mesh {
    if (vertices.size() != data_->vertices.size()) {
      throw MeshError("deformed: " + std::to_string(vertices.size()) + " vertices for a mesh of " +
                      std::to_string(data_->vertices.size()));
    }
    check_vertices(vertices);
    auto data = std::make_shared<Data>();
    data->shared_triangles = data_->shared_triangles;
    data->triangles = data_->triangles;
    data->materials = data_->materials;
    data->vertices.assign(vertices.begin(), vertices.end());
    data->bounds = bounds_of(data->vertices, data->triangles);
    data->ball = ball_around(data->vertices, data->bounds);
    data->older_tree.set(data_->tree_to_inherit());
    data->older_wide.set(data_->wide_to_inherit());
    return Mesh(std::move(data));
  });
}

std::span<const Eigen::Vector3d> Mesh::vertices() const {
  return data_->vertices;
}

std::span<const TriangleIndices> Mesh::triangles() const {
  return data_->triangles;
}

Triangle Mesh::triangle(std::size_t index) const {
  const TriangleIndices& t = data_->triangles[index];
  return {data_->vertices[t[0]], data_->vertices[t[1]], data_->vertices[t[2]]};
}

const Aabb& Mesh::bounds() const {
  return data_->bounds;
}

}  // namespace graze
