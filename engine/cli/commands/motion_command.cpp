#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/motion/certificate_file.h>
#include <graze/engine/cli/motion/contact_picture.h>
#include <graze/engine/cli/motion/motion_arguments.h>
#include <graze/engine/cli/motion/motion_page.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/reports/motion_report.h>
#include <graze/engine/compare/run/trial_threads.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/pose_text.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace graze::cli {
namespace {

constexpr const char* kMotionFooter = R"(
A stays, B goes from one pose to another while t goes from 0 to 1: its origin straight, and it turns
steadily the short way round (--to); or along and about one line (--as-screw); or by any number of
turns (--screw). Poses are 12 numbers as for graze pair, lengths metres, angles radians. A path is a
file with a pose a line, and each stretch between two of them is a motion, asked on --threads and told
in order.

Each motion has one of three answers.
  free   further apart than the clearance at every t: proved
  hit    free up to "low", and at "high" the surfaces meet, or are within the clearance: a witness
         that anybody can check, in the pose of B that --json prints as "pose_b", else null
  close  free up to "low", where they are nearer than the tolerance, and no contact was proved; or
         the budget of tests ended there
"low" is never later than the first contact.

With --json each answer is one line:
  {"motion":0,"answer":"hit","low":0.25,"high":0.2500001,"out_of_budget":false,"pose_b":[12 numbers],
   "work":{...}}
--certificate writes the proof that a motion is free, and adds "certificate":FILE; graze verify checks
it. What is not free has none, and no file is written. --picture draws where the first motion that is not
free comes to A, at "high" of a hit and "low" else, and adds "picture":FILE; where all is free no file is
written. --view writes a page, as graze view does, that plays all motions and leads to where they meet.

Examples:
  graze motion bolt.obj nut.stl --from "1 0 0 0  0 1 0 0  0 0 1 0.00875" --screw "0 0 0  0 0 1  2.83 0.0015"
  graze motion bolt.obj nut.stl --from "1 0 0 0  0 1 0 0  0 0 1 0.03" --to "1 0 0 0  0 1 0 0  0 0 1 0.05" --certificate c.json
  graze motion bolt.obj nut.stl --path poses.txt --clearance 1e-5 --json
  graze motion bolt.obj nut.stl --from "1 0 0 0  0 1 0 0  0 0 1 0.03" --to "1 0 0 0  0 1 0 0  0 0 1 0" --picture met.svg
  graze motion bolt.obj nut.stl --path poses.txt --view motion.html

Exit codes:
  0  an answer was given, whatever it is
  2  bad input, with one line on stderr and nothing on stdout)";

struct MotionOptions {
  std::string mesh_a;
  std::string mesh_b;
  std::string pose_a;
  MotionArguments motion;
  RigidContactSettings settings;
  std::string certificate;
  std::string picture;
  std::string page;
  std::size_t threads = 0;
  bool is_json = false;
  bool has_progress = false;
};

void check_files(const MotionOptions& options) {
  if (!options.certificate.empty() && !options.motion.path.empty())
    throw UsageError("--certificate and --path exclude each other: a proof is about one motion");
  const std::array<FilePlace, 3> outputs = {{{"--certificate", options.certificate},
                                             {"--picture", options.picture},
                                             {"--view", options.page}}};
  const std::array<FilePlace, 3> inputs = {{{"the first mesh", options.mesh_a},
                                            {"the second mesh", options.mesh_b},
                                            {"the file of --path", options.motion.path}}};
  check_outputs(outputs, inputs);
}

/// Writes a picture of the moment that the answer is about.
void write_picture(const MotionOptions& options, const PlacedMeshView& a, const Mesh& mesh_b,
                   const RigidMotion& motion, const RigidContact& contact) {
  const double t = contact.status == RigidStatus::Hit ? contact.high : contact.low;
  files::write_file(options.picture, contact_picture(a, {mesh_b, motion.at(t)}));
}

/// Returns the path as the certificate names it: from its own folder on.
std::filesystem::path seen_from(const std::string& certificate, const std::string& mesh) {
  const std::filesystem::path folder = std::filesystem::absolute(certificate).parent_path();
  return std::filesystem::proximate(std::filesystem::absolute(mesh), folder);
}

/// Writes the proof, if there is one, and returns the name of its file, or nothing.
std::string write_proof(const MotionOptions& options, const Mesh& mesh_a,
                        const RigidMotion& motion_a, const Mesh& mesh_b,
                        const RigidMotion& motion_b, Work& work) {
  const std::optional<FreedomCertificate> proof =
      certify_free({mesh_a, motion_a}, {mesh_b, motion_b}, options.settings, &work);
  if (!proof) return {};
  files::write_file(
      options.certificate,
      to_json(CertificateFile{.mesh_a = seen_from(options.certificate, options.mesh_a),
                              .mesh_b = seen_from(options.certificate, options.mesh_b),
                              .motion_a = motion_a,
                              .motion_b = motion_b,
                              .certificate = *proof}));
  return options.certificate;
}

/// Returns a page of all motions, if one is asked for.
std::unique_ptr<MotionPage> page_of(const MotionOptions& options, const Mesh& mesh_a,
                                    const Pose& pose_a, const Mesh& mesh_b, std::size_t motions) {
  if (options.page.empty()) return nullptr;
  const auto name = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  const MotionPageSettings settings = {
      .title = name(options.mesh_b) + " past " + name(options.mesh_a),
      .name_a = name(options.mesh_a),
      .name_b = name(options.mesh_b),
      .motions = motions};
  return make_motion_page(mesh_a, pose_a, mesh_b, settings);
}

/// Asks about all motions, on many threads, and tells of them in their order.
class MotionRun {
 public:
  MotionRun(const MotionOptions& options, const Mesh& mesh_a, const RigidMotion& rest,
            const Mesh& mesh_b, std::span<const RigidMotion> motions, Output& output)
      : options_(options),
        mesh_a_(mesh_a),
        rest_(rest),
        mesh_b_(mesh_b),
        motions_(motions),
        output_(output),
        page_(page_of(options, mesh_a, rest.start(), mesh_b, motions.size())),
        progress_("motions:", motions.size(), {.is_forced = options.has_progress}) {}

  ExitCode run() {
    // What has to be built is built before, or by the first motion, so that no thread changes what
    // each of them did.
    if (motions_.size() > 1) {
      run_in_arena(static_cast<int>(options_.threads), [&] {
        prepare(mesh_a_, {}, &built_);
        prepare(mesh_b_, {}, &built_);
      });
    }
    ask({.first = 0, .end = 1, .threads = 1});
    ask({.first = 1, .end = motions_.size(), .threads = options_.threads});
    if (page_) files::write_file(options_.page, page_->text());
    return ExitCode::Answered;
  }

 private:
  void ask(const compare::PlaceRange& range) {
    compare::run_in_order<MotionAnswer>(
        range, [](std::size_t) { return 0; }, [&](std::size_t i, int) { return answer(i); },
        [&](std::vector<MotionAnswer> answers) {
          for (MotionAnswer& each : answers)
            tell(each);
          return true;
        });
  }

  MotionAnswer answer(std::size_t i) const {
    MotionAnswer answer;
    answer.number = i;
    if (i == 0) answer.work = built_;
    answer.contact =
        first_contact({mesh_a_, rest_}, {mesh_b_, motions_[i]}, options_.settings, &answer.work);
    if (answer.contact.status == RigidStatus::Hit)
      answer.pose_b = motions_[i].at(answer.contact.high);
    if (!options_.certificate.empty() && answer.contact.status == RigidStatus::Free)
      answer.certificate = write_proof(options_, mesh_a_, rest_, mesh_b_, motions_[i], answer.work);
    return answer;
  }

  /// Tells an answer. One thread at a time does so, in the order of the motions.
  void tell(MotionAnswer& answer) {
    const RigidMotion& motion = motions_[answer.number];
    if (!has_picture_ && answer.contact.status != RigidStatus::Free) {
      write_picture(options_, {mesh_a_, rest_.start()}, mesh_b_, motion, answer.contact);
      answer.picture = options_.picture;
      has_picture_ = true;
    }
    if (page_) page_->add(motion, answer.contact);
    if (answer.number == 0 && !options_.is_json) output_.write(motion_header());
    output_.write(options_.is_json ? to_json(answer) : to_text(answer));
    progress_.update(answer.number + 1);
  }

  const MotionOptions& options_;
  const Mesh& mesh_a_;
  const RigidMotion& rest_;
  const Mesh& mesh_b_;
  std::span<const RigidMotion> motions_;
  Output& output_;
  std::unique_ptr<MotionPage> page_;
  bool has_picture_ = options_.picture.empty();
  Progress progress_;
  Work built_;
};

ExitCode run_motion(const MotionOptions& options, Output& output) {
  check_files(options);
  const RigidMotion rest(options.pose_a.empty() ? Pose::Identity()
                                                : parse_pose(options.pose_a, "--pose-a"));
  const std::vector<RigidMotion> motions = read_motions(options.motion);
  const Mesh mesh_a = load_mesh(options.mesh_a);
  const Mesh mesh_b = options.mesh_b == options.mesh_a ? mesh_a : load_mesh(options.mesh_b);
  // All are checked before the first answer, so that nothing is printed where a later motion is
  // refused.
  check_coordinates(rest, mesh_a.bounds(), "--pose-a");
  for (std::size_t i = 0; i < motions.size(); ++i)
    check_coordinates(motions[i], mesh_b.bounds(), ("motion " + std::to_string(i)).c_str());
  return MotionRun(options, mesh_a, rest, mesh_b, motions, output).run();
}

}  // namespace

void add_motion_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<MotionOptions>();
  CLI::App* command = program.add_subcommand("motion", "When a moving mesh first meets another");
  command->add_option("A", options->mesh_a, "mesh that stays: .obj, .stl, .ply or .off")
      ->required();
  command->add_option("B", options->mesh_b, "mesh that moves")->required();
  command->add_option("--pose-a", options->pose_a, "pose of A (default: identity)")->type_name("P");
  MotionArguments& motion = options->motion;
  command->add_option("--from", motion.from, "pose of B at t = 0 (default: identity)")
      ->type_name("P");
  command->add_option("--to", motion.to, "pose of B at t = 1")->type_name("P");
  command
      ->add_option("--screw", motion.screw,
                   "instead: a point, an axis, an angle, and a pitch for each turn: 8 numbers")
      ->type_name("S");
  command->add_option("--path", motion.path, "instead: a file with a pose of B a line")
      ->type_name("FILE");
  command->add_flag("--as-screw", motion.is_screwed, "from pose to pose along and about one line");
  RigidContactSettings& settings = options->settings;
  command
      ->add_option("--clearance", settings.clearance, "metres by which to stay apart (default: 0)")
      ->type_name("M")
      ->check(finite_number(Sign::NotNegative));
  command->add_option("--tolerance", settings.tolerance, "metres (default: 1e-6)")
      ->type_name("M")
      ->check(finite_number(Sign::NotNegative));
  command->add_option("--budget", settings.budget, "at most so many tests a motion")
      ->type_name("N")
      ->check(whole_number(1, std::uint64_t{1} << 53));
  command->add_option("--certificate", options->certificate, "where to write the proof")
      ->type_name("FILE")
      ->check(file_name());
  command
      ->add_option("--picture", options->picture,
                   "where to draw the first contact that is found (SVG)")
      ->type_name("FILE")
      ->check(file_name());
  command
      ->add_option("--view", options->page, "where to write a page that plays the motions (HTML)")
      ->type_name("FILE")
      ->check(file_name());
  command
      ->add_option("--threads", options->threads,
                   "of a path; 0 (default): as many as there are; no answer depends on it")
      ->type_name("N")
      ->check(whole_number(0, kMaxThreads));
  command->add_flag("--json", options->is_json, "one JSON object a motion");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  command->footer(kMotionFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_motion(*options, output); };
  });
}

}  // namespace graze::cli
