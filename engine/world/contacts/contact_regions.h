#pragma once

// Finds the regions in which a convex body and a mesh meet, each with its way out. Private to
// engine/world.

#include <graze/engine/world/contacts/clearance.h>
#include <graze/engine/world/contacts/local_parting.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// A triangle that a body touches, and how the body leaves it.
struct TouchedTriangle {
  LocalParting parting;
  narrowphase::Core triangle;
  double rank;                  ///< metres; exits are taken in ascending order of ranks, faces
                                ///< before edges
  std::uint32_t direction = 0;  ///< the number of the direction of the way out
  std::uint32_t region = 0;
};

/// True if the sine between two directions is below about 1e-6, so that they count as one.
inline bool is_one_direction(const narrowphase::Vec3& s, const narrowphase::Vec3& t) {
  return dot(s, t) > 1 - 5e-13;
}

/// Returns the member that stands for a region: the deepest face, or the deepest of all if there is
/// no face. Directions that count as one differ enough to make others a little deeper.
const TouchedTriangle& speaker_of(std::span<const TouchedTriangle> members);

/// Finds which of the touched triangles are in the way, and how they are connected. By law 15 the
/// triangles are looked at in the order of their depth. A triangle that the body no longer touches
/// once it has taken all ways out so far, by the least translation that does so, makes no contact:
/// so the wall below a rim that a box rests on makes none. One that is left as those before, but
/// for the tolerance of exits, does make one. Triangles that are left in one direction and share
/// corners are a region.
class ContactRegions {
 public:
  /// Leaves only the triangles in `touched` that are in the way, and numbers their directions. If
  /// no triangle reaches into the body, which then touches by a tolerance alone, the triangle that
  /// comes nearest to it is left, so that a body that touches has a region. `is_apart(translation,
  /// triangle)` says whether the body, moved by the translation, is apart from the triangle; `size`
  /// is the body's.
  template <typename IsApart>
  void select(std::vector<TouchedTriangle>& touched, double size, IsApart&& is_apart) {
    start(touched, size);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < touched.size(); ++i) {
      TouchedTriangle& next = touched[i];
      const narrowphase::Exit& exit = next.parting.exit;
      const bool is_satisfied = clearance_.satisfies(exit);
      const bool is_cleared = is_satisfied
                                  ? !is_known(exit.direction)
                                  : kept > 0 && is_apart(clearance_.translation(), next.triangle);
      std::optional<std::uint32_t> direction;
      if (is_cleared) {
        direction = number_as_deep(next.parting);
        if (!direction || is_apart(short_of(exit), next.triangle)) continue;
      }
      if (!is_satisfied) clearance_.add(exit);
      next.direction = direction ? *direction : number_of(exit.direction);
      if (kept != i) touched[kept] = next;
      ++kept;
    }
    if (kept == 0 && !touched.empty()) {
      touched[0] = touched.back();
      touched[0].direction = number_of(touched[0].parting.exit.direction);
      kept = 1;
    }
    touched.resize(kept);
  }

  /// Numbers the regions, which are triangles of one direction that are connected by corners, and
  /// returns how many there are. The triangles of a region follow each other, ascending by depth.
  std::uint32_t connect(std::vector<TouchedTriangle>& touched, const FacingFeatures& features);

 private:
  struct CornerOf {
    std::uint32_t direction;
    std::uint32_t vertex;
    std::uint32_t member;
  };

  void start(std::vector<TouchedTriangle>& touched, double size);
  bool is_known(const narrowphase::Vec3& direction) const;
  std::uint32_t number_of(const narrowphase::Vec3& direction);
  /// Returns the number of the direction of an exit before that is the same as that of an edge or a
  /// corner, but for the tolerance of the search; nothing if there is none.
  std::optional<std::uint32_t> number_as_deep(const LocalParting& parting) const;
  /// Returns the translation so far, less what exits that are the same differ by.
  narrowphase::Vec3 short_of(const narrowphase::Exit& exit) const {
    return clearance_.translation() - exit.direction * negligible_;
  }
  std::uint32_t root_of(std::uint32_t member);

  Clearance clearance_;
  double negligible_ = 0;  ///< metres, by which depths of exits differ that are the same
  std::vector<narrowphase::Vec3> directions_;
  std::vector<CornerOf> corners_;
  std::vector<std::uint32_t> parent_;
};

}  // namespace graze
