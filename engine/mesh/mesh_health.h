#pragma once

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/triangle_pairs.h>
#include <graze/engine/work.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace graze {

// Here vertices are welded, as in Mesh::topology(): equal positions are one vertex, which goes by
// the lowest index among them. A triangle that repeats a welded vertex is degenerate, and takes no
// part in what is said of edges and parts.

/// An edge at which something is wrong.
struct FaultyEdge {
  std::array<std::uint32_t, 2> vertices;  ///< its ends, ascending
  std::uint32_t triangle;                 ///< the lowest triangle at it
  std::uint32_t triangle_count;           ///< how many triangles there are at it

  bool operator==(const FaultyEdge&) const = default;
};

/// A triangle with the same vertices as another one, in any order.
struct DuplicateTriangle {
  std::uint32_t triangle;  ///< the index of the triangle
  std::uint32_t earlier;   ///< the lowest triangle with these vertices

  bool operator==(const DuplicateTriangle&) const = default;
};

/// A part of a closed surface that faces the wrong way.
struct InsideOutPart {
  std::uint32_t triangle;        ///< its lowest triangle
  std::uint32_t triangle_count;  ///< how many it has
  std::uint32_t depth;  ///< inside how many other closed surfaces it lies: it should face outwards
                        ///< where that is even, and into the cavity that it bounds where it is odd

  bool operator==(const InsideOutPart&) const = default;
};

/// The result of check(). Every list is complete, ascending, and empty in a healthy mesh.
struct MeshHealth {
  /// The edges that have one triangle alone, where the surface ends, by their vertices. Together
  /// with those of the next list that have an odd number of triangles, they are topology()'s
  /// boundary edges.
  std::vector<FaultyEdge> open_edges;
  /// The edges that have more than two triangles.
  std::vector<FaultyEdge> non_manifold_edges;
  /// The edges at which triangles are wound inconsistently: at least two more go along the edge one
  /// way than the other, so that neighbours face opposite sides.
  std::vector<FaultyEdge> turned_edges;
  /// The triangles whose area is exactly zero.
  std::vector<std::uint32_t> degenerate_triangles;
  std::vector<DuplicateTriangle> duplicate_triangles;  ///< sorted by `triangle`
  /// The parts that should face outwards and do not, or the other way round; exactly, sorted by
  /// `triangle`. A part is connected across edges that have two triangles, and consistently wound.
  /// One that is closed by itself faces outwards if it encloses more than nothing. Others go
  /// together where they meet at edges of more triangles; if all of those are closed then, a part
  /// faces outwards if they enclose, by the even-odd rule, what is behind it and not what is before
  /// it. That says nothing of a part that one of them crosses or touches away from common edges and
  /// vertices, of one before and behind which is the same, and of what stays open: these are not
  /// listed. What crosses or touches a part is not counted where it is asked what it lies in.
  std::vector<InsideOutPart> inside_out_parts;
  /// All pairs of triangles that intersect, as find_self_pairs() finds them, duplicates among them.
  TrianglePairs self_intersections;

  /// True if nothing is in any list: the surface is closed, manifold at its edges, consistently
  /// wound with its front outside, and intersects itself nowhere.
  bool is_healthy() const;
  /// Returns how many entries there are in all lists.
  std::size_t fault_count() const;

  bool operator==(const MeshHealth&) const = default;
};

/// The settings of check().
struct CheckSettings {
  /// If set, called on the caller's thread about every half per cent of the way, with the number of
  /// triangles that are done and their total. What it throws ends the check.
  std::function<void(std::size_t done, std::size_t total)> on_progress = {};
};

/// Finds all that is wrong with a mesh, and where. It is exact, by combinatorics of welded
/// vertices, exact predicates, and exact signs of volumes; there is no epsilon. Most of the time
/// goes into looking for triangles that intersect: O(n log n) for compact meshes, and as much as
/// there are surfaces of the mesh around each of its parts.
MeshHealth check(const Mesh& mesh, const CheckSettings& settings = {}, Work* work = nullptr);

}  // namespace graze
