#pragma once

// Makes answers of adaptors about two shapes from the numbers that their engines return.

#include <cstdint>
#include <optional>
#include <vector>

#include <graze/engine/cases/case.h>

namespace graze::compare {

/// Returns the answer of a distance; nothing if there is none.
inline std::optional<CaseAnswer> answer_of_distance(const std::optional<double>& distance) {
  std::optional<CaseAnswer> answer;
  if (distance) answer.emplace().distance = distance;
  return answer;
}

/// Returns the answer of an engine that has no such question but a distance, as its users ask it.
inline std::optional<CaseAnswer> answer_of_within(const std::optional<double>& distance,
                                                  double clearance) {
  std::optional<CaseAnswer> answer;
  if (distance) answer.emplace().says = *distance <= clearance;
  return answer;
}

/// Returns the way out that an engine's contacts show, as its users take it: B goes by the depth of
/// the deepest along its normal; not at all if the two do not meet.
inline CaseAnswer answer_of_separation(const std::vector<CaseShapeContact>& contacts) {
  CaseAnswer answer;
  answer.distance = 0;
  answer.translation = Eigen::Vector3d(0, 0, 0);
  for (const CaseShapeContact& contact : contacts) {
    if (contact.depth <= *answer.distance) continue;
    answer.distance = contact.depth;
    answer.translation = contact.depth * contact.normal;
  }
  return answer;
}

/// Returns the answer of an engine that names one time of a first contact at most, to
/// Ask::FirstContact and Free.
inline CaseAnswer answer_of_motion(Ask ask, const std::optional<double>& contact) {
  CaseAnswer answer;
  if (ask == Ask::Free) {
    answer.says = !contact;
    return answer;
  }
  answer.status = contact ? RigidStatus::Hit : RigidStatus::Free;
  answer.low = contact.value_or(1);
  answer.high = answer.low;
  return answer;
}

/// Adds a contact of which the engine names no features: each counts as one of its own.
inline void add_contact(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double depth,
                        std::vector<CaseShapeContact>& contacts) {
  const auto number = static_cast<std::uint32_t>(contacts.size());
  contacts.push_back({point, std::nullopt, std::nullopt, normal, depth, {number, number}});
}

}  // namespace graze::compare
