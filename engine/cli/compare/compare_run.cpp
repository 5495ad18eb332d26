#include <graze/engine/cli/compare/compare_run.h>
#include <graze/engine/cli/compare/engine_field.h>
#include <graze/engine/cli/compare/recorded_run.h>
#include <graze/engine/cli/files/case_folder.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/compare/peers/process/protocol.h>
#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/compare/run/job_key.h>
#include <graze/engine/compare/run/poses/pose_source.h>
#include <graze/engine/compare/run/record/place_block.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/file_bytes.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>
#include <graze/engine/world/shape_bounds.h>

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
                        Ask::Separation, Ask::FirstContact, Ask::Free}) {
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

bool is_shape_file(const std::string& path) {
  return fs::path(path).extension() == ".json";
}

/// Loads the shape in a file, which holds what a body of a case has, and nothing else.
Shape load_shape(const std::string& path) {
  const std::string name = mesh_io::printable(path);
  const cases::JsonValue tree = cases::parse_json(mesh_io::read_file(path, name), name);
  return compare::read_shape(cases::JsonCursor(tree, name));
}

/// Loads a body; a mesh is a shape, too.
CaseBody load_body(const std::string& path, const Pose& pose) {
  return {is_shape_file(path) ? load_shape(path) : Shape(load_mesh(path)), pose};
}

/// Returns a box that B must have room for: for a shape without an end that is its origin alone.
Aabb room_of(const Shape& shape) {
  const bool is_endless = shape.as<HalfSpace>() != nullptr || shape.as<Plane>() != nullptr;
  return is_endless ? Aabb{{0, 0, 0}, {0, 0, 0}} : bounding_aabb({shape, Pose::Identity()});
}

/// Returns the poses of two meshes or two bodies; `b` is the mesh or the shape of B, which has such
/// bounds.
template <typename A, typename B>
std::shared_ptr<const compare::PoseSource> poses_of(const CompareOptions& options, const A& a,
                                                    const B& b, const Aabb& bounds_b) {
  const std::uint64_t seed = options.seed.value_or(1);
  if (options.random > 0) return compare::random_pose_source(a, b, options.random, seed);
  if (options.grazing > 0) return compare::grazing_pose_source(a, b, options.grazing, seed);
  if (options.poses) return compare::pose_file(*options.poses, bounds_b);
  if (options.pose_b.empty()) return compare::pose_list({Pose::Identity()});
  const Pose pose = parse_pose(options.pose_b, "--pose-b");
  check_placement(pose, bounds_b, "--pose-b");
  return compare::pose_list({pose});
}

/// Reads --part K/N. Throws UsageError for anything else, and if no record is kept of the part.
compare::JobPart read_part(const CompareOptions& options, std::size_t places) {
  if (options.part.empty()) return {};
  const std::size_t slash = options.part.find('/');
  if (slash == options.part.npos) throw UsageError("--part: is K/N, the third of eight is 3/8");
  constexpr std::uint32_t kMostParts = 1'000'000;
  compare::JobPart part;
  part.count = parse_count(options.part.substr(slash + 1), "--part", 1, kMostParts);
  part.number = parse_count(options.part.substr(0, slash), "--part", 1, kMostParts);
  if (part.number > part.count) throw UsageError("--part: " + options.part + " is beyond the last");
  if (part.count > places) {
    throw UsageError(
        fmt::format("--part: {} parts of {} poses: some would be empty", part.count, places));
  }
  if (options.resume.empty() && options.save.empty()) {
    throw UsageError("--part needs --resume FILE or --save FILE: its record is what is merged");
  }
  return part;
}

ComparisonJob read_shape_job(const CompareOptions& options, const Pose& pose_a) {
  check_pose(pose_a, "--pose-a");
  const CaseBody a = load_body(options.mesh_a, pose_a);
  const CaseBody b = load_body(options.mesh_b, Pose::Identity());
  const Ask ask = ask_named(options.query);
  if (ask == Ask::Pairs) throw UsageError("--query pairs is about meshes, not about shapes");
  return {.a = a,
          .b = b,
          .poses_b = poses_of(options, a, b.shape, room_of(b.shape)),
          .question = {ask, {}}};
}

ComparisonJob read_mesh_job(const CompareOptions& options, const Pose& pose_a) {
  const Mesh mesh_a = load_mesh(options.mesh_a);
  const Mesh mesh_b = options.mesh_b == options.mesh_a ? mesh_a : load_mesh(options.mesh_b);
  check_placement(pose_a, mesh_a.bounds(), "--pose-a");
  const CaseMesh a(mesh_a, pose_a);
  return {.a = a,
          .b = CaseMesh(mesh_b, Pose::Identity()),
          .poses_b = poses_of(options, a, mesh_b, mesh_b.bounds()),
          .question = {ask_named(options.query), {}}};
}

ComparisonJob read_posed_job(const CompareOptions& options) {
  check_combinations(options);
  const Pose pose_a =
      options.pose_a.empty() ? Pose(Pose::Identity()) : parse_pose(options.pose_a, "--pose-a");
  const bool are_shapes = is_shape_file(options.mesh_a) || is_shape_file(options.mesh_b);
  ComparisonJob job = are_shapes ? read_shape_job(options, pose_a) : read_mesh_job(options, pose_a);
  if (options.clearance >= 0) job.question.settings.clearance = options.clearance;
  if (is_about_motion(options) && job.poses_b->size() < 2) {
    const std::string file = mesh_io::printable(*options.poses);
    throw PoseError(file + ": one pose, a motion has two", {.file = file});
  }
  return job;
}

/// Runs one comparison, and hands on what it finds as it comes.
class PoseComparison {
 public:
  PoseComparison(const CompareOptions& options, const ComparisonJob& job,
                 std::span<const EngineEntry> field, Output& output)
      : options_(options),
        job_(job),
        field_(field),
        output_(output),
        name_(fmt::format("{}-{}", name_part(fs::path(options.mesh_a).stem().string()),
                          name_part(fs::path(options.mesh_b).stem().string()))),
        findings_{.title = fs::path(options.mesh_a).filename().string() + " against " +
                           fs::path(options.mesh_b).filename().string(),
                  .question = options.query,
                  .count = "",
                  .place = "pose",
                  .summaries = {},
                  .wrong = wrong_list_of(options, field)} {}

  ExitCode run(std::span<const EngineEntry> engines) {
    RecordedJob<PlaceRecord> recorded = {.head = compare::head_of(job_)};
    compare::JournalHead& head = recorded.head;
    head.part = read_part(options_, head.places);
    head.engines = compare::journal_engines(field_);
    recorded.read = [&](const cases::JsonCursor& at, std::size_t first) {
      return compare::read_place_block(at, head.engines, first, head.end());
    };
    recorded.write = [&](std::span<const PlaceRecord> block) {
      return to_json(block, head.engines);
    };
    recorded.most_in_line = compare::kPlacesOfBlock;
    recorded.run = [&](const auto& range, const auto& on_records) {
      run_comparison(job_, field_, range, on_records);
    };
    recorded.on_record = [&](const PlaceRecord& record) { add(record); };
    recorded.note = [&] { return tally_.note(); };
    findings_.changes = RecordedRun<PlaceRecord>(options_, recorded).run();
    findings_.summaries = tally_.summaries();
    findings_.count = fmt::format("{} {}", count_, is_about_motion(options_) ? "motions" : "poses");
    findings_.asked = head.parts;
    if (!head.part.is_whole()) {
      findings_.count += fmt::format(", part {} of {}", head.part.number, head.part.count);
    }
    findings_.rows = wrong_rows(findings_.wrong.kept(), findings_.wrong.count(), "pose");
    return conclude(options_, engines, field_, findings_, output_);
  }

 private:
  static constexpr std::size_t kMostUnwritten = std::size_t{1} << 16;

  void add(const PlaceRecord& record) {
    ++count_;
    tally_.add(record);
    for (WrongAnswer& wrong : wrong_answers(record)) {
      wrong.name = fmt::format("{}-{}-{}-pose{}", name_, name_part(wrong.answer->engine),
                               options_.query, wrong.place);
      wrong.query = [this, pose = wrong.place] { return case_of(job_, pose); };
      findings_.wrong.add(std::move(wrong));
    }
    if (!options_.is_json) return;
    findings_.json += to_json(record, "pose") + "\n";
    if (findings_.json.size() < kMostUnwritten) return;
    output_.write(findings_.json);
    findings_.json.clear();
  }

  const CompareOptions& options_;
  const ComparisonJob& job_;
  std::span<const EngineEntry> field_;
  Output& output_;
  std::string name_;
  CompareFindings findings_;
  Tally tally_;
  std::size_t count_ = 0;
};

}  // namespace

ExitCode run_compare(const CompareOptions& options, std::span<const EngineEntry> known,
                     Output& output) {
  if (!(options.time_tolerance >= 1)) throw UsageError("--time-tolerance: is below 1");
  const std::vector<EngineEntry> engines =
      with_more_engines(known, compare::motion_engines(peer_settings(options)));
  if (options.mesh_b.empty()) {
    std::error_code ignored;
    if (fs::path(options.mesh_a).extension() == ".json") {
      return run_compare_scene(options, engines, output);
    }
    const bool are_cases = fs::path(options.mesh_a).extension() == ".jsonl";
    if (!are_cases && !fs::is_directory(options.mesh_a, ignored)) {
      throw UsageError("a mesh B is needed, or a folder of cases alone, or a scene, a .json file");
    }
    return run_compare_folder(options, engines, output);
  }
  Field field(engines, options.engines);
  const ComparisonJob job = read_posed_job(options);
  field.add_answers(options.answers, {options.mesh_a, options.mesh_b, job});
  check_before(options, field.engines());
  return PoseComparison(options, job, field.engines(), output).run(engines);
}

}  // namespace graze::cli
