#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/run/record/answer_record.h>

namespace graze::compare {

/// Says where numbers in float would explain an answer.
enum class Single {
  Poses,       ///< poses rounded to float
  Vertices,    ///< poses and vertices
  Placed,      ///< vertices, once they are placed
  Arithmetic,  ///< the answer's error is as small as computing in float makes it
};

/// An answer may be off by this many ulp of float of the largest coordinate to be one of single
/// precision, as by kTouchUlps of double.
inline constexpr double kSingleUlps = kTouchUlps;

/// Holds what explains one wrong answer besides a bug.
struct Evidence {
  std::optional<Single> single;
  std::vector<std::uint32_t> flat_a;  ///< the first triangles of A without area
  std::vector<std::uint32_t> flat_b;
  std::size_t flat_count_a = 0;  ///< the number of all of these
  std::size_t flat_count_b = 0;
};

/// At most so many flat triangles of a mesh are named.
inline constexpr std::size_t kFlatNamed = 8;

/// Looks at the query of a wrong answer again. Nothing is known unless it is about two meshes.
/// Finding triangles without area takes linear time in all triangles, the rest constant time.
Evidence evidence_of(const Case& query, const AnswerRecord& answer);

}  // namespace graze::compare
