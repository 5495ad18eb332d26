#pragma once

#include <graze/narrowphase/motion/paths.h>

namespace graze::narrowphase {

// These functions return what first_contact() answers, for finite coordinates, computed as the
// thread computes. Contacts later than `until`, from 0 to 1, may be left out.

std::optional<FirstContact> first_contact_of(const PointPath& point, const TrianglePath& triangle,
                                             const FirstContactSettings& settings,
                                             double until = 1);
std::optional<FirstContact> first_contact_of(const EdgePath& a, const EdgePath& b,
                                             const FirstContactSettings& settings,
                                             double until = 1);
std::optional<FirstContact> first_contact_of(const TrianglePath& a, const TrianglePath& b,
                                             const FirstContactSettings& settings);

/// Asks the exact stage alone about [from, 1]; a contact at 0 counts only for `from` = 0.
std::optional<FirstContact> first_contact_exactly(const FourPaths& paths,
                                                  const FirstContactSettings& settings,
                                                  double from = 0);

}  // namespace graze::narrowphase
