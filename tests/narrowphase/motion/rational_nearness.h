#pragma once

// Law 12 with a clearance by its definition, in rational arithmetic: time falls into the roots of
// every polynomial that matters and the stretches between them; in each of these the hulls'
// distance at one time is measured.

#include <graze/narrowphase/first_contact.h>

namespace graze::oracle {

std::optional<FirstContact> rational_nearness(const PointPath& point, const TrianglePath& triangle,
                                              const FirstContactSettings& settings);
std::optional<FirstContact> rational_nearness(const EdgePath& a, const EdgePath& b,
                                              const FirstContactSettings& settings);

}  // namespace graze::oracle
