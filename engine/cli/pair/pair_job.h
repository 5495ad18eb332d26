#pragma once

#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/output.h>
#include <graze/engine/cli/pair/fcl_check.h>
#include <graze/engine/cli/pair/pair_answer.h>
#include <graze/engine/cli/pair/pair_options.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/mesh/interior.h>
#include <graze/engine/mesh/mesh.h>

#include <memory>

namespace graze::cli {

/// Holds everything that the queries need.
struct PairJob {
  Mesh mesh_a;
  Mesh mesh_b;
  Pose pose_a;
  std::shared_ptr<const compare::PoseSource> poses_b;  ///< poses of B; those of a file stay in the
                                                       ///< file
  PairQuery query;
  PairVolume volume;
  Touch touch;
  Interior interior;
  int threads;  ///< threads of each query, or of all together where their answers go to a file
  std::unique_ptr<FclCheck> fcl;
};

/// Reads and checks all input. Throws UsageError, PoseError, MeshError or FileError.
PairJob read_pair_job(const PairOptions& options);

/// Asks about one pose of B, on so many threads. Many threads may ask at once.
PoseAnswer ask(const PairJob& job, const Pose& pose_b, int threads);

/// Prints answers for each pose. All input is read and checked before the first query, so that bad
/// input leaves standard output empty. Throws UsageError, PoseError, MeshError or FileError.
ExitCode run_pair(const PairOptions& options, Output& output);

}  // namespace graze::cli
