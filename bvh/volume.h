#pragma once

#include <array>
#include <optional>

namespace graze {

/// The kinds of bounding volumes that lie over the nodes of a mesh's binary tree. No answer depends
/// on the choice (law 9): only the time does.
enum class Volume {
  Aabb,    ///< boxes in each mesh's own frame
  Sphere,  ///< minimal spheres: the cheapest test, the loosest fit
  Obb,     ///< a box for each node with axes of its own: the tightest fit, the dearest test
  KDop,    ///< 18 half-spaces in each mesh's own frame
};

/// All volumes, in their order.
inline constexpr std::array kVolumes{Volume::Aabb, Volume::Sphere, Volume::Obb, Volume::KDop};

/// The volumes that queries on two meshes can compare: a wide tree's boxes, or one of the above.
enum class PairVolume {
  WideObb,  ///< the default: oriented boxes, eight to a node, whose children share its axes
  Aabb,
  Sphere,
  Obb,
  KDop,
};

/// All volumes for pairs, in their order.
inline constexpr std::array kPairVolumes{PairVolume::WideObb, PairVolume::Aabb, PairVolume::Sphere,
                                         PairVolume::Obb, PairVolume::KDop};

/// Returns the volume's name on the command line: "obb" for Obb, "wide" for WideObb. Throws
/// InputError for what is none of the above.
const char* name_of(Volume volume);
const char* name_of(PairVolume volume);

/// Returns the Volume of the same name, or nothing for WideObb, which is no Volume. Throws
/// InputError for what is none of the above.
std::optional<Volume> binary_volume(PairVolume volume);

}  // namespace graze
