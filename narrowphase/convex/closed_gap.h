#pragma once

#include <graze/narrowphase/convex/core_gap.h>

namespace graze::narrowphase {

/// What core_gap() answers, by a formula where there is one: points and segments among themselves,
/// a point and a box.
CoreGap nearest(const Core& a, const Core& b, const GapGoal& goal = {});

/// Whether nearest() has a formula for these.
bool has_closed_gap(CoreKind a, CoreKind b);

}  // namespace graze::narrowphase
