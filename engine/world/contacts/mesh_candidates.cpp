// Contacts of two meshes, from their crossings: a normal and a depth for each patch, and its
// corners.

#include <graze/engine/mesh/data/mesh_trees.h>
#include <graze/engine/mesh/data/vertex_fans.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/mesh_crossings.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace graze {
namespace {

using narrowphase::ContactPoint;
using narrowphase::Vec3;

// Patches whose normals differ by less than about 25 degrees are one.
constexpr double kSameDirection = 0.9;

// A face that is parallel to the direction of separation, to about 10 degrees, bounds no depth.
constexpr double kFacingOut = 0.17;

// So many vertices of one mesh inside the other are looked at, the ones that are furthest in first,
// of each loop its share, but no fewer than the least: a depth needs no more.
constexpr std::size_t kMostInner = 96;
constexpr std::size_t kLeastInner = 8;

/// Crossings that are connected by triangles.
struct Piece {
  Vec3 first;         ///< any of its points
  Vec3 area;          ///< the area vectors of its loops, added up
  Vec3 faces;         ///< normals of A less those of B, by the lengths of segments
  double length = 0;  ///< of all its segments
  Vec3 normal;        ///< unit, from A to B; once patches are known, that of its patch
  std::uint32_t patch = 0;
};

/// One closed curve of a piece, and how deep the two are in each other there along the piece's
/// normal.
struct Loop {
  const Piece* piece = nullptr;
  Vec3 first;                       ///< any of its points
  double depth_a = 0, depth_b = 0;  ///< how deep points of A lie in B, and of B in A
  double high_a = 0, low_b = 0;     ///< the ends of A and B along the normal, from `first`
  double depth = 0;
};

/// A point of one mesh inside the other.
struct InnerPoint {
  Vec3 point;
  std::uint32_t loop;
};

/// A vertex that may be an inner point, and how far in it is along the normal.
struct OpenVertex {
  double height;
  std::uint32_t vertex;
  std::uint32_t loop;
  Vec3 point;
  bool operator<(const OpenVertex& other) const {
    return height != other.height ? height < other.height : vertex > other.vertex;
  }
};

/// Which vertices have been met for this pair. Marks of earlier pairs count as none, so that they
/// need not be cleared.
class VertexMarks {
 public:
  enum class Mark : std::uint32_t { None, Inside, Outside };

  void start(std::size_t vertices) {
    if (marks_.size() < vertices) marks_.resize(vertices, 0);
    if (round_ > std::numeric_limits<std::uint32_t>::max() - 8) {
      std::fill(marks_.begin(), marks_.end(), 0);
      round_ = 0;
    }
    round_ += 4;
  }
  Mark operator[](std::uint32_t vertex) const {
    return marks_[vertex] >= round_ ? static_cast<Mark>(marks_[vertex] - round_) : Mark::None;
  }
  void set(std::uint32_t vertex, Mark mark) {
    marks_[vertex] = round_ + static_cast<std::uint32_t>(mark);
  }

 private:
  std::vector<std::uint32_t> marks_;
  std::uint32_t round_ = 0;
};

/// Memory that is kept from one pair to the next, so that no step of a simulation allocates.
struct Scratch {
  MeshCrossings found;
  std::vector<Piece> pieces;
  std::vector<Loop> loops;
  std::vector<std::uint32_t> by_area;
  std::vector<std::uint32_t> patches;  ///< of each, its largest piece
  std::vector<InnerPoint> inner_a, inner_b;
  std::vector<OpenVertex> open;       ///< a heap, the vertex farthest in first
  std::vector<std::uint32_t> looked;  ///< for each loop, how many vertices were looked at
  VertexMarks marks;
};

/// The normal of a piece: that of its area, or the mean of its faces' normals; nothing where both
/// are too small to tell.
std::optional<Vec3> normal_of(const Piece& piece) {
  constexpr double kFlat = 1e-4;
  if (length(piece.area) > kFlat * piece.length * piece.length)
    return unit_or(piece.area, {0, 0, 1});
  if (length(piece.faces) > kFlat * piece.length) return unit_or(piece.faces, {0, 0, 1});
  return std::nullopt;
}

bool sum_up_pieces(const MeshCrossings& found, std::vector<Piece>& pieces) {
  pieces.assign(found.pieces, {});
  for (const MeshCrossing& crossing : found.crossings) {
    Piece& piece = pieces[crossing.piece];
    const double segment_length = length(crossing.to - crossing.from);
    if (piece.length == 0) piece.first = crossing.from;
    piece.area = piece.area + cross(crossing.from - piece.first, crossing.to - piece.first) * 0.5;
    piece.faces = piece.faces + (crossing.normal_a - crossing.normal_b) * segment_length;
    piece.length += segment_length;
  }
  for (Piece& piece : pieces) {
    const std::optional<Vec3> normal = normal_of(piece);
    if (!normal) return false;
    piece.normal = *normal;
  }
  return true;
}

/// Joins pieces with nearly the same normal into patches, the largest first.
void find_patches(Scratch& s) {
  s.by_area.clear(), s.patches.clear();
  for (std::uint32_t i = 0; i < s.pieces.size(); ++i)
    s.by_area.push_back(i);
  std::sort(s.by_area.begin(), s.by_area.end(), [&](std::uint32_t i, std::uint32_t j) {
    const double of_i = dot(s.pieces[i].area, s.pieces[i].area);
    const double of_j = dot(s.pieces[j].area, s.pieces[j].area);
    return of_i != of_j ? of_i > of_j : i < j;
  });
  for (const std::uint32_t i : s.by_area) {
    Piece& piece = s.pieces[i];
    std::uint32_t at = 0;
    while (at < s.patches.size() &&
           dot(s.pieces[s.patches[at]].normal, piece.normal) < kSameDirection)
      ++at;
    piece.patch = at;
    if (at == s.patches.size()) s.patches.push_back(i);
  }
  for (std::uint32_t at = 0; at < s.patches.size(); ++at) {
    Vec3 sum;
    for (const Piece& piece : s.pieces) {
      if (piece.patch == at) sum = sum + piece.normal * length(piece.area);
    }
    const Vec3 normal = unit_or(sum, s.pieces[s.patches[at]].normal);
    for (Piece& piece : s.pieces) {
      if (piece.patch == at) piece.normal = normal;
    }
  }
}

/// Loops as they are before anything is known of what lies in them.
void start_loops(Scratch& s) {
  s.loops.assign(s.found.loops, {});
  for (const MeshCrossing& crossing : s.found.crossings) {
    Loop& loop = s.loops[crossing.loop];
    if (loop.piece == nullptr) loop = {&s.pieces[crossing.piece], crossing.from};
  }
}

/// Of A's surface what is inside is reached along the normals, of B's against them.
enum class InnerSide { OfA, OfB };

/// Finds the vertices of a mesh that are reached from its inner ends of crossed edges without going
/// outside, those furthest in first, and the middles of edges between crossings.
class InnerFinder {
 public:
  InnerFinder(const PlacedMeshView& mesh, InnerSide side, const Vec3& origin, Scratch& s,
              std::vector<InnerPoint>& inner)
      : mesh_(mesh),
        sign_(side == InnerSide::OfA ? 1 : -1),
        origin_(origin),
        s_(s),
        inner_(inner),
        welded_(mesh.mesh.welded()) {}

  void run(const std::vector<EdgeCrossing>& edges) {
    inner_.clear(), s_.open.clear();
    s_.marks.start(mesh_.mesh.vertices().size());
    start(edges);
    const std::size_t share = std::max(kLeastInner, kMostInner / s_.loops.size());
    s_.looked.assign(s_.loops.size(), 0);
    while (!s_.open.empty()) {
      std::pop_heap(s_.open.begin(), s_.open.end());
      const OpenVertex next = s_.open.back();
      s_.open.pop_back();
      // Outside is what belongs to a sheet that ends inside.
      if (s_.marks[next.vertex] == Mark::Outside || s_.looked[next.loop] == share) continue;
      ++s_.looked[next.loop];
      inner_.push_back({next.point, next.loop});
      open_neighbours(next);
    }
  }

 private:
  using Mark = VertexMarks::Mark;

  void start(const std::vector<EdgeCrossing>& edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const EdgeCrossing& edge = edges[i];
      const auto is_same = [&](std::size_t j) {
        return edges[j].low == edge.low && edges[j].high == edge.high;
      };
      if (i == 0 || !is_same(i - 1)) note(edge.low, !edge.is_entry, edge.loop);
      const bool is_last = i + 1 == edges.size() || !is_same(i + 1);
      if (is_last) note(edge.high, edge.is_entry, edge.loop);
      if (!is_last && edge.is_entry) {
        const double middle = 0.5 * (edge.share + edges[i + 1].share);
        const Vec3 low = placed(edge.low);
        inner_.push_back({low + (placed(edge.high) - low) * middle, edge.loop});
      }
    }
  }

  void open_neighbours(const OpenVertex& of) {
    for (const std::uint32_t triangle : vertex_fans_of(mesh_.mesh).around(of.vertex)) {
      for (const std::uint32_t index : mesh_.mesh.triangles()[triangle]) {
        const std::uint32_t neighbour = welded_[index];
        if (s_.marks[neighbour] == Mark::None) note(neighbour, true, of.loop);
      }
    }
  }

  void note(std::uint32_t vertex, bool is_inside, std::uint32_t loop) {
    if (s_.marks[vertex] == Mark::Outside) return;
    if (!is_inside) return s_.marks.set(vertex, Mark::Outside);
    if (s_.marks[vertex] == Mark::Inside) return;
    s_.marks.set(vertex, Mark::Inside);
    const Vec3 point = placed(vertex);
    const Loop& of = s_.loops[loop];
    s_.open.push_back({sign_ * dot(of.piece->normal, point - of.first), vertex, loop, point});
    std::push_heap(s_.open.begin(), s_.open.end());
  }

  Vec3 placed(std::uint32_t vertex) const {
    return to_vec3(narrowphase::place(mesh_.pose, mesh_.mesh.vertices()[vertex])) - origin_;
  }

  const PlacedMeshView& mesh_;
  double sign_;
  const Vec3& origin_;
  Scratch& s_;
  std::vector<InnerPoint>& inner_;
  std::span<const std::uint32_t> welded_;
};

/// How far a point is, along the direction out, behind the nearest of the faces that its loop
/// crosses; no more than `enough` counts.
double depth_of(const InnerPoint& inner, const Vec3& out, const Scratch& s, bool is_in_a,
                double enough) {
  double least = std::numeric_limits<double>::infinity();
  for (const MeshCrossing& crossing : s.found.crossings) {
    if (crossing.loop != inner.loop) continue;
    const Vec3& normal = is_in_a ? crossing.normal_a : crossing.normal_b;
    const double facing = dot(normal, out);
    if (facing < kFacingOut) continue;
    const double behind =
        dot(normal, (is_in_a ? crossing.on_a : crossing.on_b) - inner.point) / facing;
    if (behind < 0 || behind >= least) continue;
    least = behind;
    if (least <= enough) return enough;
  }
  return least < std::numeric_limits<double>::infinity() ? least : 0;
}

/// How far the two reach past each other along the normal, if that is less than by how much points
/// of either are behind faces of the other: in a corner the patch is as wide as it is long.
void find_depths(Scratch& s) {
  for (const MeshCrossing& crossing : s.found.crossings) {
    Loop& loop = s.loops[crossing.loop];
    const double along = dot(loop.piece->normal, crossing.from - loop.first);
    loop.high_a = std::max(loop.high_a, along);
    loop.low_b = std::min(loop.low_b, along);
  }
  for (const InnerPoint& inner : s.inner_a) {
    Loop& loop = s.loops[inner.loop];
    const Vec3& normal = loop.piece->normal;
    loop.high_a = std::max(loop.high_a, dot(normal, inner.point - loop.first));
    loop.depth_a = std::max(loop.depth_a, depth_of(inner, -normal, s, false, loop.depth_a));
  }
  for (const InnerPoint& inner : s.inner_b) {
    Loop& loop = s.loops[inner.loop];
    const Vec3& normal = loop.piece->normal;
    loop.low_b = std::min(loop.low_b, dot(normal, inner.point - loop.first));
    loop.depth_b = std::max(loop.depth_b, depth_of(inner, normal, s, true, loop.depth_b));
  }
  for (Loop& loop : s.loops)
    loop.depth = std::min(loop.high_a - loop.low_b, loop.depth_a + loop.depth_b);
}

/// The axis of a frame that a direction is nearest to, 0 to 5.
std::uint32_t side_of(const Pose& pose, const Vec3& direction) {
  const double* m = pose.data();  // column-major 4x4
  std::uint32_t best = 0;
  double most = -1;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const double along = dot({m[4 * k], m[4 * k + 1], m[4 * k + 2]}, direction);
    if (std::abs(along) > most) most = std::abs(along), best = 2 * k + (along < 0);
  }
  return best;
}

/// The corners of each patch: where it ends in four directions that turn with A, so that they are
/// the same ones in the next step. The directions are askew to A's axes, as edges seldom are.
void add_corners(const PlacedMeshView& a, const PlacedMeshView& b, const Scratch& s,
                 std::vector<ContactPoint>& candidates) {
  const double* m = a.pose.data();
  for (std::uint32_t patch = 0; patch < s.patches.size(); ++patch) {
    const Vec3& normal = s.pieces[s.patches[patch]].normal;
    const std::uint32_t side_a = side_of(a.pose, normal);
    // Patches at one side of A, which are few, are told apart by their order of size.
    std::uint32_t rank = 0;
    for (std::uint32_t before = 0; before < patch; ++before)
      rank += side_of(a.pose, s.pieces[s.patches[before]].normal) == side_a;
    const std::uint64_t feature_b = side_of(b.pose, normal);
    const std::uint32_t k = side_a / 2;
    const auto axis = [&](std::uint32_t i) { return Vec3{m[4 * i], m[4 * i + 1], m[4 * i + 2]}; };
    const Vec3 u = axis((k + 1) % 3), v = axis((k + 2) % 3);
    constexpr double kCosine = 0.95, kSine = 0.31;
    const Vec3 directions[] = {u * kCosine + v * kSine, v * kCosine - u * kSine};
    // A fifth is of the deepest loop, which may lie between the corners.
    const Loop* deepest = nullptr;
    for (const Loop& loop : s.loops) {
      if (loop.piece->patch == patch && (deepest == nullptr || loop.depth > deepest->depth))
        deepest = &loop;
    }
    const Vec3* corner[5] = {};
    const Loop* of[5] = {};
    double most[5];
    for (const MeshCrossing& crossing : s.found.crossings) {
      const Loop& loop = s.loops[crossing.loop];
      if (loop.piece->patch != patch) continue;
      for (int i = 0; i < 5; ++i) {
        if (i == 4 && &loop != deepest) continue;
        const double along = i < 2 || i == 4 ? dot(directions[i % 2], crossing.from)
                                             : -dot(directions[i - 2], crossing.from);
        if (corner[i] == nullptr || along > most[i])
          most[i] = along, corner[i] = &crossing.from, of[i] = &loop;
      }
    }
    for (std::uint32_t i = 0; i < 5; ++i) {
      if (std::find(corner, corner + i, corner[i]) != corner + i) continue;
      if (i == 4 && std::find(of, of + 4, deepest) != of + 4) continue;
      const std::uint64_t feature_a = (std::uint64_t{rank} << 8 | side_a) << 2 | (i % 4);
      const std::uint64_t fifth = i == 4 ? std::uint64_t{1} << 63 : 0;
      candidates.push_back(
          {*corner[i], *corner[i], normal, of[i]->depth, fifth | feature_a, feature_b});
    }
  }
}

}  // namespace

bool candidates_of_crossings(const PlacedShapeView& a, const PlacedShapeView& b,
                             ContactCandidates& candidates, Work& work) {
  static thread_local Scratch s;  // no pair is looked at within another
  const PlacedMeshView mesh_a{*a.shape.as<Mesh>(), a.pose};
  const PlacedMeshView mesh_b{*b.shape.as<Mesh>(), b.pose};
  candidates.origin = middle_of(a.shape, a.pose);
  const Vec3 origin = to_vec3(candidates.origin);
  const bool is_all = find_crossings(mesh_a, mesh_b, origin, s.found, work);
  if (s.found.pairs.empty()) return true;
  if (!is_all || !sum_up_pieces(s.found, s.pieces)) return false;
  find_patches(s);
  start_loops(s);
  InnerFinder(mesh_a, InnerSide::OfA, origin, s, s.inner_a).run(s.found.edges_a);
  InnerFinder(mesh_b, InnerSide::OfB, origin, s, s.inner_b).run(s.found.edges_b);
  find_depths(s);
  add_corners(mesh_a, mesh_b, s, candidates.list);
  return true;
}

}  // namespace graze
