#pragma once

#include <graze/narrowphase/convex/core/core.h>

#include <optional>

namespace graze::narrowphase {

/// How many support points libccd may ask for. Its loops have no end of their own where rounding
/// keeps them from their tolerance.
inline constexpr int kCcdBudget = 1000;

/// The one function behind which libccd lives: a unit direction from A to B along which two
/// overlapping sets part soon, by MPR; nothing if libccd fails, that is, finds no overlap, spends
/// kCcdBudget, or answers with what is not a number. libccd compares with absolute epsilons, so it
/// is given the sets in units of the smaller one's size.
/// Snethen, "XenoCollide", Game Programming Gems 7 (2008).
std::optional<Vec3> ask_ccd(const Core& a, const Core& b);

}  // namespace graze::narrowphase
