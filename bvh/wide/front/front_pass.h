#pragma once

#include <graze/bvh/wide/front/wide_front.h>

namespace graze::bvh {

/// What is further apart than `limit`, and has a budget after `due`, need not be looked at.
struct FrontHorizon {
  float limit;
  float due;
};

/// What a pass looks at: what it `must`, and what is within `reach`, as in WideFront::Foresight.
struct FrontTask {
  FrontHorizon must;
  FrontHorizon reach;
  float useful;
  std::size_t most_added;
};

/// Looks at what is due in a front, and at what is busy. Private to bvh/wide.
void update_front(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task);

}  // namespace graze::bvh
