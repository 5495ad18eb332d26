#pragma once

// These are the parts of a surface that face the wrong way. They are private to the library.

#include <graze/engine/mesh/health/mesh_parts.h>
#include <graze/engine/mesh/mesh_health.h>

#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

namespace graze {

/// Which parts of a mesh cross or touch.
struct CrossedParts {
  std::unordered_set<std::uint64_t> surfaces;  ///< the pairs of closed surfaces that do so
  std::unordered_set<std::uint32_t> parts;     ///< those that others of their own surface, or they
                                               ///< themselves, cross or touch

  /// Notes a pair of triangles that intersect.
  void note(TrianglePair pair, const MeshParts& of);
  bool are_met(std::uint32_t surface_a, std::uint32_t surface_b) const;
  bool meets_any(std::uint32_t surface) const;
};

/// Returns what MeshHealth says of inside_out_parts.
std::vector<InsideOutPart> inside_out_parts(const Mesh& mesh, const MeshParts& parts,
                                            const CrossedParts& crossed, Work& work);

/// Returns the lowest triangle of the first part that is surely inside out, or nothing: one that
/// another crosses or touches may be a cavity that touches its shell. It is computed when it is
/// first asked for, in O(n log n) if all parts face the right way, else in the time of check(). At
/// each edge as many triangles must go one way as the other (Orientation::unpaired).
std::optional<std::uint32_t> first_inside_out(const Mesh& mesh);

}  // namespace graze
