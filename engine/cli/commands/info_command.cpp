#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/reports/mesh_report.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace graze::cli {
namespace {

constexpr const char* kInfoFooter = R"(
Vertices are counted as the file gives them, and once more with equal positions welded into one. A
mesh is closed if each welded edge has an even number of triangles; the others are its boundary
edges. Degenerate triangles have no area; duplicate ones have the same welded vertices as an
earlier one. Crossing pairs (--self) share more than the vertex or edge that they have in common.
Lengths are in the unit of the file, taken as metres. The tree is what queries walk: a random line
through the mesh's box is expected to visit so many of its nodes and triangles (the surface area
heuristic).

With --check, what is wrong with the mesh, and where, in numbers of vertices and triangles that
count from 0: open edges, where the surface ends; non-manifold edges, of more than two triangles;
turned edges, whose triangles face opposite sides; degenerate and duplicate triangles; inside-out
parts, closed ones that do not face outwards, or into the cavity that they bound; and triangles
that intersect. Beside a triangle stands the line of the file, counted from 1, or the byte, counted
from 0, at which its polygon begins. --json lists the first thousand of each.

With --fit, of the bounding volumes around the mesh, how much space each leaves empty: of a closed
mesh the share of the volume that the mesh does not enclose, in per cent; of an open one its
volume relative to that of the box along the axes. What a mesh encloses follows from the sense of
its triangles: a mesh that crosses itself may count parts twice. The volumes are the box along the
axes (aabb), the smallest sphere, the tightest oriented box found (obb) and the polytope of 18
half-spaces (kdop). Level by level of the tree, from the root down, the volume of all boxes, and
that of the other volumes over the same nodes relative to it: what lies below a node is an open
patch of surface.

Examples:
  graze info bolt.obj
  graze info --check bolt.obj
  graze info --fit bolt.obj
  graze info --self --json *.stl

Exit codes:
  0  an answer was given
  1  --check found something wrong with a mesh
  2  bad input, with one line on stderr and nothing on stdout)";

struct InfoOptions {
  std::vector<std::string> meshes;
  bool is_json = false;
  bool is_self = false;
  bool has_fits = false;
  bool is_check = false;
  bool has_progress = false;
};

/// Reads all meshes before it prints the first: a bad one leaves standard output empty.
ExitCode run_info(const InfoOptions& options, Output& output) {
  constexpr std::size_t kPerCent = 100;
  const std::size_t count = options.meshes.size();
  std::string text;
  bool is_healthy = true;
  {
    Progress progress("per cent:", kPerCent, {.is_forced = options.has_progress});
    for (std::size_t i = 0; i < count; ++i) {
      const auto on_progress = [&](std::size_t done) {
        progress.update((kPerCent * i + done) / count);
      };
      const MeshReport report =
          report_mesh(options.meshes[i], {.has_fits = options.has_fits,
                                          .has_self_intersections = options.is_self,
                                          .has_health = options.is_check,
                                          .on_progress = on_progress});
      if (i > 0 && !options.is_json) text += "\n";
      text += options.is_json ? to_json(report) : to_text(report);
      is_healthy &= !report.health || report.health->is_healthy();
    }
  }
  output.write(text);
  return is_healthy ? ExitCode::Answered : ExitCode::Failed;
}

}  // namespace

void add_info_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand("info", "What a mesh is made of");
  command->add_option("MESH", options->meshes, "meshes: .obj, .stl, .ply or .off")->required();
  command->add_flag("--check", options->is_check,
                    "what is wrong with the mesh, and where; exit code 1 if anything is");
  command->add_flag("--fit", options->has_fits,
                    "how well bounding volumes fit the mesh and its tree (may take long)");
  command->add_flag("--self", options->is_self,
                    "count the pairs of triangles that intersect (may take long)");
  command->add_flag("--json", options->is_json, "one JSON object per line and mesh");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  command->footer(kInfoFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_info(*options, output); };
  });
}

}  // namespace graze::cli
