#pragma once

// When two hulls whose points go straight come as near as a separation.

#include <graze/narrowphase/motion/paths.h>

namespace graze::narrowphase {

/// As first_contact_of(), for settings with a separation that is not 0.
std::optional<FirstContact> near_contact(const FourPaths& paths,
                                         const FirstContactSettings& settings, double until = 1);

/// The exact stage alone.
std::optional<FirstContact> near_contact_exactly(const FourPaths& paths,
                                                 const FirstContactSettings& settings);

/// The rounded stage: true only if the hulls are further apart than that at all times from 0 to
/// `until`.
bool are_surely_further(const FourPaths& paths, double separation, double until);

}  // namespace graze::narrowphase
