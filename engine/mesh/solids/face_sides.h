#pragma once

// This is private to engine/mesh.

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/mesh/query/wide_query.h>
#include <graze/narrowphase/predicates/predicates.h>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace graze {

/// Tells on which side of its triangles a placed closed mesh lies, for those that are asked about;
/// each is looked at once.
class FaceSides {
 public:
  FaceSides(const PlacedMeshView& placed, Work& work)
      : placed_(placed), triangles_(placed), work_(work) {}

  const PlacedMeshView& placed() const { return placed_; }
  Triangle triangle(std::uint32_t index) const { return triangles_[index]; }
  /// True if the placed triangle has an area.
  bool has_area(std::uint32_t index) const;

  /// Returns the lowest other triangle of the mesh that has area and meets the inside of this one,
  /// which has area. Returns nothing if there is none: then the mesh lies on one side of it, which
  /// is the same all over its inside.
  std::optional<std::uint32_t> intruder(std::uint32_t index);

  /// Returns the triangles of a mesh, perhaps the same, that share a point with this one,
  /// ascending.
  std::vector<std::uint32_t> meeting(std::uint32_t index, const FaceSides& of) const;

  /// Says whether the mesh encloses what is beside the inside of a triangle that has area, near its
  /// first corner: above, where its normal points, and below.
  struct Enclosed {
    bool above;
    bool below;

    /// Returns where the mesh lies, if on one side alone: Positive for above. Else returns Zero.
    narrowphase::Sign side() const {
      using narrowphase::Sign;
      return above == below ? Sign::Zero : above ? Sign::Positive : Sign::Negative;
    }
  };
  Enclosed enclosed(std::uint32_t index);

 private:
  const PlacedMeshView& placed_;
  PlacedTriangles triangles_;
  Work& work_;
  std::unordered_map<std::uint32_t, std::optional<std::uint32_t>> intruders_;
  std::unordered_map<std::uint32_t, Enclosed> enclosed_;
};

}  // namespace graze
