#pragma once

#include <optional>
#include <string>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/mesh_referee.h>

namespace graze::compare {

/// Something in an answer, beside its yes or number, that cannot be.
struct WitnessFault {
  std::string what;
  double error;  ///< metres
};

/// Whether the points of a distance lie on the placed surfaces and are as far apart as is said,
/// within kTouchUlps of the largest coordinate. Nothing if all is well, or no points are named.
std::optional<WitnessFault> fault_of_distance(const MeshReferee& referee, const CaseAnswer& answer);

/// What no definition of a contact allows: a normal that is no unit vector, a depth along it beyond
/// that by which a plane parts the meshes on either side, two points that are less far apart along
/// the normal than it is deep. Engines that compute in float are granted a part in 1e5 of the size.
/// What is left, such as which of the possible depths is meant, is not judged.
std::optional<WitnessFault> fault_of_contacts(const MeshReferee& referee, const CaseAnswer& answer);

}  // namespace graze::compare
