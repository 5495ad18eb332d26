#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/data/mesh_data.h>
#include <graze/narrowphase/triangle_pair/adjacent_triangles.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace graze {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Returns for each vertex the lowest index among those in its position. Positions are compared as
/// numbers: -0 and 0 are one.
std::vector<std::uint32_t> weld(const std::vector<Eigen::Vector3d>& vertices) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto position = [&](std::uint32_t i) { return vertices[i].data(); };
  const auto is_same = [&](std::uint32_t i, std::uint32_t j) {
    return std::equal(position(i), position(i) + 3, position(j));
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    if (is_same(i, j)) return i < j;
    return std::lexicographical_compare(position(i), position(i) + 3, position(j), position(j) + 3);
  });
  std::vector<std::uint32_t> welded(vertices.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_repeat = k > 0 && is_same(order[k], order[k - 1]);
    welded[order[k]] = is_repeat ? welded[order[k - 1]] : order[k];
  }
  return welded;
}

/// Sets of vertices that triangles connect.
class Components {
 public:
  explicit Components(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  void join(std::uint32_t i, std::uint32_t j) { parent_[root(i)] = root(j); }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

std::uint64_t count_odd(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end());
  std::uint64_t odd = 0;
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last = std::upper_bound(first, edges.end(), *first);
    odd += static_cast<std::uint64_t>(last - first) % 2;
    first = last;
  }
  return odd;
}

/// Counts the topology, and fills `component_vertices` with one vertex of each component.
Topology topology_of(std::span<const TriangleIndices> triangles,
                     std::span<const std::uint32_t> welded,
                     std::vector<std::uint32_t>& component_vertices) {
  Topology topology;
  Components components(welded.size());
  std::vector<TriangleIndices> sorted;
  std::vector<std::uint32_t> used;
  std::vector<Edge> edges;
  for (const TriangleIndices& triangle : triangles) {
    TriangleIndices corners{welded[triangle[0]], welded[triangle[1]], welded[triangle[2]]};
    components.join(corners[0], corners[1]);
    components.join(corners[1], corners[2]);
    std::sort(corners.begin(), corners.end());
    sorted.push_back(corners);
    used.insert(used.end(), corners.begin(), corners.end());
    for (const Edge& edge : {Edge{corners[0], corners[1]}, Edge{corners[1], corners[2]},
                             Edge{corners[0], corners[2]}}) {
      if (edge.first != edge.second) edges.push_back(edge);
    }
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  topology.welded_vertices = static_cast<std::uint32_t>(used.size());
  std::copy_if(used.begin(), used.end(), std::back_inserter(component_vertices),
               [&](std::uint32_t vertex) { return components.root(vertex) == vertex; });
  topology.components = static_cast<std::uint32_t>(component_vertices.size());
  std::sort(sorted.begin(), sorted.end());
  const auto distinct = std::unique(sorted.begin(), sorted.end());
  topology.duplicate_triangles = static_cast<std::uint32_t>(sorted.end() - distinct);
  topology.boundary_edges = count_odd(edges);
  topology.is_closed = topology.boundary_edges == 0;
  return topology;
}

}  // namespace

std::span<const std::uint32_t> Mesh::welded() const {
  std::call_once(data_->welded_flag, [&] {
    bvh::in_standard_arithmetic([&] { data_->welded = weld(data_->vertices); });
  });
  return data_->welded;
}

const Topology& Mesh::topology() const {
  std::call_once(data_->topology_flag, [&] {
    bvh::in_standard_arithmetic([&] {
      std::vector<std::uint32_t> component_vertices;
      Topology topology = topology_of(data_->triangles, welded(), component_vertices);
      for (std::size_t i = 0; i < data_->triangles.size(); ++i) {
        topology.degenerate_triangles += narrowphase::is_degenerate(triangle(i));
      }
      data_->topology = topology;
      data_->component_vertices = std::move(component_vertices);
    });
  });
  return data_->topology;
}

std::span<const std::uint32_t> Mesh::component_vertices() const {
  topology();
  return data_->component_vertices;
}

}  // namespace graze
