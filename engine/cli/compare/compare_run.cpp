#include <graze/engine/cli/compare/compare_run.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/compare/recorded_run.h>
#include <graze/engine/cli/files/case_folder.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/compare/run/job_key.h>
#include <graze/engine/compare/run/pose_source.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>

#include <fmt/format.h>
#include <filesystem>

namespace graze::cli {
namespace {

namespace fs = std::filesystem;
using compare::ComparisonJob;
using compare::EngineEntry;
using compare::PlaceRecord;
using compare::WrongAnswer;

Ask ask_named(const std::string& name) {
  for (const Ask ask : {Ask::Any, Ask::Pairs, Ask::Distance, Ask::Within, Ask::Contacts,
                        Ask::FirstContact, Ask::Free}) {
    if (name == name_of(ask)) return ask;
  }
  throw UsageError("--query: there is no question " + mesh_io::quoted(name));
}

bool is_about_motion(const CompareOptions& options) {
  return options.query == "first_contact" || options.query == "free";
}

void check_combinations(const CompareOptions& options) {
  if (options.steps || options.step > 0 || !options.mesh_folder.empty()) {
    throw UsageError("--steps, --dt and --meshes belong to scenes");
  }
  const int sources = !options.pose_b.empty() + options.poses.has_value() + (options.random > 0) +
                      (options.grazing > 0);
  if (sources > 1) {
    throw UsageError("--pose-b, --poses, --random and --grazing exclude each other: all place B");
  }
  if (options.query == "within" && options.clearance < 0) {
    throw UsageError("--query within needs --clearance");
  }
  if (options.query != "within" && !is_about_motion(options) && options.clearance >= 0) {
    throw UsageError("--clearance belongs to --query within, first_contact and free");
  }
  if (is_about_motion(options) && !options.poses) {
    throw UsageError("--query " + options.query +
                     " needs --poses: B moves from each of them to the next");
  }
  if (options.seed && options.random == 0 && options.grazing == 0) {
    throw UsageError("--seed belongs to --random and --grazing");
  }
}

std::vector<Pose> poses_of(const CompareOptions& options, const PlacedMeshView& a, const Mesh& b) {
  const std::uint64_t seed = options.seed.value_or(1);
  if (options.random > 0) return compare::random_poses(a, b, options.random, seed);
  if (options.grazing > 0) return compare::grazing_poses(a, b, options.grazing, seed);
  if (!options.pose_b.empty()) return {parse_pose(options.pose_b, "--pose-b")};
  if (!options.poses) return {Pose::Identity()};
  std::vector<Pose> poses;
  for (const PoseLine& line : load_pose_lines(*options.poses)) {
    const std::string place = *options.poses + ":" + std::to_string(line.line);
    check_placement(line.pose, b.bounds(), place.c_str());
    poses.push_back(line.pose);
  }
  return poses;
}

/// From each pose to the next, as graze motion --path has it; the last is an end alone.
void make_motions(ComparisonJob& job, const std::string& file) {
  std::vector<Pose>& poses = job.poses_b;
  if (poses.size() < 2)
    throw PoseError(mesh_io::printable(file) + ": one pose, a motion has two", {.file = file});
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const RigidMotion motion = RigidMotion::between(poses[i - 1], poses[i]);
    job.courses_b.push_back({.centre = motion.centre(),
                             .shift = motion.shift(),
                             .axis = motion.axis(),
                             .angle = motion.angle()});
  }
  poses.pop_back();
}

ComparisonJob read_job(const CompareOptions& options) {
  check_combinations(options);
  const Pose pose_a =
      options.pose_a.empty() ? Pose(Pose::Identity()) : parse_pose(options.pose_a, "--pose-a");
  const Mesh mesh_a = load_mesh(options.mesh_a);
  const Mesh mesh_b = options.mesh_b == options.mesh_a ? mesh_a : load_mesh(options.mesh_b);
  check_placement(pose_a, mesh_a.bounds(), "--pose-a");
  ComparisonJob job{.a = CaseMesh(mesh_a, pose_a),
                    .b = CaseMesh(mesh_b, Pose::Identity()),
                    .poses_b = poses_of(options, {mesh_a, pose_a}, mesh_b),
                    .question = {ask_named(options.query), {}},
                    .threads = options.threads};
  if (options.clearance >= 0) job.question.settings.clearance = options.clearance;
  for (const Pose& pose : job.poses_b)
    check_placement(pose, mesh_b.bounds(), "the pose of B");
  if (is_about_motion(options)) make_motions(job, *options.poses);
  return job;
}

}  // namespace

ExitCode run_compare(const CompareOptions& options, std::span<const EngineEntry> engines,
                     Output& output) {
  if (!(options.time_tolerance >= 1)) throw UsageError("--time-tolerance: is below 1");
  if (options.mesh_b.empty()) {
    std::error_code ignored;
    if (fs::path(options.mesh_a).extension() == ".json") {
      return run_compare_scene(options, engines, output);
    }
    if (!fs::is_directory(options.mesh_a, ignored)) {
      throw UsageError("a mesh B is needed, or a folder of cases alone, or a scene, a .json file");
    }
    return run_compare_folder(options, engines, output);
  }
  const Field field(engines, options.engines);
  check_before(options, field.engines());
  const ComparisonJob job = read_job(options);
  const RecordedJob<PlaceRecord> recorded = {
      .head = compare::head_of(job),
      .read =
          [&](const cases::JsonCursor& at) {
            return compare::read_place_record(at, "pose", job.poses_b.size());
          },
      .write = [](const PlaceRecord& record) { return to_json(record, "pose"); },
      .run =
          [&](const auto& is_done, const auto& on_record) {
            run_comparison(job, field.engines(), is_done, on_record);
          }};
  const RecordedRun<PlaceRecord> run = run_recorded(options, recorded, field.engines());
  CompareFindings findings{.title = fs::path(options.mesh_a).filename().string() + " against " +
                                    fs::path(options.mesh_b).filename().string(),
                           .question = options.query,
                           .count = fmt::format("{} {}", run.records.size(),
                                                job.courses_b.empty() ? "poses" : "motions"),
                           .place = "pose",
                           .summaries = summarise(run.records),
                           .wrong = wrong_answers(run.records),
                           .difference = run.difference,
                           .asked = recorded.head.parts};
  for (WrongAnswer& wrong : findings.wrong) {
    wrong.name =
        fmt::format("{}-{}-{}-{}-pose{}", name_part(fs::path(options.mesh_a).stem().string()),
                    name_part(fs::path(options.mesh_b).stem().string()),
                    name_part(wrong.answer->engine), options.query, wrong.place);
    wrong.query = [&job, pose = wrong.place] { return case_of(job, pose); };
  }
  findings.rows = wrong_rows(findings.wrong, findings.place);
  for (const PlaceRecord& record : run.records)
    findings.json += recorded.write(record) + "\n";
  return conclude(options, engines, field.engines(), findings, output);
}

}  // namespace graze::cli
