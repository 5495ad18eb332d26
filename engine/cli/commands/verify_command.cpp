#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/motion/certificate_file.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/load_mesh.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace graze::cli {
namespace {

constexpr const char* kVerifyFooter = R"(
FILE is what graze motion --certificate wrote. It names two meshes, relative to its own folder, and
holds both motions and a proof that the meshes stay further apart than a clearance. The proof is
checked against the meshes as they are now, in interval arithmetic, by one function that uses no
tree and nothing else of the library's: whatever it accepts is so, whoever wrote the file.

With --json the answer is one line:
  {"proved":true,"clearance":0,"steps":123}

Examples:
  graze verify c.json

Exit codes:
  0  proved
  1  not proved: a step is missing, a plane does not part, a mesh or a motion is another
  2  bad input, with one line on stderr and nothing on stdout)";

struct VerifyOptions {
  std::string file;
  bool is_json = false;
};

ExitCode run_verify(const VerifyOptions& options, Output& output) {
  const std::filesystem::path path = options.file;
  const CertificateFile file = read_certificate(path);
  const Mesh mesh_a = load_mesh(path.parent_path() / file.mesh_a);
  const Mesh mesh_b = load_mesh(path.parent_path() / file.mesh_b);
  const FreedomCertificate& proof = file.certificate;
  const bool is_proved = proves_freedom(proof, {mesh_a, file.motion_a}, {mesh_b, file.motion_b});
  if (options.is_json) {
    output.write(fmt::format("{{\"proved\":{},\"clearance\":{},\"steps\":{}}}\n", is_proved,
                             proof.clearance, proof.steps.size()));
  } else {
    output.write(fmt::format("{}: {} stays further than {} m from {}, in {} steps\n",
                             is_proved ? "proved" : "not proved",
                             mesh_io::printable(file.mesh_b.string()), proof.clearance,
                             mesh_io::printable(file.mesh_a.string()), proof.steps.size()));
  }
  return is_proved ? ExitCode::Answered : ExitCode::Failed;
}

}  // namespace

void add_verify_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command =
      program.add_subcommand("verify", "Whether a file proves that a motion is free");
  command->add_option("FILE", options->file, "what graze motion --certificate wrote")->required();
  command->add_flag("--json", options->is_json, "one JSON object on one line");
  command->footer(kVerifyFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_verify(*options, output); };
  });
}

}  // namespace graze::cli
