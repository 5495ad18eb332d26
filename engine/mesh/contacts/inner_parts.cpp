#include <graze/engine/mesh/contacts/inner_parts.h>
#include <graze/engine/mesh/curves/surface_sides.h>
#include <graze/engine/mesh/curves/vertex_numbers.h>
#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/data/vertex_fans.h>
#include <graze/narrowphase/triangle_pair/placed_triangle.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace graze::contacts {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The corners that triangles of the intersection share with the mesh: welded vertices by number,
/// and the corners that they are. Several vertices are one corner where placing rounds them so.
class CornersOfMesh {
 public:
  explicit CornersOfMesh(const MeshSide& side)
      : corner_(2 * side.own.count()), first_(side.own.count() + 1, 0) {
    const std::span<const std::uint32_t> welded = side.own_mesh.mesh.welded();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> known;  // pairs of corners and vertices
    for (std::uint32_t triangle : side.own.triangles()) {
      const std::array<std::uint32_t, 3>& corners = side.own.corners(triangle);
      const TriangleIndices& indices = side.own_mesh.mesh.triangles()[triangle];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = welded[indices[k]];
        if (corner_.add(vertex, corners[k])) known.emplace_back(corners[k], vertex);
      }
    }
    std::stable_sort(known.begin(), known.end(),
                     [](const auto& s, const auto& t) { return s.first < t.first; });
    for (const auto& [corner, vertex] : known) {
      ++first_[corner + 1];
      vertices_.push_back(vertex);
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  std::span<const std::uint32_t> vertices(std::uint32_t corner) const {
    return {vertices_.data() + first_[corner], first_[corner + 1] - first_[corner]};
  }
  /// Returns the corner that a vertex is; FeatureName::kNone for a vertex of no triangle of the
  /// intersection.
  std::uint32_t corner(std::uint32_t vertex) const { return corner_.find(vertex); }

 private:
  VertexNumbers corner_;
  std::vector<std::uint32_t> vertices_;  ///< the vertices of one corner after the other
  std::vector<std::uint32_t> first_;
};
static_assert(VertexNumbers::kNone == FeatureName::kNone);

/// The nodes on the vertices and edges of a mesh.
class NodesOfMesh {
 public:
  NodesOfMesh(const CellComplex& complex, const MeshSide& side) : at_corner_(side.own.count()) {
    std::vector<std::pair<Edge, std::uint32_t>> all;
    for (std::uint32_t i = 0; i < complex.nodes.size(); ++i) {
      const FeatureName& name = complex.nodes[i].name.*side.own_name;
      if (name.is_vertex()) at_corner_[name.corner[0]].push_back(i);
      if (name.is_edge()) all.push_back({{name.corner[0], name.corner[1]}, i});
    }
    std::sort(all.begin(), all.end());
    for (const auto& [edge, node] : all) {
      if (on_edge_.empty() || on_edge_.back().edge != edge) {
        on_edge_.push_back({edge, static_cast<std::uint32_t>(on_edges_.size()), 0});
      }
      ++on_edge_.back().count;
      on_edges_.push_back(node);
    }
    for (const NodesOnEdge& on : on_edge_)
      sort_along(on.edge, {on_edges_.data() + on.first, on.count}, complex, side.own);
  }

  const std::vector<std::uint32_t>& at_corner(std::uint32_t corner) const {
    return at_corner_[corner];
  }
  /// Calls `fn(edge, nodes)` for each edge with nodes, ascending; the nodes come in order from its
  /// lower corner on.
  template <typename Fn>
  void for_each_edge(const Fn& fn) const {
    for (const NodesOnEdge& on : on_edge_)
      fn(on.edge, nodes_of(on));
  }

  /// Returns the node nearest to the corner on its edge to another; kNone if there is none.
  std::uint32_t nearest(std::uint32_t corner, std::uint32_t other) const {
    const Edge edge = std::minmax(corner, other);
    const auto found =
        std::lower_bound(on_edge_.begin(), on_edge_.end(), edge,
                         [](const NodesOnEdge& on, const Edge& e) { return on.edge < e; });
    if (found == on_edge_.end() || found->edge != edge) return FeatureName::kNone;
    return corner < other ? nodes_of(*found).front() : nodes_of(*found).back();
  }

 private:
  struct NodesOnEdge {
    Edge edge;
    std::uint32_t first;  ///< index into on_edges_
    std::uint32_t count;
  };

  std::span<const std::uint32_t> nodes_of(const NodesOnEdge& on) const {
    return {on_edges_.data() + on.first, on.count};
  }

  /// Sorts nodes from the lower corner on, along the coordinate that changes most.
  static void sort_along(const Edge& edge, std::span<std::uint32_t> nodes,
                         const CellComplex& complex, const PlacedCorners& own) {
    if (nodes.size() == 1) return;
    const double* from = own.position(edge.first).data();
    const double* to = own.position(edge.second).data();
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(0.5 * to[k] - 0.5 * from[k]) > std::abs(0.5 * to[axis] - 0.5 * from[axis]))
        axis = k;
    }
    const bool is_rising = to[axis] > from[axis];
    std::stable_sort(nodes.begin(), nodes.end(), [&](std::uint32_t i, std::uint32_t j) {
      const double p = complex.nodes[i].position.data()[axis];
      const double q = complex.nodes[j].position.data()[axis];
      return is_rising ? p < q : p > q;
    });
  }

  std::vector<std::vector<std::uint32_t>> at_corner_;
  std::vector<NodesOnEdge> on_edge_;  ///< ascending by edge
  std::vector<std::uint32_t> on_edges_;
};

/// The ends of edges next to the nodes of each region.
struct Shores {
  std::vector<std::vector<std::uint32_t>> inside;  ///< welded vertices
  std::vector<std::vector<std::uint32_t>>
      across;                          ///< nodes to which an edge leads through the inside
  std::vector<std::uint32_t> outside;  ///< welded vertices outside, of all regions
};

class Search {
 public:
  Search(const CellComplex& complex, const std::vector<Region>& regions, const MeshSide& side)
      : complex_(complex),
        side_(side),
        regions_(regions),
        fans_(vertex_fans_of(side.own_mesh.mesh)),
        welded_(side.own_mesh.mesh.welded()),
        corners_(side),
        nodes_(complex, side),
        surface_(side.other) {}

  InnerParts run() {
    find_shores();
    InnerParts result;
    result.of_region.resize(regions_.size());
    std::vector<bool> is_leaky;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (regions_[r].has_loose_end) continue;
      for (std::uint32_t seed : shores_.inside[r]) {
        if (part_of_.find(seed) != VertexNumbers::kNone) continue;
        const auto part = static_cast<std::uint32_t>(result.parts.size());
        follow(seed, part, result.parts.emplace_back());
      }
    }
    is_leaky.resize(result.parts.size());
    for (std::uint32_t vertex : shores_.outside) {
      const std::uint32_t part = part_of_.find(vertex);
      if (part != VertexNumbers::kNone) is_leaky[part] = true;
    }
    for (std::size_t r = 0; r < regions_.size(); ++r)
      share_out(r, is_leaky, result);
    return result;
  }

 private:
  Eigen::Vector3d placed(std::uint32_t vertex) const {
    return narrowphase::place(side_.own_mesh.pose, side_.own_mesh.mesh.vertices()[vertex]);
  }

  void find_shores() {
    shores_.inside.resize(regions_.size());
    shores_.across.resize(regions_.size());
    std::vector<std::size_t> region_of(complex_.nodes.size());
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      for (std::uint32_t node : regions_[r].nodes)
        region_of[node] = r;
    }
    nodes_.for_each_edge([&](const Edge& edge, std::span<const std::uint32_t> nodes) {
      add_shore(nodes.front(), edge.first, region_of[nodes.front()]);
      add_shore(nodes.back(), edge.second, region_of[nodes.back()]);
      for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        add_stretch(edge, nodes.subspan(i, 1), nodes.subspan(i + 1, 1), region_of);
      add_stretch(edge, nodes_.at_corner(edge.first), nodes.first(1), region_of);
      add_stretch(edge, nodes.last(1), nodes_.at_corner(edge.second), region_of);
    });
    for (std::uint32_t triangle : side_.own.triangles()) {
      const Elements& elements = side_.own.elements(triangle);
      if (!elements.has_area()) continue;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          if (i != j) add_edge_at_vertex(elements.corners[0][i], elements.corners[0][j], region_of);
        }
      }
    }
    for (std::vector<std::vector<std::uint32_t>>* ends : {&shores_.inside, &shores_.across}) {
      for (std::vector<std::uint32_t>& of_region : *ends) {
        std::sort(of_region.begin(), of_region.end());
        of_region.erase(std::unique(of_region.begin(), of_region.end()), of_region.end());
      }
    }
  }

  /// Adds a stretch of an edge between nodes, here at one point each. It belongs to the parts that
  /// end at both if it is inside: a bar that goes right through may have no vertex there.
  void add_stretch(const Edge& edge, std::span<const std::uint32_t> from,
                   std::span<const std::uint32_t> to, const std::vector<std::size_t>& region_of) {
    bool is_inside = false;
    const auto look = [&](std::uint32_t node, std::uint32_t corner) {
      const SurfaceSide side =
          surface_.side_of(side_.own.position(corner), complex_.nodes[node].name.*side_.other_name);
      if (side == SurfaceSide::Inside) is_inside = true;
      return side != SurfaceSide::Outside;
    };
    for (std::uint32_t node : from) {
      if (!look(node, edge.second)) return;
    }
    for (std::uint32_t node : to) {
      if (!look(node, edge.first)) return;
    }
    if (!is_inside) return;
    for (std::uint32_t i : from) {
      for (std::uint32_t j : to) {
        shores_.across[region_of[i]].push_back(j);
        shores_.across[region_of[j]].push_back(i);
      }
    }
  }

  /// Adds an edge from a corner that is a node.
  void add_edge_at_vertex(std::uint32_t from, std::uint32_t to,
                          const std::vector<std::size_t>& region_of) {
    if (nodes_.at_corner(from).empty()) return;
    if (nodes_.nearest(from, to) != FeatureName::kNone) return;
    add_stretch({from, to}, nodes_.at_corner(from), nodes_.at_corner(to), region_of);
    for (std::uint32_t node : nodes_.at_corner(from))
      add_shore(node, to, region_of[node]);
  }

  /// Adds the corner at the end of an edge unless it is a node itself. No node may lie between this
  /// one and the corner.
  void add_shore(std::uint32_t node, std::uint32_t corner, std::size_t region) {
    if (!nodes_.at_corner(corner).empty()) return;
    const SurfaceSide side =
        surface_.side_of(side_.own.position(corner), complex_.nodes[node].name.*side_.other_name);
    if (side == SurfaceSide::Unknown) return;
    const std::span<const std::uint32_t> vertices = corners_.vertices(corner);
    std::vector<std::uint32_t>& shore =
        side == SurfaceSide::Inside ? shores_.inside[region] : shores_.outside;
    shore.insert(shore.end(), vertices.begin(), vertices.end());
  }

  void follow(std::uint32_t seed, std::uint32_t part, std::vector<Eigen::Vector3d>& points) {
    std::vector<std::uint32_t> open = {seed};
    part_of_.add(seed, part);
    while (!open.empty()) {
      const std::uint32_t vertex = open.back();
      open.pop_back();
      points.push_back(placed(vertex));
      const std::uint32_t corner = corners_.corner(vertex);
      for (std::uint32_t triangle : fans_.around(vertex)) {
        if (corner != FeatureName::kNone && is_without_area(triangle)) continue;
        for (std::uint32_t index : side_.own_mesh.mesh.triangles()[triangle]) {
          const std::uint32_t next = welded_[index];
          if (!leads_on(corner, corners_.corner(next), points)) continue;
          if (part_of_.add(next, part)) open.push_back(next);
        }
      }
    }
  }

  /// True if a triangle has no area: its long side would lead past the nodes on the edges between
  /// its corners.
  bool is_without_area(std::uint32_t triangle) const {
    const std::span<const std::uint32_t> known = side_.own.triangles();
    return std::binary_search(known.begin(), known.end(), triangle) &&
           !side_.own.elements(triangle).has_area();
  }

  /// True if no node lies between one corner and the next; otherwise the end of that node belongs
  /// to the part.
  bool leads_on(std::uint32_t corner, std::uint32_t next,
                std::vector<Eigen::Vector3d>& points) const {
    if (next == FeatureName::kNone) return true;
    if (corner != FeatureName::kNone && corner != next) {
      const std::uint32_t node = nodes_.nearest(corner, next);
      if (node != FeatureName::kNone) {
        points.push_back(complex_.nodes[node].position);
        return false;
      }
    }
    if (nodes_.at_corner(next).empty()) return true;
    points.push_back(side_.own.position(next));
    return false;
  }

  void share_out(std::size_t r, const std::vector<bool>& is_leaky, InnerParts& result) const {
    std::vector<std::uint32_t>& parts = result.of_region[r];
    bool is_enclosed = !regions_[r].has_loose_end;
    for (std::uint32_t seed : shores_.inside[r]) {
      const std::uint32_t part = part_of_.find(seed);
      if (part == VertexNumbers::kNone || is_leaky[part]) {
        is_enclosed = false;
      } else {
        parts.push_back(part);
      }
    }
    if (!is_enclosed) {
      parts = {static_cast<std::uint32_t>(result.parts.size())};
      std::vector<Eigen::Vector3d>& next = result.parts.emplace_back();
      for (std::uint32_t seed : shores_.inside[r])
        next.push_back(placed(seed));
    }
    if (!shores_.across[r].empty()) {
      parts.push_back(static_cast<std::uint32_t>(result.parts.size()));
      std::vector<Eigen::Vector3d>& ends = result.parts.emplace_back();
      for (std::uint32_t node : shores_.across[r])
        ends.push_back(complex_.nodes[node].position);
    }
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  }

  const CellComplex& complex_;
  const MeshSide& side_;
  const std::vector<Region>& regions_;
  const VertexFans& fans_;
  std::span<const std::uint32_t> welded_;
  CornersOfMesh corners_;
  NodesOfMesh nodes_;
  SurfaceSides surface_;
  Shores shores_;
  VertexNumbers part_of_;
};

}  // namespace

InnerParts find_inner_parts(const CellComplex& complex, const std::vector<Region>& regions,
                            const MeshSide& side) {
  return Search(complex, regions, side).run();
}

}  // namespace graze::contacts
