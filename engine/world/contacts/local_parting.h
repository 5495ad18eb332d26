#pragma once

// Finds the shortest way on which a convex body leaves one triangle of a mesh. Private to
// engine/world.

#include <graze/engine/world/contacts/facing_features.h>
#include <graze/narrowphase/convex/core/core.h>

#include <cstdint>
#include <optional>

namespace graze {

/// The feature of a triangle that a body leaves.
enum class LeftFeature : std::uint8_t { Face, Edge, Corner };

/// The least translation that takes a body off a triangle along a direction that one of the
/// triangle's features faces.
struct LocalParting {
  std::uint32_t triangle;
  narrowphase::Exit exit;  ///< the exit of the body, away from the mesh
  LeftFeature feature = LeftFeature::Face;
  int which = 0;  ///< the first corner of the edge, or the corner
  /// True if an edge or a corner may have lost to the face only because of the share; else the exit
  /// is the same with a share of 1.
  bool is_close = false;
};

/// The cosine of 8 degrees: a face whose normal is that near to a way out has contacts along it.
inline constexpr double kNearlyFacing = 0.99;

/// A body that lies on a mesh leaves an edge or a corner instead of a face only if that way is
/// shorter than this share of the way off the face: a way that is shorter by a hair, where faces
/// lean by as little, would be a second way out beside theirs. Law 15 promises depths to a
/// twentieth.
inline constexpr double kFaceShare = 0.96;

/// Says how the exit off a triangle is chosen.
struct PartingSettings {
  /// An edge or a corner is left instead of the face if that way is shorter than this share of the
  /// way off the face.
  double face_share = 1;
  double margin = 0;  ///< metres, by which the body is grown; the share is of the depth without it
};

/// Finds the partings of triangles that touch the body and are no slivers. The features are local
/// maxima of the mesh in the directions that they face, so that the body also leaves what is around
/// the triangle. The body may be taken off the end of an edge that it has passed, and out of a flat
/// face only along its normal: so edges within a flat face have no effect.
class LocalPartings {
 public:
  LocalPartings(const narrowphase::Core& core, const FacingFeatures& features,
                const PartingSettings& settings = {})
      : core_(core), features_(features), settings_(settings) {}

  LocalParting of(std::uint32_t index, const narrowphase::Core& triangle) const;
  /// Returns the parting of a triangle, where the core's support point against the triangle's unit
  /// normal is known.
  LocalParting of(std::uint32_t index, const narrowphase::Core& triangle,
                  const narrowphase::Vec3& normal, const narrowphase::Vec3& deepest) const;

  /// Returns the parting if its depth is below the limit, or nothing where bounds show that it is
  /// not, which costs less than finding the depth.
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
