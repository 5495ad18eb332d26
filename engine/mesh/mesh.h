#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include <graze/bvh/aabb.h>
#include <graze/bvh/error.h>
#include <graze/narrowphase/triangle.h>
#include <Eigen/Core>

namespace graze {

/// Three indices into the vertices of a mesh.
using TriangleIndices = std::array<std::uint32_t, 3>;

/// A matrix of any size and strides, not copied unless its storage order is another.
template <typename Scalar>
using MatrixView = Eigen::Ref<const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>, 0,
                              Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>;

/// What the triangles of a mesh form once bit-equal positions are welded into one vertex.
struct Topology {
  std::uint32_t welded_vertices = 0;       ///< distinct positions that triangles use
  std::uint32_t components = 0;            ///< sets of triangles connected through welded vertices
  std::uint32_t degenerate_triangles = 0;  ///< triangles of exactly zero area
  std::uint32_t duplicate_triangles = 0;   ///< with the same welded vertices as an earlier one
  std::uint64_t boundary_edges = 0;        ///< welded edges with an odd number of triangles
  bool is_closed = false;                  ///< every welded edge has an even number of triangles

  bool operator==(const Topology&) const = default;
};

/// An immutable triangle mesh in metres. A copy is a handle to the same data: cheap, and sharing
/// the tree, which is built when a query first walks it. Safe to use from many threads at once.
class Mesh {
 public:
  /// Copies both arrays. Throws MeshError, naming the element, for a coordinate that is not finite,
  /// an index out of range, no triangles, or more than 2^31 - 1 of either. Degenerate and duplicate
  /// triangles are accepted, and counted by topology(). Linear time.
  Mesh(std::span<const Eigen::Vector3d> vertices, std::span<const TriangleIndices> triangles);
  Mesh(std::span<const Eigen::Vector3d> vertices, std::span<const Eigen::Vector3i> triangles);

  /// The same with what each triangle is made of: numbers for the user, which contacts of shapes
  /// and hits of rays carry. Throws MeshError, too, for another number of them. A mesh without
  /// costs what it did; one with takes two bytes a triangle, and a search for the triangle at each
  /// contact.
  Mesh(std::span<const Eigen::Vector3d> vertices, std::span<const TriangleIndices> triangles,
       std::span<const std::uint16_t> materials);

  /// The same from matrices of three columns, a vertex or a triangle each row, as libigl and others
  /// keep them, in any storage order. Throws MeshError for another number of columns.
  Mesh(const MatrixView<double>& vertices, const MatrixView<int>& triangles);

  /// The mesh with its vertices elsewhere: as many, in the same order, between the same triangles,
  /// whose indices both meshes share. What has been built of this mesh's trees is fitted to the new
  /// positions when a query first walks it, a fraction of the time that building takes, except for
  /// parts whose boxes have grown into each other, which are built anew: answers are those of
  /// Mesh(vertices, triangles()), and take about as long. Copies `vertices`; holds on to no other
  /// part of this mesh than what it still has to fit. Safe beside queries on this mesh. Throws
  /// MeshError for another number of vertices, or a coordinate that is not finite. Linear time.
  Mesh deformed(std::span<const Eigen::Vector3d> vertices) const;
  Mesh deformed(const MatrixView<double>& vertices) const;

  /// As they were given to the constructor, in that order.
  std::span<const Eigen::Vector3d> vertices() const;
  std::span<const TriangleIndices> triangles() const;

  /// What triangles are made of, as it was given; empty if it was not.
  std::span<const std::uint16_t> materials() const;

  /// The vertices as a matrix of three columns, without a copy: valid as long as a handle.
  Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> vertex_matrix() const;
  /// The triangles as such a matrix, valid as long.
  Eigen::Map<const Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>>
  triangle_matrix() const;

  /// The corners of triangle `index`, which must be below triangles().size().
  Triangle triangle(std::size_t index) const;

  /// The smallest box around the vertices that triangles use, exactly.
  const Aabb& bounds() const;

  /// Counted when first asked for, then kept. O(n log n).
  const Topology& topology() const;

  /// One vertex of each of topology()'s components, ascending. Known with it.
  std::span<const std::uint32_t> component_vertices() const;

  /// For each vertex the lowest index of a vertex in the same position. Computed when first asked
  /// for, O(n log n).
  std::span<const std::uint32_t> welded() const;

  /// True if both are handles to the same mesh.
  friend bool operator==(const Mesh& mesh_a, const Mesh& mesh_b) {
    return mesh_a.data_ == mesh_b.data_;
  }

 private:
  friend struct MeshAccess;
  struct Data;
  explicit Mesh(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  template <typename Indices>
  static std::shared_ptr<const Data> make(std::span<const Eigen::Vector3d> vertices,
                                          std::span<const Indices> triangles);

  std::shared_ptr<const Data> data_;
};

}  // namespace graze
