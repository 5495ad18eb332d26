#pragma once

#include <graze/bvh/wide/front/wide_front.h>

namespace graze::bvh {

/// Pairs that are further apart than `limit` and whose budget outlasts `due` are skipped.
struct FrontHorizon {
  float limit;  ///< common units
  float due;    ///< the motion spent, as budgets are
};

/// What an update of a front looks at.
struct FrontTask {
  FrontHorizon must;        ///< what it has to compare
  FrontHorizon look_ahead;  ///< what it may compare for later passes, as in WideFront::Foresight
  float useful;             ///< likewise
  std::size_t most_added;   ///< likewise
};

/// Looks at what is due in a front, and at what is busy. Private to bvh/wide.
void update_front(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task);

}  // namespace graze::bvh
