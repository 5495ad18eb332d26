#include <graze/engine/mesh/curves/cell_complex.h>
#include <graze/narrowphase/derived/common_points.h>
#include <graze/narrowphase/derived/simplex.h>
#include <graze/narrowphase/triangle_intersection.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

namespace graze::contacts {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Returns the part of an element in which a point lies, given the edges on which it does.
FeatureName name_of(const Corners& corners, unsigned edges) {
  if (edges == 0) return {corners};
  if (std::popcount(edges) == 1) {
    const int(&edge)[2] = narrowphase::kEdges[std::countr_zero(edges)];
    return {{corners[edge[0]], corners[edge[1]], FeatureName::kNone}};
  }
  for (int vertex = 0; vertex < 2; ++vertex) {
    if (edges == narrowphase::edges_at_vertex(vertex))
      return {{corners[vertex], FeatureName::kNone, FeatureName::kNone}};
  }
  return {{corners[2], FeatureName::kNone, FeatureName::kNone}};
}

/// The part that one pair of triangles has in common, before equal cells are joined.
struct Piece {
  TrianglePair pair;
  std::uint32_t first_name;
  std::uint32_t count;
};

struct Pieces {
  std::vector<Piece> pieces;
  std::vector<NodeName> names;

  void add(TrianglePair pair, const Corners& a, const Triangle& hull_a, const Corners& b,
           const Triangle& hull_b) {
    const narrowphase::OrderedTriangles ordered = narrowphase::ordered(hull_a, hull_b);
    const narrowphase::CommonPoints common = narrowphase::find_common_points(ordered);
    if (common.count == 0) return;
    pieces.push_back(
        {pair, static_cast<std::uint32_t>(names.size()), static_cast<std::uint32_t>(common.count)});
    for (int i = 0; i < common.count; ++i) {
      const narrowphase::CommonPoint& p = common.point[i];
      names.push_back({name_of(a, ordered.is_swapped ? p.edges_b : p.edges_a),
                       name_of(b, ordered.is_swapped ? p.edges_a : p.edges_b)});
    }
  }
};

std::vector<std::uint32_t> distinct(std::vector<std::uint32_t> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

PlacedCorners corners_of(const PlacedMeshView& placed, const TrianglePairs& pairs,
                         std::uint32_t TrianglePair::*side) {
  std::vector<std::uint32_t> triangles;
  for (const TrianglePair& pair : pairs)
    triangles.push_back(pair.*side);
  return PlacedCorners(placed, distinct(std::move(triangles)));
}

Pieces find_pieces(const TrianglePairs& pairs, const PlacedCorners& a, const PlacedCorners& b) {
  Pieces found;
  for (const TrianglePair& pair : pairs) {
    const Elements& of_a = a.elements(pair.a);
    const Elements& of_b = b.elements(pair.b);
    for (int i = 0; i < of_a.count; ++i) {
      for (int j = 0; j < of_b.count; ++j) {
        found.add(pair, of_a.corners[i], a.hull(of_a.corners[i]), of_b.corners[j],
                  b.hull(of_b.corners[j]));
      }
    }
  }
  return found;
}

/// Computes a node's position from the features alone, whichever triangles they came from: it is
/// their one common point, or the vertex that one of them is.
Eigen::Vector3d position_of(const NodeName& name, const PlacedCorners& a, const PlacedCorners& b) {
  if (name.a.is_vertex()) return a.position(name.a.corner[0]);
  if (name.b.is_vertex()) return b.position(name.b.corner[0]);
  return intersection(a.hull(name.a), b.hull(name.b)).corner[0];
}

int compare(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  for (int k = 0; k < 3; ++k) {
    if (p.data()[k] != q.data()[k]) return p.data()[k] < q.data()[k] ? -1 : 1;
  }
  return 0;
}

/// A feature with the mesh that it is of.
struct PlacedFeature {
  const FeatureName& name;
  const PlacedCorners& corners;
};

int compare(const PlacedFeature& f, const PlacedFeature& g) {
  if (f.name.count() != g.name.count()) return f.name.count() < g.name.count() ? -1 : 1;
  for (int i = 0; i < f.name.count(); ++i) {
    const int order =
        compare(f.corners.position(f.name.corner[i]), g.corners.position(g.name.corner[i]));
    if (order != 0) return order;
  }
  return 0;
}

/// The order of nodes: by position, then by the lesser feature, then by the greater one, whichever
/// mesh they are of. Where two nodes differ only in which mesh has which of two features, the order
/// of the meshes decides, whichever is called A.
class NodeOrder {
 public:
  NodeOrder(const PlacedCorners& a, const PlacedCorners& b)
      : a_(a), b_(b), is_b_first_(b.is_before(a)) {}

  bool operator()(const Node& m, const Node& n) const {
    if (const int order = compare(m.position, n.position)) return order < 0;
    const bool swap_m = compare(of_b(m), of_a(m)) < 0;
    const bool swap_n = compare(of_b(n), of_a(n)) < 0;
    const int lesser = compare(swap_m ? of_b(m) : of_a(m), swap_n ? of_b(n) : of_a(n));
    if (lesser != 0) return lesser < 0;
    const int greater = compare(swap_m ? of_a(m) : of_b(m), swap_n ? of_a(n) : of_b(n));
    if (greater != 0) return greater < 0;
    return is_b_first_ ? m.name.b < n.name.b : m.name.a < n.name.a;
  }

 private:
  PlacedFeature of_a(const Node& node) const { return {node.name.a, a_}; }
  PlacedFeature of_b(const Node& node) const { return {node.name.b, b_}; }

  const PlacedCorners& a_;
  const PlacedCorners& b_;
  bool is_b_first_;
};

/// Makes the nodes of a complex, and returns for each name given the number of its node.
std::vector<std::uint32_t> number_nodes(const std::vector<NodeName>& names, CellComplex& complex) {
  std::vector<NodeName> known = names;
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  for (const NodeName& name : known)
    complex.nodes.push_back({name, position_of(name, complex.a, complex.b)});
  std::vector<std::uint32_t> order(known.size());
  std::iota(order.begin(), order.end(), 0u);
  const NodeOrder is_before(complex.a, complex.b);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return is_before(complex.nodes[i], complex.nodes[j]);
  });
  std::vector<std::uint32_t> rank(known.size());
  std::vector<Node> sorted;
  for (std::uint32_t i : order) {
    rank[i] = static_cast<std::uint32_t>(sorted.size());
    sorted.push_back(complex.nodes[i]);
  }
  complex.nodes = std::move(sorted);
  std::vector<std::uint32_t> numbers;
  for (const NodeName& name : names) {
    const auto place = std::lower_bound(known.begin(), known.end(), name);
    numbers.push_back(rank[static_cast<std::size_t>(place - known.begin())]);
  }
  return numbers;
}

/// Returns the cell of a piece with its corners from the lowest on, towards its lower neighbour.
Cell cell_of(std::span<const std::uint32_t> corners) {
  Cell cell;
  cell.count = static_cast<std::uint32_t>(corners.size());
  const std::size_t n = corners.size();
  const auto lowest =
      static_cast<std::size_t>(std::min_element(corners.begin(), corners.end()) - corners.begin());
  const bool is_forward = corners[(lowest + 1) % n] <= corners[(lowest + n - 1) % n];
  for (std::size_t i = 0; i < n; ++i)
    cell.corner[i] = corners[(lowest + (is_forward ? i : n - i)) % n];
  return cell;
}

void join_cells(const Pieces& found, std::span<const std::uint32_t> numbers, CellComplex& complex) {
  struct Named {
    Cell cell;
    TrianglePair pair;
    auto operator<=>(const Named&) const = default;
  };
  std::vector<Named> all;
  for (const Piece& piece : found.pieces)
    all.push_back({cell_of(numbers.subspan(piece.first_name, piece.count)), piece.pair});
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  for (std::size_t first = 0; first < all.size();) {
    Cell cell = all[first].cell;
    cell.first_pair = static_cast<std::uint32_t>(complex.pairs.size());
    std::size_t last = first;
    for (; last < all.size() && all[last].cell == all[first].cell; ++last)
      complex.pairs.push_back(all[last].pair);
    cell.pair_count = static_cast<std::uint32_t>(last - first);
    (cell.count == 1   ? complex.points
     : cell.count == 2 ? complex.segments
                       : complex.polygons)
        .push_back(cell);
    first = last;
  }
}

}  // namespace

CellComplex intersect_cells(const PlacedMeshView& a, const PlacedMeshView& b, PairVolume volume,
                            Work* work) {
  const TrianglePairs pairs = find_triangle_pairs(a, b, {.volume = volume}, work);
  CellComplex complex{corners_of(a, pairs, &TrianglePair::a),
                      corners_of(b, pairs, &TrianglePair::b),
                      {},
                      {},
                      {},
                      {},
                      {}};
  const Pieces found = find_pieces(pairs, complex.a, complex.b);
  join_cells(found, number_nodes(found.names, complex), complex);
  return complex;
}

}  // namespace graze::contacts
