#include <graze/bvh/error.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/replay/case_list.h>
#include <graze/engine/cli/reports/case_explanation.h>
#include <graze/engine/cli/reports/explanation.h>
#include <graze/engine/cli/reports/why_page.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/files/output_file.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

namespace graze::cli {
namespace {

constexpr const char* kExplainFooter = R"(
Why this answer: the stage that decided, the pair of triangles that decides, or came closest, and the stage
of a test of these two that is sure, a witness point or the separating axis; for a miss the largest boxes on
the way down to that pair that are apart, and along which axis, and of closed meshes whether one lies inside
the other; and what each kind of bounding volume let the query skip.

With --json the answer is one line:
  {"intersects":false,"pair":[a,b],"stage":"rounded","point_a":[x,y,z],"point_b":[...],"gap":...,
   "axis":[...],"decided_by":"volumes","boxes_apart":{"triangles":[n,m],"axis":"x of A",
   "direction":[...],"gap":...},"solids_intersect":false,"boxes":{"axis":"x of A","direction":[...],
   "gap":...},"pairs":...,"first_query":{...},"volumes":{"aabb":{"volume_tests":...,...},...}}
"stage" is "rounded", where a floating-point filter was sure, or "exact". For a miss alone: "axis";
"decided_by", the last stage that had to be asked: "boxes of the meshes", "volumes", "leaves" (bounds of the
gaps between triangles in leaves), "triangles" (tests in rounded arithmetic), "exact"; "boxes_apart", unless
the boxes of the leaves overlap; "solids_intersect", if both meshes are closed.

Of a case, a .json file alone (see graze replay), it says why the answer in it is wrong: two textbook tests of
the two triangles that show it best, the separating axes and piercing by determinants, are gone through in double and in float,
with corners placed in the common frame, in A's, and from A's first corner, beside the same in rational numbers. The first step that gives the
recorded answer is named: an axis, a determinant, or placing itself. --answer is judged in its place: yes, no, a
distance, or of a first contact "free" or a time. With --json: {"question":...,"verdict":"wrong","pair":[a,b],
"variants":[{"placed":"in A's frame","numbers":"double","touch":true,"axes":true,"determinants":false,
"misleading":[{"name":...,"computed":...,"exact":...,"ulps":...}]}],"why":...}

Of two shapes it says in words what proves the truth: the plane that parts them, the points that are nearest, the point
that is in both, how far B must go; of two in motion where they meet first, in which triangles, what is proved until then,
and how late or early the answer is; of a ray what it meets; of a point whether it is inside. With --json: "reasons":[...].
Of a question that it does not explain one line says so. Of a file of many cases, .jsonl, --line says which.

Examples:
  graze explain bolt.obj nut.stl --pose-b "1 0 0 0  0 1 0 0  0 0 1 0.002"
  graze explain data/regressions/fcl-rock-14.json
  graze explain data/regressions/triangles-16.json --answer yes
  graze explain data/hard_cases/shapes.jsonl --line 27
  graze explain data/hard_cases/motions.jsonl --line 1 --answer free
  graze explain bolt.obj nut.stl --view why.html

Exit codes:
  0  an answer was given, whatever it is
  2  bad input, with one line on stderr and nothing on stdout)";

struct ExplainOptions {
  std::string mesh_a;
  std::string mesh_b;
  std::string pose_a;
  std::string pose_b;
  std::string answer;               ///< takes the place of the case's own answer
  std::optional<std::size_t> line;  ///< a line of a file of many cases, from 1 on
  std::string page;                 ///< the file of a page; empty for none
  bool is_json = false;
};

/// Refuses a page that would be written where something is read.
void check_page(const ExplainOptions& options) {
  const std::array<FilePlace, 2> inputs = {
      {{"A", options.mesh_a}, {"the second mesh", options.mesh_b}}};
  const std::array<FilePlace, 1> outputs = {{{"--view", options.page}}};
  check_outputs(outputs, inputs);
}

std::string name_of_file(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// Returns the number if the word is a number and nothing else.
std::optional<double> read_number(const std::string& word) {
  double value = 0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool is_read = error == std::errc() && rest == word.data() + word.size();
  return is_read && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Reads what stands behind --answer.
CaseAnswer read_answer_word(const Case& query, const std::string& word) {
  CaseAnswer answer;
  const bool is_distance = query.ask == Ask::Distance;
  const bool is_time = query.ask == Ask::FirstContact;
  const std::optional<double> number = read_number(word);
  if (!is_distance && !is_time && (word == "yes" || word == "no")) {
    answer.says = word == "yes";
  } else if (is_distance && number) {
    answer.distance = number;
  } else if (is_time && word == "free") {
    answer.status = RigidStatus::Free;
    answer.low = answer.high = 1;
  } else if (is_time && number) {
    answer.status = RigidStatus::Hit;
    answer.low = answer.high = number;
  } else {
    throw UsageError("--answer: " + mesh_io::quoted(word) + " is no answer to " +
                     name_of(query.ask) +
                     ": yes or no, a distance in metres, or of a first contact free or a time");
  }
  return answer;
}

/// Reads the case in a file, or in a line of a file of many.
Case read_explained(const ExplainOptions& options) {
  const std::filesystem::path path = options.mesh_a;
  if (path.extension() == ".json" && !options.line) return read_case(path);
  if (path.extension() == ".json") throw UsageError("--line is of a file of many cases, .jsonl");
  if (path.extension() != ".jsonl")
    throw UsageError("a mesh B is needed, or a case alone, a .json file");
  if (!options.line) throw UsageError("which case of the file: see --line");
  const std::string name = options.mesh_a + ":" + std::to_string(*options.line);
  std::optional<Case> found;
  read_listed_cases(
      path, {},
      [&](const ListedCase& each) {
        if (each.name == name) found = each.query;
      },
      [](const Error& error) { throw CaseError(error.what(), error.place()); });
  if (!found) throw UsageError("--line: " + mesh_io::printable(name) + ": there is no such line");
  return *found;
}

ExitCode run_explain_case(const ExplainOptions& options, Output& output) {
  if (!options.pose_a.empty() || !options.pose_b.empty()) {
    throw UsageError("--pose-a and --pose-b are of two meshes: a case has its own");
  }
  Case query = read_explained(options);
  if (!options.answer.empty()) {
    query.answer = read_answer_word(query, options.answer);
    query.answered_by = {"--answer", ""};
  }
  const std::string name = mesh_io::printable(options.mesh_a);
  if (!query.answer) throw CaseError(name + ": has no answer; see --answer");
  if (const auto fault = compare::fault_of_answer(query, *query.answer)) {
    throw UsageError("--answer: " + *fault);
  }
  const CaseExplanation explanation = explain_case(query);
  if (!options.page.empty())
    files::write_file(options.page, why_page(query, name_of_file(options.mesh_a), explanation));
  output.write(options.is_json ? to_json(explanation) : to_text(explanation));
  return ExitCode::Answered;
}

ExitCode run_explain(const ExplainOptions& options, Output& output) {
  check_page(options);
  if (options.mesh_b.empty()) return run_explain_case(options, output);
  if (!options.answer.empty()) throw UsageError("--answer is of a case");
  if (options.line) throw UsageError("--line is of a file of many cases, .jsonl");
  const auto pose_of = [](const std::string& text, const char* option) {
    return text.empty() ? Pose(Pose::Identity()) : parse_pose(text, option);
  };
  const Pose pose_a = pose_of(options.pose_a, "--pose-a");
  const Pose pose_b = pose_of(options.pose_b, "--pose-b");
  const Mesh mesh_a = load_mesh(options.mesh_a);
  const Mesh mesh_b = options.mesh_b == options.mesh_a ? mesh_a : load_mesh(options.mesh_b);
  check_placement(pose_a, mesh_a.bounds(), "--pose-a");
  check_placement(pose_b, mesh_b.bounds(), "--pose-b");
  const Explanation explanation = explain({mesh_a, pose_a}, {mesh_b, pose_b});
  if (!options.page.empty())
    files::write_file(options.page,
                      why_page({mesh_a, pose_a}, {mesh_b, pose_b}, name_of_file(options.mesh_a),
                               name_of_file(options.mesh_b), explanation));
  output.write(options.is_json ? to_json(explanation) : to_text(explanation));
  return ExitCode::Answered;
}

}  // namespace

void add_explain_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = program.add_subcommand(
      "explain", "Why two meshes intersect, or do not; why an answer is wrong");
  command
      ->add_option("A", options->mesh_a, "first mesh: .obj, .stl, .ply or .off; or a case, .json")
      ->required();
  command->add_option("B", options->mesh_b, "second mesh");
  command->add_option("--pose-a", options->pose_a, "pose of A (default: identity)")->type_name("P");
  command->add_option("--pose-b", options->pose_b, "pose of B (default: identity)")->type_name("P");
  command
      ->add_option("--answer", options->answer,
                   "of a case: this answer in place of the recorded one")
      ->type_name("yes|no|METRES|free|TIME");
  command->add_option("--line", options->line, "of a file of many cases: that of this line")
      ->type_name("N")
      ->check(whole_number(1, 1'000'000'000));
  command->add_option("--view", options->page, "where to write a page that shows it (HTML)")
      ->type_name("FILE")
      ->check(file_name());
  command->add_flag("--json", options->is_json, "one JSON object on one line");
  command->footer(kExplainFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_explain(*options, output); };
  });
}

}  // namespace graze::cli
