#pragma once

// What adaptors say of two shapes, from the numbers that their engines return.

#include <cstdint>
#include <optional>
#include <vector>

#include <graze/engine/cases/case.h>

namespace graze::compare {

/// Nothing of nothing.
inline std::optional<CaseAnswer> answer_of_distance(const std::optional<double>& distance) {
  std::optional<CaseAnswer> answer;
  if (distance) answer.emplace().distance = distance;
  return answer;
}

/// Of an engine that has no such question but a distance, as its users ask it.
inline std::optional<CaseAnswer> answer_of_within(const std::optional<double>& distance,
                                                  double clearance) {
  std::optional<CaseAnswer> answer;
  if (distance) answer.emplace().says = *distance <= clearance;
  return answer;
}

/// The way out that an engine's contacts show, as its users take it: B by the depth of the deepest
/// along its normal; none of two that do not meet.
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

/// Of an engine that names one time of a first contact at most, to Ask::FirstContact and Free.
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

/// A contact of which the engine names no features: each counts as one of its own.
inline void add_contact(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double depth,
                        std::vector<CaseShapeContact>& contacts) {
  const auto number = static_cast<std::uint32_t>(contacts.size());
  contacts.push_back({point, std::nullopt, std::nullopt, normal, depth, {number, number}});
}

}  // namespace graze::compare
