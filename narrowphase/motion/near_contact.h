#pragma once

// Finds when two hulls whose points go straight come as near as a clearance.

#include <graze/narrowphase/motion/paths.h>

namespace graze::narrowphase {

/// Answers as first_contact_of() does, for settings with a clearance that is not 0.
std::optional<FirstContact> near_contact(const FourPaths& paths,
                                         const FirstContactSettings& settings, double until = 1);

/// Asks the exact stage alone.
std::optional<FirstContact> near_contact_exactly(const FourPaths& paths,
                                                 const FirstContactSettings& settings);

/// Asks the rounded stage: true only if the hulls are further apart than the clearance at all
/// times from 0 to `until`.
bool are_surely_further(const FourPaths& paths, double clearance, double until);

}  // namespace graze::narrowphase
