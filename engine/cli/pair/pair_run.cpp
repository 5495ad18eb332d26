#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/pair/fcl_check.h>
#include <graze/engine/cli/pair/pair_report.h>
#include <graze/engine/cli/pair/pair_run.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/inside/solid.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace graze::cli {
namespace {

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
  if (!options.check.empty() && !has_fcl_check()) {
    throw UsageError("--check fcl: this command was built without FCL");
  }
  if (!options.check.empty() && options.touch == "exclude") {
    throw UsageError("--check fcl needs --touch include: FCL knows no other policy");
  }
  if (!options.check.empty() && options.is_solid) {
    throw UsageError("--check fcl and --solid exclude each other: FCL knows surfaces only");
  }
  if (!options.threads.empty() && (options.query == "any" || options.volume != "wide")) {
    throw UsageError("--threads needs --query pairs and --volume wide: no other query is shared");
  }
}

/// The poses of B, with line 0 for one that comes from the command line.
std::vector<PoseLine> read_poses_b(const PairOptions& options) {
  if (options.poses) return load_pose_lines(*options.poses);
  if (!options.pose_b.empty()) return {{parse_pose(options.pose_b, "--pose-b"), 0}};
  return {{Pose::Identity(), 0}};
}

PairVolume volume_named(const std::string& name) {
  for (const PairVolume volume : kPairVolumes) {
    if (name == name_of(volume)) return volume;
  }
  throw UsageError("--volume: there is no volume " + name);
}

/// Everything that the queries need.
struct PairJob {
  Mesh mesh_a;
  Mesh mesh_b;
  Pose pose_a;
  std::vector<PoseLine> poses_b;
  PairQuery query;
  PairVolume volume;
  Touch touch;
  Interior interior;
  int threads;
  std::unique_ptr<FclCheck> fcl;
};

/// Refuses poses that move a mesh out of the range of double, before the first query would.
void check_placements(const PairOptions& options, const PairJob& job) {
  check_placement(job.pose_a, job.mesh_a.bounds(), "--pose-a");
  for (const PoseLine& pose : job.poses_b) {
    const std::string place =
        pose.line == 0 ? "--pose-b" : *options.poses + ":" + std::to_string(pose.line);
    check_placement(pose.pose, job.mesh_b.bounds(), place.c_str());
  }
}

void check_solids(const PairOptions& options, const PairJob& job) {
  if (job.interior != Interior::Solid) return;
  check_closed(job.mesh_a, ("--solid: " + options.mesh_a).c_str());
  check_closed(job.mesh_b, ("--solid: " + options.mesh_b).c_str());
}

PairJob read_job(const PairOptions& options) {
  check_combinations(options);
  const int threads =
      options.threads.empty()
          ? 1
          : static_cast<int>(parse_count(options.threads, "--threads", 0, kMaxThreads));
  const Pose pose_a =
      options.pose_a.empty() ? Pose::Identity() : parse_pose(options.pose_a, "--pose-a");
  std::vector<PoseLine> poses_b = read_poses_b(options);
  const Mesh mesh_a = load_mesh(options.mesh_a);
  // One file, one mesh: the tree is then shared too.
  const Mesh mesh_b = options.mesh_b == options.mesh_a ? mesh_a : load_mesh(options.mesh_b);
  PairJob job = {mesh_a,
                 mesh_b,
                 pose_a,
                 std::move(poses_b),
                 options.query == "any" ? PairQuery::Any : PairQuery::Pairs,
                 volume_named(options.volume),
                 options.touch == "exclude" ? Touch::Exclude : Touch::Include,
                 options.is_solid ? Interior::Solid : Interior::Surface,
                 threads,
                 nullptr};
  check_placements(options, job);
  check_solids(options, job);
  if (!options.check.empty()) job.fcl = make_fcl_check(mesh_a, mesh_b);
  return job;
}

/// What "intersects" says where triangles alone do not tell.
bool do_intersect(const PairJob& job, const Pose& pose_b, Work& work) {
  const PlacedMeshView a{job.mesh_a, job.pose_a}, b{job.mesh_b, pose_b};
  if (job.interior == Interior::Solid && job.touch == Touch::Exclude)
    return interiors_intersect(a, b, &work);
  return intersects(a, b, {.volume = job.volume, .hit = hit_of(job.touch, job.interior)}, &work);
}

PairAnswer ask(const PairJob& job, std::size_t index) {
  const Pose& pose_b = job.poses_b[index].pose;
  PairAnswer answer;
  answer.pose = index;
  const auto start = std::chrono::steady_clock::now();
  if (job.query == PairQuery::Any) {
    answer.intersects = do_intersect(job, pose_b, answer.work);
  } else {
    answer.pairs = find_triangle_pairs(
        {job.mesh_a, job.pose_a}, {job.mesh_b, pose_b},
        {.volume = job.volume, .touch = job.touch, .threads = job.threads}, &answer.work);
    answer.intersects = !answer.pairs->empty();
    if (job.interior == Interior::Solid && (!answer.intersects || job.touch == Touch::Exclude))
      answer.intersects = do_intersect(job, pose_b, answer.work);
  }
  answer.time = std::chrono::steady_clock::now() - start;
  if (job.fcl && job.query == PairQuery::Any) {
    answer.fcl = job.fcl->check_any(answer.intersects, job.pose_a, pose_b);
  } else if (job.fcl) {
    answer.fcl = job.fcl->check_pairs(*answer.pairs, job.pose_a, pose_b);
  }
  return answer;
}

}  // namespace

ExitCode run_pair(const PairOptions& options, Output& output) {
  const PairJob job = read_job(options);
  const PairReportSettings settings = {
      .query = job.query, .is_listing = options.is_listing, .is_checked = job.fcl != nullptr};
  const std::unique_ptr<PairReport> report =
      options.is_json ? make_json_report(output, settings) : make_table_report(output, settings);
  Progress progress("poses:", job.poses_b.size(), {.is_forced = options.has_progress});

  bool is_graze_wrong = false;
  try {
    report->begin();
    for (std::size_t i = 0; i < job.poses_b.size(); ++i) {
      const PairAnswer answer = ask(job, i);
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

}  // namespace graze::cli
