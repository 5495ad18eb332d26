#pragma once

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/polygon.h>
#include <graze/engine/mesh/mesh.h>
#include <cstdint>
#include <optional>
#include <vector>

namespace graze::mesh_io {

/// The result of a reader: the arrays of a Mesh, whose constructor has the last word on them.
struct MeshArrays {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<TriangleIndices> triangles;
  std::vector<Place> places;  ///< the place in the file of each triangle's polygon, if they are
                              ///< asked for
};

/// Says what a reader is asked for.
struct ReadSettings {
  bool has_places = false;  ///< whether MeshArrays::places is wanted: sixteen bytes more for each
                            ///< triangle
};

/// Says how a format counts vertices.
struct IndexRules {
  std::int64_t first = 0;                   ///< the index of the first vertex
  std::optional<std::uint64_t> total = {};  ///< the number of vertices, if the file says it
};

/// Gathers vertices and polygons in the order of the file, checks indices and cuts polygons into
/// triangles. A polygon may name vertices that come later.
class MeshBuilder {
 public:
  MeshBuilder(const Source& source, IndexRules rules, const ReadSettings& settings)
      : source_(source), rules_(rules), settings_(settings) {}

  /// Make room for what the file claims; the caller bounds it by what the file can hold.
  void reserve_vertices(std::uint64_t count) { arrays_.vertices.reserve(count); }
  void reserve_triangles(std::uint64_t count) { arrays_.triangles.reserve(count); }

  void add_vertex(double x, double y, double z) { arrays_.vertices.emplace_back(x, y, z); }
  std::size_t vertex_count() const { return arrays_.vertices.size(); }

  void begin_polygon() { corners_.clear(); }

  /// Adds the next corner, by the file's own index. Fails at `place` for one that no vertex can
  /// have.
  void add_corner(std::int64_t index, Place place);

  /// Fails at `place` if the polygon has less than 3 corners.
  void end_polygon(Place place);

  /// Returns the arrays. Fails for the first corner that names no vertex.
  MeshArrays finish();

 private:
  /// A polygon that names vertices to come: its triangles are written when all are known.
  struct Waiting {
    std::size_t first_corner;  ///< index into waiting_corners_
    std::size_t corner_count;
    std::size_t first_triangle;
    Place place;
  };

  [[noreturn]] void fail_out_of_range(std::int64_t index, Place place, std::uint64_t total) const;
  void check_waiting(const Waiting& polygon) const;

  Source source_;
  IndexRules rules_;
  ReadSettings settings_;
  MeshArrays arrays_;
  Triangulator triangulator_;
  std::vector<std::uint32_t> corners_;  ///< the corners of the polygon that is being read, counted
                                        ///< from 0
  std::vector<std::uint32_t> waiting_corners_;
  std::vector<Waiting> waiting_;
};

}  // namespace graze::mesh_io
