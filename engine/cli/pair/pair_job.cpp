#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/pair/answer_file.h>
#include <graze/engine/cli/pair/pair_job.h>
#include <graze/engine/cli/pair/pair_report.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/solid.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <utility>

namespace graze::cli {
namespace {

void check_output_combinations(const PairOptions& options) {
  if (!options.output) return;
  if (options.is_listing) {
    throw UsageError("--list and --output exclude each other: the file holds one answer a pose");
  }
  if (!options.check.empty()) {
    throw UsageError("--check fcl and --output exclude each other: differences are rows of text");
  }
}

void check_distance_combinations(const PairOptions& options) {
  if (options.query != "distance") return;
  if (!options.check.empty()) {
    throw UsageError("--check fcl needs --query any or pairs: distances are not compared");
  }
  if (options.is_solid || options.touch == "exclude" || options.volume != "wide") {
    throw UsageError(
        "--query distance is of surfaces: it takes no --solid, no --touch exclude and no --volume");
  }
}

void check_combinations(const PairOptions& options) {
  if (!options.pose_b.empty() && options.poses) {
    throw UsageError("--pose-b and --poses exclude each other: both place B");
  }
  if (options.poses && options.poses->empty()) {
    throw UsageError("--poses: the name of the file is empty");
  }
  if (options.is_listing && options.query == "any") {
    throw UsageError("--list needs --query pairs: --query any stops at the first pair it finds");
  }
  if (options.is_listing && options.query == "distance") {
    throw UsageError("--list needs --query pairs: --query distance finds the nearest pair alone");
  }
  if (!options.check.empty() && !has_fcl_check()) {
    throw UsageError("--check fcl: this command was built without FCL");
  }
  if (!options.check.empty() && options.touch == "exclude") {
    throw UsageError("--check fcl needs --touch include: FCL knows no other policy");
  }
  if (!options.check.empty() && options.is_solid) {
    throw UsageError("--check fcl and --solid exclude each other: FCL knows surfaces only");
  }
  const bool is_one_query_shared = options.query == "pairs" && options.volume == "wide";
  if (!options.threads.empty() && !options.output && !is_one_query_shared) {
    throw UsageError(
        "--threads needs --query pairs and --volume wide, or --output: no other query is shared");
  }
  check_output_combinations(options);
  check_distance_combinations(options);
}

/// Reads the poses of B, each of which can take it there.
std::shared_ptr<const compare::PoseSource> read_poses_b(const PairOptions& options,
                                                        const Mesh& mesh_b) {
  if (options.poses) return compare::pose_file(*options.poses, mesh_b.bounds());
  const Pose pose =
      options.pose_b.empty() ? Pose::Identity() : parse_pose(options.pose_b, "--pose-b");
  check_placement(pose, mesh_b.bounds(), "--pose-b");
  return compare::pose_list({pose});
}

PairVolume volume_named(const std::string& name) {
  for (const PairVolume volume : kPairVolumes) {
    if (name == name_of(volume)) return volume;
  }
  throw UsageError("--volume: there is no volume " + name);
}

PairQuery query_named(const std::string& name) {
  if (name == "any") return PairQuery::Any;
  return name == "distance" ? PairQuery::Distance : PairQuery::Pairs;
}

int threads_of(const PairOptions& options) {
  if (options.threads.empty()) return options.output ? 0 : 1;
  return static_cast<int>(parse_count(options.threads, "--threads", 0, kMaxThreads));
}

/// Refuses an output that would be in vain or destroy what is read.
void check_output_file(const PairOptions& options) {
  if (!options.output) return;
  const FilePlace output = {"--output", *options.output};
  const std::array<FilePlace, 3> inputs = {{{"mesh A", options.mesh_a},
                                            {"mesh B", options.mesh_b},
                                            {"the file of --poses", options.poses.value_or("")}}};
  check_outputs({&output, 1}, inputs);
}

void check_solids(const PairOptions& options, const PairJob& job) {
  if (job.interior != Interior::Solid) return;
  check_closed(job.mesh_a, ("--solid: " + options.mesh_a).c_str());
  check_closed(job.mesh_b, ("--solid: " + options.mesh_b).c_str());
}

/// Returns whether the meshes intersect, as solids or surfaces, with or without touching, as the
/// job says.
bool do_intersect(const PairJob& job, const Pose& pose_b, Work& work) {
  const PlacedMeshView a{job.mesh_a, job.pose_a}, b{job.mesh_b, pose_b};
  if (job.interior == Interior::Solid && job.touch == Touch::Exclude)
    return interiors_intersect(a, b, &work);
  const Hit of_surfaces = job.touch == Touch::Exclude ? Hit::Crossing : Hit::Touching;
  const Hit hit = job.interior == Interior::Solid ? Hit::Solid : of_surfaces;
  return intersects(a, b, {.volume = job.volume, .hit = hit}, &work);
}

void ask_for_pairs(const PairJob& job, const Pose& pose_b, int threads, PoseAnswer& answer) {
  const PlacedMeshView a{job.mesh_a, job.pose_a}, b{job.mesh_b, pose_b};
  answer.pairs =
      threads == 1
          ? find_triangle_pairs(a, b, {.volume = job.volume, .touch = job.touch}, &answer.work)
          : find_triangle_pairs(a, b, {.threads = threads, .touch = job.touch}, &answer.work);
  answer.intersects = !answer.pairs->empty();
  if (job.interior == Interior::Solid && (!answer.intersects || job.touch == Touch::Exclude))
    answer.intersects = do_intersect(job, pose_b, answer.work);
}

}  // namespace

PairJob read_pair_job(const PairOptions& options) {
  check_combinations(options);
  const int threads = threads_of(options);
  check_output_file(options);
  const Pose pose_a =
      options.pose_a.empty() ? Pose::Identity() : parse_pose(options.pose_a, "--pose-a");
  const Mesh mesh_a = load_mesh(options.mesh_a);
  // One file gives one mesh, so that its tree is shared, too.
  const Mesh mesh_b = options.mesh_b == options.mesh_a ? mesh_a : load_mesh(options.mesh_b);
  check_placement(pose_a, mesh_a.bounds(), "--pose-a");
  PairJob job = {mesh_a,
                 mesh_b,
                 pose_a,
                 read_poses_b(options, mesh_b),
                 query_named(options.query),
                 volume_named(options.volume),
                 options.touch == "exclude" ? Touch::Exclude : Touch::Include,
                 options.is_solid ? Interior::Solid : Interior::Surface,
                 threads,
                 nullptr};
  check_solids(options, job);
  if (!options.check.empty()) job.fcl = make_fcl_check(mesh_a, mesh_b);
  return job;
}

PoseAnswer ask(const PairJob& job, const Pose& pose_b, int threads) {
  PoseAnswer answer;
  const auto start = std::chrono::steady_clock::now();
  if (job.query == PairQuery::Any) {
    answer.intersects = do_intersect(job, pose_b, answer.work);
  } else if (job.query == PairQuery::Distance) {
    answer.gap = distance({job.mesh_a, job.pose_a}, {job.mesh_b, pose_b}, {}, &answer.work);
    answer.intersects = answer.gap->distance == 0;
  } else {
    ask_for_pairs(job, pose_b, threads, answer);
  }
  answer.time = std::chrono::steady_clock::now() - start;
  if (job.fcl && job.query == PairQuery::Any) {
    answer.fcl = job.fcl->check_any(answer.intersects, job.pose_a, pose_b);
  } else if (job.fcl) {
    answer.fcl = job.fcl->check_pairs(*answer.pairs, job.pose_a, pose_b);
  }
  return answer;
}

namespace {

/// Reports answers as they come, a row each.
ExitCode report_answers(const PairJob& job, const PairOptions& options, Output& output) {
  const PairReportSettings settings = {
      .query = job.query, .is_listing = options.is_listing, .is_checked = job.fcl != nullptr};
  const std::unique_ptr<PairReport> report =
      options.is_json ? make_json_report(output, settings) : make_table_report(output, settings);
  Progress progress("poses:", job.poses_b->size(), {.is_forced = options.has_progress});

  bool is_graze_wrong = false;
  try {
    report->begin();
    for (std::size_t i = 0; i < job.poses_b->size(); ++i) {
      PoseAnswer answer = ask(job, job.poses_b->at(i), job.threads);
      answer.pose = i;
      is_graze_wrong |= answer.fcl && answer.fcl->graze_wrong > 0;
      report->add(answer);
      progress.update(i + 1);
    }
    report->end();
  } catch (const OutputClosed&) {
    // The reader has all that it wanted, but a wrong answer stays one.
  }
  return is_graze_wrong ? ExitCode::GrazeWrong : ExitCode::Answered;
}

/// Writes answers to a file, and reports what they come to.
ExitCode file_answers(const PairJob& job, const PairOptions& options, Output& output) {
  Progress progress("poses:", job.poses_b->size(),
                    {.is_forced = options.has_progress, .has_rows = false});
  const AnswerTotals totals = write_answers(
      job, *options.output, [&](std::size_t done, std::size_t) { progress.update(done); });
  try {
    output.write(options.is_json ? to_json(totals, *options.output)
                                 : to_text(totals, *options.output));
  } catch (const OutputClosed&) {
    // The file stands, though nobody reads of it.
  }
  return ExitCode::Answered;
}

}  // namespace

ExitCode run_pair(const PairOptions& options, Output& output) {
  const PairJob job = read_pair_job(options);
  return options.output ? file_answers(job, options, output) : report_answers(job, options, output);
}

}  // namespace graze::cli
