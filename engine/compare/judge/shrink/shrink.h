#pragma once

#include <graze/engine/cases/case.h>

#include <functional>

namespace graze::compare {

/// True if a smaller query still shows what is to be shown.
using StillWrong = std::function<bool(const Case&)>;

/// Thrown by StillWrong to end the search: the smallest query so far is then the result.
class ShrinkingStopped {};

struct ShrinkSettings {
  /// Called once, before all that may take long: where the two triangles of the culprit alone do
  /// not show it, and before the first question about bodies.
  std::function<void()> before_search = {};
};

/// Makes a query about two meshes or bodies as small as it can while `is_still_wrong` holds, and
/// asks that of every query that it returns: a query that shows no disagreement is never a result.
/// First the two triangles of `culprit`, placed, without poses; then the same with their poses;
/// else those of each mesh that are nearest to it, four times as many each time, until they show
/// it; and from these, or from all, triangles are taken away (take_away()). At last coordinates
/// lose the digits that do not matter. For bodies see shrink_bodies(); other queries come back as
/// they are.
Case shrink(const Case& query, const std::optional<TrianglePair>& culprit,
            const StillWrong& is_still_wrong, const ShrinkSettings& settings = {});

/// Makes a query about two bodies as small as it can while `is_still_wrong` holds: meshes lose
/// triangles and hulls corners (take_away()), poses are dropped or lose their rotation, and numbers
/// the digits that do not matter. Every shape of the result is the same when it is read from a
/// file, where hulls and normals are rounded once more. A query that cannot be made so without
/// losing what it shows comes back as it is.
Case shrink_bodies(const Case& query, const StillWrong& is_still_wrong);

}  // namespace graze::compare
