#include <graze/engine/mesh/query/pair_list.h>
#include <graze/engine/world/contacts/mesh_placing.h>
#include <graze/engine/world/contacts/meshes/mesh_crossings.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace graze {
namespace {

using narrowphase::Vec3;

/// A placed triangle, relative to the origin.
struct Side {
  Vec3 corner[3];
  std::uint32_t vertex[3];  ///< the welded vertices of the corners
  Vec3 normal;              ///< a normal whose length is twice the area
};

class SideOf {
 public:
  SideOf(const PlacedMeshView& mesh, const Vec3& origin)
      : placing_(placing_of(mesh, origin)), welded_(mesh.mesh.welded()) {}

  Side operator()(std::uint32_t index) const {
    const PlacedCorners placed = placed_corners(placing_, index);
    Side side;
    for (int i = 0; i < 3; ++i) {
      side.corner[i] = placed.corner[i];
      side.vertex[i] = welded_[placing_.triangles[index][static_cast<std::size_t>(i)]];
    }
    side.normal = cross(side.corner[1] - side.corner[0], side.corner[2] - side.corner[0]);
    return side;
  }

 private:
  MeshPlacing placing_;
  std::span<const std::uint32_t> welded_;
};

/// The two edges of a triangle that go through the other's plane.
struct PlaneCrossings {
  EdgeCrossing edge[2];
  Vec3 point[2];
  double along[2];  ///< places along the line that the planes share, ascending
};

/// Finds the two edges of a triangle that cross the other's plane. False if no corner is behind the
/// plane, or if all are.
bool cross_plane(const Side& own, const Side& other, const Vec3& line, PlaneCrossings& found) {
  double height[3];
  // A corner that is nearer to the plane than rounding can tell counts as in front.
  constexpr double kOnPlane = 0x1p-44;
  const double zero =
      kOnPlane * length(other.normal) * (largest(own.corner[0]) + largest(other.corner[0]));
  for (int i = 0; i < 3; ++i) {
    height[i] = dot(other.normal, own.corner[i] - other.corner[0]);
    if (std::abs(height[i]) <= zero) height[i] = 0;
  }
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if ((height[i] < 0) == (height[j] < 0)) continue;
    const bool is_rising = own.vertex[i] < own.vertex[j];
    const int low = is_rising ? i : j, high = is_rising ? j : i;
    EdgeCrossing& edge = found.edge[count];
    edge.low = own.vertex[low], edge.high = own.vertex[high];
    edge.share = height[low] / (height[low] - height[high]);
    edge.is_entry = height[high] < 0;
    found.point[count] = own.corner[low] + (own.corner[high] - own.corner[low]) * edge.share;
    found.along[count] = dot(line, found.point[count]);
    ++count;
  }
  if (count != 2) return false;
  if (found.along[1] < found.along[0]) {
    std::swap(found.along[0], found.along[1]);
    std::swap(found.edge[0], found.edge[1]);
    std::swap(found.point[0], found.point[1]);
  }
  return true;
}

class Finder {
 public:
  Finder(const PlacedMeshView& a, const PlacedMeshView& b, const Vec3& origin, MeshCrossings& found)
      : side_a_(a, origin), side_b_(b, origin), found_(found) {}

  /// Finds the crossings. Returns the number of pairs that are left out.
  std::size_t run() {
    found_.crossings.clear(), found_.edges_a.clear(), found_.edges_b.clear();
    std::size_t left_out = 0;
    Side a{};
    for (std::size_t i = 0; i < found_.pairs.size(); ++i) {
      const TrianglePair& pair = found_.pairs[i];
      if (i == 0 || found_.pairs[i - 1].a != pair.a) a = side_a_(pair.a);
      left_out += !add(pair, a, side_b_(pair.b));
    }
    return left_out;
  }

 private:
  bool add(const TrianglePair& pair, const Side& a, const Side& b) {
    const Vec3 line = cross(a.normal, b.normal);
    PlaneCrossings of_a, of_b;
    if (!cross_plane(a, b, line, of_a) || !cross_plane(b, a, line, of_b)) return false;
    const bool is_from_a = of_a.along[0] >= of_b.along[0];
    const bool is_to_a = of_a.along[1] <= of_b.along[1];
    const double from = is_from_a ? of_a.along[0] : of_b.along[0];
    const double to = is_to_a ? of_a.along[1] : of_b.along[1];
    const Vec3 normal_a = unit_or(a.normal, {}), normal_b = unit_or(b.normal, {});
    if (from > to || largest(normal_a) == 0 || largest(normal_b) == 0) return false;
    EdgeCrossing first = is_from_a ? of_a.edge[0] : of_b.edge[0];
    EdgeCrossing last = is_to_a ? of_a.edge[1] : of_b.edge[1];
    first.loop = last.loop = static_cast<std::uint32_t>(found_.crossings.size());
    (is_from_a ? found_.edges_a : found_.edges_b).push_back(first);
    (is_to_a ? found_.edges_a : found_.edges_b).push_back(last);
    found_.crossings.push_back({pair, is_from_a ? of_a.point[0] : of_b.point[0],
                                is_to_a ? of_a.point[1] : of_b.point[1], normal_a, normal_b, 0, 0,
                                0, 0});
    return true;
  }

  SideOf side_a_;
  SideOf side_b_;
  MeshCrossings& found_;
};

std::uint32_t lowest(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i)
    i = parent[i] = parent[parent[i]];
  return i;
}

/// Numbers the pieces by their first crossings.
void find_pieces(MeshCrossings& found) {
  std::vector<MeshCrossing>& all = found.crossings;
  std::vector<std::uint32_t>& parent = found.parent;
  parent.resize(all.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto join = [&](std::uint32_t i, std::uint32_t j) {
    i = lowest(parent, i), j = lowest(parent, j);
    parent[std::max(i, j)] = std::min(i, j);
  };
  found.order = parent;
  std::sort(found.order.begin(), found.order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(all[i].pair.b, i) < std::pair(all[j].pair.b, j);
  });
  for (std::uint32_t i = 1; i < all.size(); ++i) {
    if (all[i - 1].pair.a == all[i].pair.a) join(i - 1, i);
    const std::uint32_t s = found.order[i - 1], t = found.order[i];
    if (all[s].pair.b == all[t].pair.b) join(s, t);
  }
  found.pieces = 0;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const std::uint32_t first = lowest(parent, i);
    all[i].piece = first == i ? found.pieces++ : all[first].piece;
  }
}

bool is_one_end(const EdgeCrossing& s, const EdgeCrossing& t) {
  return s.low == t.low && s.high == t.high && s.share == t.share;
}

/// Sorts crossings of edges by edge, then along it, then by crossing or loop.
void sort_edges(std::vector<EdgeCrossing>& edges) {
  const auto ends = [](const EdgeCrossing& edge) {
    return std::uint64_t{edge.low} << 32 | edge.high;
  };
  std::sort(edges.begin(), edges.end(), [&](const EdgeCrossing& s, const EdgeCrossing& t) {
    if (ends(s) != ends(t)) return ends(s) < ends(t);
    return s.share != t.share ? s.share < t.share : s.loop < t.loop;
  });
}

/// Numbers the loops by their first crossings. Two crossings continue each other where the same
/// edge goes through the same triangle. A curve with an end that no other crossing continues stays
/// with its piece: it ends at the border of an open mesh, or where an edge meets an edge, which
/// rounding may decide differently on both sides. Before this, edges name their crossings as loops.
void find_loops(MeshCrossings& found) {
  std::vector<MeshCrossing>& all = found.crossings;
  std::vector<std::uint32_t>& parent = found.parent;
  std::iota(parent.begin(), parent.end(), 0u);
  const auto join = [&](std::uint32_t i, std::uint32_t j) {
    i = lowest(parent, i), j = lowest(parent, j);
    parent[std::max(i, j)] = std::min(i, j);
  };
  found.met_ends.assign(all.size(), 0);
  for (std::vector<EdgeCrossing>* edges : {&found.edges_a, &found.edges_b}) {
    sort_edges(*edges);
    for (std::size_t i = 1; i < edges->size(); ++i) {
      const EdgeCrossing &s = (*edges)[i - 1], &t = (*edges)[i];
      // Sheets that coincide share ends, but are separate pieces all the same.
      if (!is_one_end(s, t) || all[s.loop].piece != all[t.loop].piece) continue;
      join(s.loop, t.loop);
      ++found.met_ends[s.loop], ++found.met_ends[t.loop];
    }
  }
  // If a chain is open its first crossing is marked for all of it.
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (found.met_ends[i] != 2) found.met_ends[lowest(parent, i)] = 0;
  }
  constexpr std::uint32_t kNone = 0xffffffffu;
  found.order.assign(found.pieces, kNone);  // an open crossing of each piece
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    if (found.met_ends[lowest(parent, i)] == 2) continue;
    std::uint32_t& open = found.order[all[i].piece];
    if (open == kNone) open = i;
    join(open, i);
  }
  found.loops = 0;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const std::uint32_t first = lowest(parent, i);
    all[i].loop = first == i ? found.loops++ : all[first].loop;
  }
}

/// Keeps each crossing of an edge once, although two triangles share the edge, and sets its loop.
void remove_repeated(const std::vector<MeshCrossing>& crossings, std::vector<EdgeCrossing>& edges) {
  edges.erase(std::unique(edges.begin(), edges.end(), is_one_end), edges.end());
  for (EdgeCrossing& edge : edges)
    edge.loop = crossings[edge.loop].loop;
}

}  // namespace

bool find_crossings(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, const Vec3& origin,
                    MeshCrossings& found, Work& work) {
  find_triangle_pairs_into(found.pairs, mesh_a, mesh_b, work);
  const std::size_t left_out = Finder(mesh_a, mesh_b, origin, found).run();
  if (left_out > found.crossings.size()) return false;
  find_pieces(found);
  find_loops(found);
  remove_repeated(found.crossings, found.edges_a);
  remove_repeated(found.crossings, found.edges_b);
  return true;
}

}  // namespace graze
