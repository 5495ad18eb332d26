#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/run/record/answer_record.h>

namespace graze::compare {

/// Where numbers in float would explain an answer.
enum class Single {
  Poses,       ///< poses rounded to float
  Vertices,    ///< poses and vertices
  Placed,      ///< vertices, once they are placed
  Arithmetic,  ///< its error is as small as computing in float makes it
};

/// So many ulp of float of the largest coordinate an answer in numbers may be off to be one of
/// single precision: as kTouchUlps of double.
inline constexpr double kSingleUlps = kTouchUlps;

/// What explains one wrong answer besides a bug.
struct Evidence {
  std::optional<Single> single;
  std::vector<std::uint32_t> flat_a;  ///< the first triangles of A without area
  std::vector<std::uint32_t> flat_b;
  std::size_t flat_count_a = 0;  ///< of these there are so many
  std::size_t flat_count_b = 0;
};

/// So many flat triangles of a mesh are named.
inline constexpr std::size_t kFlatNamed = 8;

/// Looks at the query of a wrong answer again. Of what are no two meshes nothing is known. Linear
/// in their triangles for those without area, else constant.
Evidence evidence_of(const Case& query, const AnswerRecord& answer);

}  // namespace graze::compare
