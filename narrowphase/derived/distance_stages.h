#pragma once

#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/verdict.h>

namespace graze::narrowphase {

/// What distance() answers, and which stage found the features and the numbers: Triage only if no
/// exact stage was asked for either.
struct StagedDistance {
  TriangleDistance result;
  Stage stage;
};

StagedDistance decide_distance(const Triangle& triangle_a, const Triangle& triangle_b);

/// By the exact stages alone.
TriangleDistance distance_exactly(const Triangle& triangle_a, const Triangle& triangle_b);

}  // namespace graze::narrowphase
