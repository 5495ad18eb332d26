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

/// A matrix of any size and strides. It is not copied unless its storage order is another.
template <typename Scalar>
using MatrixView = Eigen::Ref<const Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>, 0,
                              Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>>;

/// Says what the triangles of a mesh form once bit-equal positions are welded into one vertex.
struct Topology {
  std::uint32_t welded_vertices = 0;       ///< distinct positions that triangles use
  std::uint32_t components = 0;            ///< sets of triangles connected through welded vertices
  std::uint32_t degenerate_triangles = 0;  ///< triangles of exactly zero area
  std::uint32_t duplicate_triangles = 0;   ///< triangles with the same welded vertices as an
                                           ///< earlier one
  std::uint64_t boundary_edges = 0;        ///< welded edges with an odd number of triangles
  bool is_closed = false;                  ///< true if every welded edge has an even number of
                                           ///< triangles

  bool operator==(const Topology&) const = default;
};

/// An immutable triangle mesh in metres. A copy is a cheap handle to the same data and shares its
/// tree, which is built when a query first walks it. A mesh may be used from many threads at once.
class Mesh {
 public:
  /// Copies both arrays, in linear time. Throws MeshError, naming the element, for a coordinate
  /// that is not finite, an index out of range, no triangles, or more than 2^31 - 1 of either.
  /// Degenerate and duplicate triangles are accepted, and counted by topology().
  Mesh(std::span<const Eigen::Vector3d> vertices, std::span<const TriangleIndices> triangles);
  Mesh(std::span<const Eigen::Vector3d> vertices, std::span<const Eigen::Vector3i> triangles);

  /// Copies both arrays, and with them what each triangle is made of: numbers for the user, which
  /// contacts of shapes and hits of rays carry. Throws MeshError, too, for another number of
  /// materials than of triangles. Materials take two bytes a triangle, and a search for the
  /// triangle at each contact; a mesh without them costs nothing for them.
  Mesh(std::span<const Eigen::Vector3d> vertices, std::span<const TriangleIndices> triangles,
       std::span<const std::uint16_t> materials);

  /// Copies matrices of three columns, a vertex or a triangle in each row, in any storage order, as
  /// libigl and others keep them. Throws MeshError, too, for another number of columns.
  Mesh(const MatrixView<double>& vertices, const MatrixView<int>& triangles);

  /// Returns the mesh with its vertices elsewhere: there are as many, in the same order, between
  /// the same triangles, whose indices both meshes share. What has been built of this mesh's trees
  /// is fitted to the new positions when a query first walks it, a fraction of the time that
  /// building takes, except for parts whose boxes have grown into each other, which are built anew:
  /// answers are those of Mesh(vertices, triangles()), and take about as long. It copies
  /// `vertices`, and holds on to no other part of this mesh than what it still has to fit. It may
  /// be called beside queries on this mesh, and takes linear time. Throws MeshError for another
  /// number of vertices, or a coordinate that is not finite.
  Mesh deformed(std::span<const Eigen::Vector3d> vertices) const;
  Mesh deformed(const MatrixView<double>& vertices) const;

  /// Returns the vertices and the triangles as they were given to the constructor, in that order.
  std::span<const Eigen::Vector3d> vertices() const;
  std::span<const TriangleIndices> triangles() const;

  /// Returns what triangles are made of, as it was given; empty if it was not.
  std::span<const std::uint16_t> materials() const;

  /// Returns the vertices as a matrix of three columns, without a copy. It is valid as long as a
  /// handle is.
  Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> vertex_matrix() const;
  /// Returns the triangles as such a matrix, valid as long.
  Eigen::Map<const Eigen::Matrix<std::uint32_t, Eigen::Dynamic, 3, Eigen::RowMajor>>
  triangle_matrix() const;

  /// Returns the corners of triangle `index`, which must be below triangles().size().
  Triangle triangle(std::size_t index) const;

  /// Returns the smallest box around the vertices that triangles use, exactly.
  const Aabb& bounds() const;

  /// Returns counts of what the triangles form. They are made when first asked for, in O(n log n),
  /// and then kept.
  const Topology& topology() const;

  /// Returns one vertex of each of topology()'s components, ascending. They are known as soon as
  /// topology() is.
  std::span<const std::uint32_t> component_vertices() const;

  /// Returns for each vertex the lowest index of a vertex in the same position. The indices are
  /// computed when first asked for, in O(n log n).
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
