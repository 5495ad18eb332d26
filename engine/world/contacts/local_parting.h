#pragma once

// How a convex body leaves one triangle of a mesh soonest. Private to engine/world.

#include <graze/engine/world/contacts/facing_features.h>
#include <graze/narrowphase/convex/core/core.h>

#include <cstdint>
#include <optional>

namespace graze {

/// What of a triangle a body leaves.
enum class LeftFeature : std::uint8_t { Face, Edge, Corner };

/// The least translation that takes a body off a triangle along a direction that one of the
/// triangle's features faces.
struct LocalParting {
  std::uint32_t triangle;
  narrowphase::Exit exit;  ///< of the body, away from the mesh
  LeftFeature feature = LeftFeature::Face;
  int which = 0;  ///< of an edge its first corner; of a corner itself
  /// Whether an edge or a corner may have lost to the face by its share alone: else the exit is the
  /// same with a share of 1.
  bool is_close = false;
};

/// A face is nearly at right angles to a way out within 8 degrees: then it has contacts along it.
inline constexpr double kNearlyFacing = 0.99;

/// Of a body that lies on a mesh an edge or a corner is left instead of a face only where that is
/// shorter than this share of it: one that is shorter by a hair, where faces lean by as little,
/// would be a second way out beside theirs. Law 15's depths are to a twentieth.
inline constexpr double kFaceShare = 0.96;

/// How the exit off a triangle is chosen.
struct PartingSettings {
  /// An edge or a corner is left instead of the face where that is shorter than this share of it.
  double face_share = 1;
  double margin = 0;  ///< metres, by which the body is grown: the share is of the depth without it
};

/// For triangles that touch the body and are no slivers. The directions that features face are
/// local maxima of the mesh, so that what is around the triangle is left as well. The body may be
/// taken off the end of an edge that it has passed, and out of a flat face only along its normal:
/// so edges within a flat face mean nothing.
class LocalPartings {
 public:
  LocalPartings(const narrowphase::Core& core, const FacingFeatures& features,
                const PartingSettings& settings = {})
      : core_(core), features_(features), settings_(settings) {}

  LocalParting of(std::uint32_t index, const narrowphase::Core& triangle) const;
  /// The same, where the core's support point against the triangle's unit normal is known.
  LocalParting of(std::uint32_t index, const narrowphase::Core& triangle,
                  const narrowphase::Vec3& normal, const narrowphase::Vec3& deepest) const;

  /// The same if its depth is below the limit; nothing where bounds show that it is not, which
  /// costs less than to find out how deep it is.
  std::optional<LocalParting> below(double limit, std::uint32_t index,
                                    const narrowphase::Core& triangle,
                                    const narrowphase::Vec3& normal,
                                    const narrowphase::Vec3& deepest) const;

  static narrowphase::Vec3 normal_of(const narrowphase::Core& triangle);

 private:
  const narrowphase::Core& core_;
  const FacingFeatures& features_;
  PartingSettings settings_;
};

}  // namespace graze
