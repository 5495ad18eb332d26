#pragma once

#include "tests/narrowphase/motion/random_paths.h"

namespace graze::tests {

/// Four paths, and how near they may come, metres.
struct ClearanceQuery {
  PathQuery paths;
  double clearance;
};

/// Kinds of random queries: those of random_paths.h, and some where the clearance is reached in
/// passing, or always.
inline constexpr int kClearanceKinds = kPathKinds + 3;

/// Whether a rational oracle takes long.
bool is_long_clearance_kind(int kind);

/// The kind's name, for messages.
const char* name_of_clearance_kind(int kind);

ClearanceQuery random_clearance(int kind, RandomSource& source);

}  // namespace graze::tests
