#pragma once

#include <graze/bvh/wide/wide_front.h>

namespace graze::bvh {

/// Looks at what is due in a front: what has a deadline up to `due`, and what is busy. Private to
/// bvh/wide.
void pass_over(WideFront::State& state, const WideFront::Pass& pass, float limit, float due);

}  // namespace graze::bvh
