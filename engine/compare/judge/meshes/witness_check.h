#pragma once

#include <optional>
#include <string>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>

namespace graze::compare {

/// Describes something in an answer, beside its yes or number, that cannot be.
struct WitnessFault {
  std::string what;
  double error;  ///< metres
};

/// Checks whether the points of a distance lie on the placed surfaces, those of the pair if one is
/// named, and are as far apart as is said, within kTouchUlps of the largest coordinate; and whether
/// the pair that is named is as near as any, within `tolerance`. Returns nothing if all is well, or
/// nothing is named.
std::optional<WitnessFault> fault_of_distance(const MeshReferee& referee,
                                              const MeshReferee::Gap& nearest,
                                              const CaseAnswer& answer, double tolerance);

}  // namespace graze::compare
