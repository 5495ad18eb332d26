#pragma once

// Finds the parts of a mesh's surface that lie inside another mesh. Private to engine/world.

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/world/contacts/mesh_placing.h>
#include <graze/engine/world/contacts/meshes/mesh_crossings.h>
#include <graze/narrowphase/convex/core/core.h>
#include <graze/narrowphase/convex/core/point_rows.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze {

struct VertexFans;

/// Marks the vertices of a mesh that have been met for this pair. Marks of earlier pairs count as
/// none, so that they need not be cleared.
class VertexMarks {
 public:
  enum class Mark : std::uint32_t { None, Inside, Outside };

  void start(std::size_t vertices);
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

/// The points of one piece: those of its curves, and vertices that are reached from there without
/// going outside. While a direction is examined, also vertices beyond, inside or outside, to which
/// the surface rises from there: they tell how the surface goes on, so that no direction seems to
/// part the meshes that does not.
class InnerPart {
 public:
  static constexpr std::uint32_t kNoVertex = 0xffffffffu;
  narrowphase::Vec3 at;                   ///< the origin of the points
  std::vector<narrowphase::Vec3> points;  ///< the points, those of the curves first
  std::vector<std::uint32_t> vertex;      ///< the vertex of each point, or kNoVertex
  std::vector<std::uint8_t> is_outer;     ///< whether each point is outside
  std::vector<std::uint8_t> is_opened;    ///< whether the neighbours of each point need not be
                                          ///< looked at
  double radius = 0;                      ///< no point is further than this from `at`
  std::uint32_t first_crossing = 0;       ///< the first crossing of the piece
  std::uint32_t crossing_count = 0;

  void clear();
  void add(const narrowphase::Vec3& point, std::uint32_t of_vertex, bool is_outside);
  /// Leaves the first `count` points, none of which is further from `at` than `to_radius`.
  void shorten(std::size_t count, double to_radius);

  /// Returns the number of the first of the points that are farthest in a direction.
  std::size_t farthest(const narrowphase::Vec3& direction) const;

  /// Returns the first point from `from` on that lies at least `along` far in a direction; the
  /// number of points if there is none.
  std::size_t next_beyond(const narrowphase::Vec3& direction, double along, std::size_t from) const;

  /// Returns how much farther the part extends outside than inside, or nothing if that is too much:
  /// then the point that leaves last in a direction is outside, and the exit belongs to another
  /// piece, or leads round a body that goes on. Law 15's depths are to a twentieth: a shallow exit
  /// that the outside makes longer by less than that is this piece's. Where an edge leaves an edge
  /// both of its ends are equally far, but for the error of the search for the exit.
  std::optional<double> outer_extent(const narrowphase::Vec3& direction, double depth) const;

  /// Returns the convex hull of the points as a core for the solvers; valid until points are added.
  narrowphase::Core core() const;

 private:
  narrowphase::PointRows rows_;
  double square_radius_ = 0;
};

/// The mesh whose surface it is.
enum class InnerSide : std::uint8_t { OfA, OfB };

/// Groups loops that bound one piece of what two meshes have in common.
class LoopGroups {
 public:
  void start(std::uint32_t loops);
  void join(std::uint32_t s, std::uint32_t t);
  /// Numbers the groups by their first loops. group() may be called from then on.
  void number();

  std::uint32_t group(std::uint32_t loop) const { return number_[loop]; }
  std::uint32_t count() const { return count_; }

 private:
  std::uint32_t root(std::uint32_t loop);

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> number_;
  std::uint32_t count_ = 0;
};

/// The inner parts of one mesh of a pair.
class InnerSurface {
 public:
  /// Collects the vertices that are reached from the inner ends of crossed edges without going
  /// outside, up to kMostVertices, and joins loops from which the same vertices are reached. Points
  /// are relative to the origin.
  void collect(const PlacedMeshView& mesh, const narrowphase::Vec3& origin, InnerSide side,
               const MeshCrossings& found, LoopGroups& groups);

  /// Makes the parts, one for each group, from the collected vertices. Crossings name their groups
  /// as pieces, and ascend by them. They must outlive this.
  void build(const MeshCrossings& found, const LoopGroups& groups);

  InnerPart& part(std::uint32_t piece) { return parts_[piece]; }

  /// Adds the vertices to which the surface rises in a direction from the part's farthest points
  /// without a stop, inside or outside. Returns the number of the farthest point.
  std::size_t grow(std::uint32_t piece, const narrowphase::Vec3& direction);

  /// Removes the points that grow() added to a part, so that no direction depends on those before
  /// it.
  void shrink(std::uint32_t piece);

  /// Calls `visit` for the triangles that go through the other mesh at a point of a part's curves,
  /// for each at least once.
  template <typename Visit>
  void for_each_at(std::uint32_t piece, std::size_t point, Visit&& visit) const;

  static constexpr std::size_t kMostVertices = 2048;

  /// True if a surface that leaves the other mesh through a face, where it is farthest in a
  /// direction, goes on around that mesh: then it is in the way of a move against the direction. A
  /// flat body on a ridge whose two faces are at right angles is just lifted off by a move along
  /// the normal of one face by as much as it reaches beyond; on a sharper ridge this is too short
  /// by as large a share as this cosine, and law 15's depths are to a twentieth.
  static bool goes_around(const narrowphase::Vec3& face_normal,
                          const narrowphase::Vec3& direction) {
    return dot(face_normal, direction) > 0.05;
  }

  /// Heights that differ by less than this share of a part's radius count as equal.
  static constexpr double kSameHeight = 1e-9;

  std::size_t vertex_count() const { return placing_.vertices.size(); }
  narrowphase::Vec3 placed(std::uint32_t vertex) const;
  /// Returns the welded vertices of a triangle.
  std::array<std::uint32_t, 3> corners(std::uint32_t triangle) const;
  std::span<const std::uint32_t> around(std::uint32_t vertex) const;
  /// Notes for PatchRim that the neighbours of a triangle are looked at.
  void note_neighbours(std::uint32_t triangle) const;
  bool is_inside(std::uint32_t vertex) const { return marks_[vertex] == VertexMarks::Mark::Inside; }
  /// True if a vertex is outside; `otherwise` where its side was not found.
  bool is_outside(std::uint32_t vertex, bool otherwise) const {
    const VertexMarks::Mark mark = marks_[vertex];
    return mark == VertexMarks::Mark::None ? otherwise : mark == VertexMarks::Mark::Outside;
  }
  const InnerPart& part(std::uint32_t piece) const { return parts_[piece]; }

 private:
  struct Collected {
    std::uint32_t vertex;
    std::uint32_t loop;
  };

  static bool is_crossed(const std::vector<EdgeCrossing>& edges, std::uint32_t s, std::uint32_t t);
  void start(const std::vector<EdgeCrossing>& edges, LoopGroups& groups);
  void note(std::uint32_t vertex, bool is_inside, std::uint32_t loop, LoopGroups& groups);
  void note_rim(std::uint32_t vertex) const;
  void enter(std::uint32_t piece);
  void open(std::uint32_t piece, std::size_t point, const narrowphase::Vec3& direction);
  void open_curves(std::uint32_t piece, const narrowphase::Vec3& direction, double most);
  void add_corners(std::uint32_t piece, std::uint32_t triangle, bool is_outside,
                   const narrowphase::Vec3& direction, double above);
  std::span<const MeshCrossing> crossings_of(std::uint32_t piece) const {
    return crossings_.subspan(parts_[piece].first_crossing, parts_[piece].crossing_count);
  }

  MeshPlacing placing_{};
  const VertexFans* fans_ = nullptr;
  std::span<const std::uint8_t> is_rim_;  ///< see PatchRim
  InnerSide side_ = InnerSide::OfA;
  std::span<const std::uint32_t> welded_;
  std::span<const MeshCrossing> crossings_;
  std::vector<Collected> collected_;    ///< the vertices inside
  std::vector<std::uint32_t> loop_of_;  ///< the loop of each vertex that was collected
  std::vector<std::uint64_t> part_of_;  ///< the part to which each vertex was added last
  /// The last climb for which each vertex lay too low: `above` only rises within a climb.
  std::vector<std::uint64_t> passed_over_;
  std::uint64_t climb_ = 0;
  std::uint64_t first_part_ = 1;  ///< the first name of parts of this pair in part_of_
  std::vector<InnerPart> parts_;
  static constexpr std::uint32_t kNoPiece = 0xffffffffu;
  std::uint32_t entered_ = kNoPiece;  ///< the piece whose points are in part_of_
  std::size_t lasting_ = 0;           ///< how many points the entered part has without growth
  double lasting_radius_ = 0;         ///< the radius of the entered part without growth
  VertexMarks marks_;
};

template <typename Visit>
void InnerSurface::for_each_at(std::uint32_t piece, std::size_t point, Visit&& visit) const {
  const std::span<const MeshCrossing> crossings = crossings_of(piece);
  const std::size_t number = crossings.front().from_number + point;
  for (const MeshCrossing& crossing : crossings) {
    if (crossing.from_number == number || crossing.to_number == number)
      visit(side_ == InnerSide::OfA ? crossing.pair.a : crossing.pair.b);
  }
}

}  // namespace graze
