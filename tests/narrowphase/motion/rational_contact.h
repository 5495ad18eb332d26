#pragma once

// Law 12 by its definition, in rational arithmetic: time falls into the roots of every polynomial
// that matters and the stretches between them; in each of these it is asked whether the hulls share
// a point.

#include <graze/narrowphase/first_contact.h>

#include <string>

namespace graze::oracle {

std::optional<FirstContact> rational_first_contact(const PointPath& point,
                                                   const TrianglePath& triangle,
                                                   StartContact start);
std::optional<FirstContact> rational_first_contact(const EdgePath& a, const EdgePath& b,
                                                   StartContact start);

/// All digits, for messages.
std::string text_of(const std::optional<FirstContact>& contact);
std::string text_of(const PointPath& path);
std::string text_of(const EdgePath& path);
std::string text_of(const TrianglePath& path);

}  // namespace graze::oracle
