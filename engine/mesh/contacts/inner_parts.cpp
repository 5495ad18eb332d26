#include <graze/engine/mesh/contacts/inner_parts.h>
#include <graze/engine/mesh/contacts/surface_sides.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/mesh/vertex_fans.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace graze::contacts {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// The corners that triangles of the intersection share with the mesh: welded vertices by number,
/// and the corners that they are. Several vertices are one corner where placing rounds them so.
class CornersOfMesh {
 public:
  explicit CornersOfMesh(const MeshSide& side) : vertices_(side.own.count()) {
    const std::span<const std::uint32_t> welded = side.own_mesh.mesh.welded();
    for (std::uint32_t triangle : side.own.triangles()) {
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t vertex = welded[side.own_mesh.mesh.triangles()[triangle][k]];
        const std::uint32_t corner = side.own.corners(triangle)[k];
        if (corner_.emplace(vertex, corner).second) vertices_[corner].push_back(vertex);
      }
    }
  }

  const std::vector<std::uint32_t>& vertices(std::uint32_t corner) const {
    return vertices_[corner];
  }
  /// FeatureName::kNone for a vertex of no triangle of the intersection.
  std::uint32_t corner(std::uint32_t vertex) const {
    const auto found = corner_.find(vertex);
    return found == corner_.end() ? FeatureName::kNone : found->second;
  }

 private:
  std::unordered_map<std::uint32_t, std::uint32_t> corner_;
  std::vector<std::vector<std::uint32_t>> vertices_;
};

/// The nodes on the vertices and edges of a mesh.
class NodesOfMesh {
 public:
  NodesOfMesh(const CellComplex& complex, const MeshSide& side) : at_corner_(side.own.count()) {
    for (std::uint32_t i = 0; i < complex.nodes.size(); ++i) {
      const FeatureName& name = complex.nodes[i].name.*side.own_name;
      if (name.is_vertex()) at_corner_[name.corner[0]].push_back(i);
      if (name.is_edge()) on_edge_[{name.corner[0], name.corner[1]}].push_back(i);
    }
    for (auto& [edge, nodes] : on_edge_)
      sort_along(edge, nodes, complex, side.own);
  }

  const std::vector<std::uint32_t>& at_corner(std::uint32_t corner) const {
    return at_corner_[corner];
  }
  const std::map<Edge, std::vector<std::uint32_t>>& on_edges() const { return on_edge_; }

  /// The node nearest to the corner on its edge to another; kNone if there is none.
  std::uint32_t nearest(std::uint32_t corner, std::uint32_t other) const {
    const auto found = on_edge_.find(std::minmax(corner, other));
    if (found == on_edge_.end()) return FeatureName::kNone;
    return corner < other ? found->second.front() : found->second.back();
  }

 private:
  /// From the lower corner on, along the coordinate that changes most.
  static void sort_along(const Edge& edge, std::vector<std::uint32_t>& nodes,
                         const CellComplex& complex, const PlacedCorners& own) {
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
  std::map<Edge, std::vector<std::uint32_t>> on_edge_;
};

/// The ends of edges next to the nodes of each region.
struct Shores {
  std::vector<std::vector<std::uint32_t>> inside;  // welded vertices
  std::vector<std::uint32_t> outside;              // of all regions
};

class Search {
 public:
  Search(const CellComplex& complex, const std::vector<Region>& regions, const MeshSide& side)
      : complex_(complex),
        side_(side),
        regions_(regions),
        fans_(side.own_mesh.mesh.vertex_fans()),
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
        if (part_of_.contains(seed)) continue;
        const auto part = static_cast<std::uint32_t>(result.parts.size());
        follow(seed, part, result.parts.emplace_back());
      }
    }
    is_leaky.resize(result.parts.size());
    for (std::uint32_t vertex : shores_.outside) {
      const auto found = part_of_.find(vertex);
      if (found != part_of_.end()) is_leaky[found->second] = true;
    }
    for (std::size_t r = 0; r < regions_.size(); ++r)
      share_out(r, is_leaky, result);
    return result;
  }

 private:
  Eigen::Vector3d placed(std::uint32_t vertex) const {
    return place(side_.own_mesh.pose, side_.own_mesh.mesh.vertices()[vertex]);
  }

  void find_shores() {
    shores_.inside.resize(regions_.size());
    std::vector<std::size_t> region_of(complex_.nodes.size());
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      for (std::uint32_t node : regions_[r].nodes)
        region_of[node] = r;
    }
    for (const auto& [edge, nodes] : nodes_.on_edges()) {
      add_shore(nodes.front(), edge.first, region_of[nodes.front()]);
      add_shore(nodes.back(), edge.second, region_of[nodes.back()]);
    }
    for (std::uint32_t triangle : side_.own.triangles()) {
      const Elements& elements = side_.own.elements(triangle);
      if (!elements.has_area()) continue;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          if (i != j) add_edge_at_vertex(elements.corners[0][i], elements.corners[0][j], region_of);
        }
      }
    }
    for (std::vector<std::uint32_t>& inside : shores_.inside) {
      std::sort(inside.begin(), inside.end());
      inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
    }
  }

  /// An edge from a corner that is a node.
  void add_edge_at_vertex(std::uint32_t from, std::uint32_t to,
                          const std::vector<std::size_t>& region_of) {
    if (nodes_.nearest(from, to) != FeatureName::kNone) return;
    for (std::uint32_t node : nodes_.at_corner(from))
      add_shore(node, to, region_of[node]);
  }

  /// No node lies between this one and the corner.
  void add_shore(std::uint32_t node, std::uint32_t corner, std::size_t region) {
    if (!nodes_.at_corner(corner).empty()) return;
    const SurfaceSide side =
        surface_.side_of(side_.own.position(corner), complex_.nodes[node].name.*side_.other_name);
    if (side == SurfaceSide::Unknown) return;
    const std::vector<std::uint32_t>& vertices = corners_.vertices(corner);
    std::vector<std::uint32_t>& shore =
        side == SurfaceSide::Inside ? shores_.inside[region] : shores_.outside;
    shore.insert(shore.end(), vertices.begin(), vertices.end());
  }

  void follow(std::uint32_t seed, std::uint32_t part, std::vector<Eigen::Vector3d>& points) {
    std::vector<std::uint32_t> open = {seed};
    part_of_.emplace(seed, part);
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
          if (part_of_.emplace(next, part).second) open.push_back(next);
        }
      }
    }
  }

  /// Its long side would lead past the nodes on the edges between its corners.
  bool is_without_area(std::uint32_t triangle) const {
    const std::span<const std::uint32_t> known = side_.own.triangles();
    return std::binary_search(known.begin(), known.end(), triangle) &&
           !side_.own.elements(triangle).has_area();
  }

  /// Whether the way from corner to corner meets no node; otherwise its end belongs to the part.
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
      const auto found = part_of_.find(seed);
      if (found == part_of_.end() || is_leaky[found->second]) {
        is_enclosed = false;
      } else {
        parts.push_back(found->second);
      }
    }
    if (!is_enclosed) {
      parts = {static_cast<std::uint32_t>(result.parts.size())};
      std::vector<Eigen::Vector3d>& next = result.parts.emplace_back();
      for (std::uint32_t seed : shores_.inside[r])
        next.push_back(placed(seed));
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
  std::unordered_map<std::uint32_t, std::uint32_t> part_of_;
};

}  // namespace

InnerParts find_inner_parts(const CellComplex& complex, const std::vector<Region>& regions,
                            const MeshSide& side) {
  return Search(complex, regions, side).run();
}

}  // namespace graze::contacts
