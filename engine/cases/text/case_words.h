#pragma once

#include <graze/engine/cases/case.h>

#include <array>
#include <utility>

namespace graze::cases {

/// The version of the format that is written, and the only one that is read.
inline constexpr std::uint32_t kCaseVersion = 1;

inline constexpr std::array<std::pair<const char*, Ask>, 14> kAsks = {{
    {"any", Ask::Any},
    {"pairs", Ask::Pairs},
    {"distance", Ask::Distance},
    {"within", Ask::Within},
    {"contacts", Ask::Contacts},
    {"intersection", Ask::Intersection},
    {"separation", Ask::Separation},
    {"ray", Ask::Ray},
    {"ray_all", Ask::RayAll},
    {"contains", Ask::Contains},
    {"self_any", Ask::SelfAny},
    {"self_pairs", Ask::SelfPairs},
    {"first_contact", Ask::FirstContact},
    {"free", Ask::Free},
}};

inline constexpr std::array<std::pair<const char*, Feature>, 3> kFeatures = {{
    {"vertex", Feature::Vertex},
    {"edge", Feature::Edge},
    {"face", Feature::Face},
}};

inline constexpr std::array<std::pair<const char*, RigidStatus>, 3> kStatuses = {{
    {"free", RigidStatus::Free},
    {"hit", RigidStatus::Hit},
    {"close", RigidStatus::Close},
}};

/// True if a question is about two things that move.
inline bool is_about_motion(Ask ask) {
  return ask == Ask::FirstContact || ask == Ask::Free;
}

/// True if a question is about A alone.
inline bool is_about_one(Ask ask) {
  return ask == Ask::SelfAny || ask == Ask::SelfPairs;
}

}  // namespace graze::cases
