#pragma once

#include <graze/engine/compare/judge/shrink/shrink.h>

namespace graze::compare {

/// Makes a query about two bodies as small as it can while `is_still_wrong` holds: meshes lose
/// triangles and hulls corners (take_away()), poses are dropped or lose their rotation, and numbers
/// the digits that do not matter. Every shape of the result is the same when it is read from a
/// file, where hulls and normals are rounded once more. A query of which that is not to be had
/// without losing what it shows comes back as it is.
Case shrink_bodies(const Case& query, const StillWrong& is_still_wrong);

}  // namespace graze::compare
