#pragma once

#include <graze/narrowphase/verdict.h>

namespace graze::narrowphase {

/// The triangle's normal and the nine cross products of edges, of the thirteen axes of
/// Akenine-Möller's test, in rounded arithmetic; apart from them the two must overlap. Takes the
/// triangle's nine coordinates, the box's minimum and maximum, and the sum of the absolute values
/// of all fifteen, which is finite.
Verdict triage_remaining_axes(const double* t, const double* low, const double* high, double size);

}  // namespace graze::narrowphase
