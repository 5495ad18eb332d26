#pragma once

#include <graze/narrowphase/convex/core.h>

#include <optional>

namespace graze::narrowphase {

enum class CcdMethod { ExpandingPolytope, PortalRefinement };

/// The one function behind which libccd lives: a unit direction from A to B along which two
/// overlapping cores part soon; nothing if libccd fails, that is, finds no overlap, runs out of
/// memory or of kCcdBudget, or answers with what is not a number. libccd compares with absolute
/// epsilons, so it is given the cores in units of the smaller one's reach.
std::optional<Vec3> ask_ccd(const Core& a, const Core& b, CcdMethod method);

}  // namespace graze::narrowphase
