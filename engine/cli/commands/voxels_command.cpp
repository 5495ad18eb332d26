#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/output/count_argument.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/reports/voxels_report.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/voxel/voxel_format.h>
#include <graze/engine/mesh/write_voxels.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <string>

namespace graze::cli {
namespace {

constexpr const char* kVoxelsFooter = R"(
The mesh's bounds are cut into cubic voxels, N along their longest side. Those that share a point
with a triangle are written as boxes of six quads that share their corners: as text to an OBJ file,
or as binary doubles to a PLY file, by the name's ending. Every voxel is decided exactly, by the
coordinates that are written: a triangle on a face touches the voxels on both sides. With --solid,
voxels inside the mesh are written too, by the even-odd rule; the mesh must be closed (see graze
info). Lengths are in the unit of the file, taken as metres.
The file appears whole or not at all: whatever fails, or ends the command, an old one stays as it
was. Pipes and devices are written through.

With --json there is one line:
  {"mesh":...,"file":...,"fill":"surface","counts":[64,50,49],"edge":...,"origin":[x,y,z],
   "voxels":...,"fraction":...,"find_ms":...,"write_ms":...,"work":{...}}
Voxel (i, j, k) is the box between planes i and i + 1 along x, and so on; plane i is at
origin + i * edge, rounded once.

Examples:
  graze voxels bolt.obj --resolution 200 -o bolt-voxels.ply
  graze voxels nut.stl --resolution 64 --solid -o nut-voxels.obj --json

Exit codes:
  0  the voxels were written
  2  bad input, or a file that cannot be written, with one line on stderr and nothing on stdout)";

constexpr std::uint32_t kMaxResolution = 65535;

struct VoxelsOptions {
  std::string mesh;
  std::string file;
  std::string resolution;
  std::string threads = "0";
  bool is_solid = false;
  bool is_json = false;
  bool has_progress = false;
};

/// Refuses a file that could not be written after the work is done, or that would destroy the mesh.
void check_file(const VoxelsOptions& options) {
  mesh_io::voxel_format_of(options.file);
  const FilePlace output = {"-o", options.file};
  const FilePlace input = {"the mesh itself", options.mesh};
  check_outputs({&output, 1}, {&input, 1});
}

VoxelSettings settings_of(const VoxelsOptions& options) {
  return {.resolution = parse_count(options.resolution, "--resolution", 1, kMaxResolution),
          .fill = options.is_solid ? VoxelFill::Solid : VoxelFill::Surface,
          .threads = static_cast<int>(parse_count(options.threads, "--threads", 0, kMaxThreads)),
          .max_voxels = kMaxWrittenVoxels};
}

/// Finds the voxels; the mesh's errors name its file.
Voxels find(const VoxelsOptions& options, const Mesh& mesh, VoxelSettings settings, Work& work) {
  Progress progress("percent of the voxels:", 100,
                    {.is_forced = options.has_progress, .has_rows = false});
  settings.on_progress = [&](std::size_t done, std::size_t total) {
    progress.update(100 * done / total);
  };
  try {
    return find_voxels(mesh, settings, &work);
  } catch (const Error& error) {
    ErrorPlace place = error.place();
    place.file = options.mesh;
    throw MeshError(mesh_io::printable(options.mesh) + ": " + error.what(), std::move(place));
  }
}

void write(const VoxelsOptions& options, const Voxels& voxels) {
  Progress progress("percent of the file:", 100,
                    {.is_forced = options.has_progress, .has_rows = false});
  write_voxels(options.file, voxels, {.on_progress = [&](std::uint64_t done, std::uint64_t total) {
                 progress.update(100 * done / total);
               }});
}

ExitCode run_voxels(const VoxelsOptions& options, Output& output) {
  using Clock = std::chrono::steady_clock;
  const VoxelSettings settings = settings_of(options);
  check_file(options);
  const Mesh mesh = load_mesh(options.mesh);
  VoxelsReport report;
  report.mesh = options.mesh;
  report.file = options.file;
  report.fill = settings.fill;
  const auto start = Clock::now();
  const Voxels voxels = find(options, mesh, settings, report.work);
  const auto found = Clock::now();
  write(options, voxels);
  report.find_time = found - start;
  report.write_time = Clock::now() - found;
  report.grid = voxels.grid;
  report.voxels = voxels.size();
  output.write(options.is_json ? to_json(report) : to_text(report));
  return ExitCode::Answered;
}

}  // namespace

void add_voxels_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<VoxelsOptions>();
  CLI::App* command = program.add_subcommand("voxels", "The voxels that a mesh touches or fills");
  command->add_option("MESH", options->mesh, "mesh: .obj, .stl, .ply or .off")->required();
  command
      ->add_option("--resolution", options->resolution, "voxels along the longest side, 1 to 65535")
      ->type_name("N")
      ->required();
  command->add_option("-o,--output", options->file, "where to write them: .obj or .ply")
      ->type_name("FILE")
      ->required();
  command->add_flag("--solid", options->is_solid, "also the voxels inside the mesh");
  command->add_flag("--json", options->is_json, "report as one JSON object");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  command
      ->add_option("--threads", options->threads,
                   "at most so many threads (default: as many as there are)")
      ->type_name("N");
  command->footer(kVoxelsFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_voxels(*options, output); };
  });
}

}  // namespace graze::cli
