#pragma once

#include "tests/narrowphase/motion/random_paths.h"

namespace graze::tests {

/// Four paths, and how near they may come, metres.
struct SeparationQuery {
  PathQuery paths;
  double separation;
};

/// Kinds of random queries: those of random_paths.h, and some where the separation is reached in
/// passing, or always.
inline constexpr int kSeparationKinds = kPathKinds + 3;

/// Whether a rational oracle takes long.
bool is_long_separation_kind(int kind);

/// The kind's name, for messages.
const char* name_of_separation_kind(int kind);

SeparationQuery random_separation(int kind, RandomSource& source);

}  // namespace graze::tests
