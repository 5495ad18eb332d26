#pragma once

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>
#include <graze/engine/cli/pair/pair_options.h>

namespace graze::cli {

/// Answers for each pose. All input is read and checked before the first query, so that bad input
/// leaves standard output empty. Throws UsageError, PoseError, MeshError or FileError.
ExitCode run_pair(const PairOptions& options, Output& output);

}  // namespace graze::cli
