#pragma once

#include <array>

namespace graze {

/// Which bounding volumes a query compares. All of them lie over one tree, and no answer depends on
/// the choice (law 9): only the time does.
enum class Volume {
  Wide,  ///< oriented boxes, eight to a node, that share its axes: the default. Only queries on two
         ///< meshes have them; others use Aabb instead
  Aabb,  ///< boxes in each mesh's own frame
  Sphere,  ///< minimal spheres: the cheapest test, the loosest fit
  Obb,     ///< a box for each node with axes of its own: the tightest fit, the dearest test
  KDop,    ///< 18 half-spaces in each mesh's own frame
  // Cascades: the sphere first, and the tighter volume where spheres overlap.
  SphereThenAabb,
  SphereThenObb,
  SphereThenKDop,
};

inline constexpr std::array kVolumes{
    Volume::Wide, Volume::Aabb,           Volume::Sphere,        Volume::Obb,
    Volume::KDop, Volume::SphereThenAabb, Volume::SphereThenObb, Volume::SphereThenKDop};

/// Its name on the command line: "sphere-obb" for SphereThenObb. Throws InputError for what is none
/// of kVolumes.
const char* name_of(Volume volume);

}  // namespace graze
