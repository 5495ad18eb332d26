#include <graze/bvh/volume.h>
#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/cli/files/output_places.h>
#include <graze/engine/cli/pair/pair_job.h>
#include <graze/engine/cli/pair/pair_options.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace graze::cli {
namespace {

constexpr const char* kPairFooter = R"(
A pose is 12 numbers, the rows of the 3x4 matrix [R | t] one after the other: R a rotation, t in
metres (the meshes' unit). They stand in one quoted argument, separated by blanks or commas, or in
12 arguments. Coordinates are double precision, and every answer is exact for the placed triangles:
touching counts as intersecting, unless --touch exclude asks for triangles that cross, whose insides
go through each other, and leaves out those that share a vertex or an edge or lie in one plane.

With --json each pose gives one line:
  {"pose":0,"intersects":true,"pairs":2,"work":{"volume_tests":...,"volume_rejections":...,
   "filter_tests":...,"triangle_tests":...,"exact_tests":...,"points_tested":...,
   "skipped_by_memory":...,"trees_built":...,"skins_built":...}}
--list adds "list":[[a,b],...] after "pairs", triangles counted from 0 in the order of the files,
and --check adds "fcl":{"intersects":...,"pairs":...,"differences":[{"pair":[a,b],"graze":...,
"fcl":...,"truth":...}],"graze_wrong":0,"fcl_wrong":0}. With --query any there is no "pairs".
With --touch exclude, "intersects", "pairs" and "list" speak of triangles that cross.
With --solid, which needs closed meshes, "intersects" is true also where one is wholly inside the
other; pairs stay pairs of triangles, and there may be none. With both, "intersects" is true if the
open interiors have a point in common: solids that merely touch, as walls do that lie against each
other, do not, however much of their surfaces they share.
With --query distance there is "distance" in metres, 0 where they intersect, and where it is least:
"point_a", "point_b" and the "pair" of triangles these lie in.

--output writes an array that numpy.load() reads, an element for each pose in their order: bool for
--query any, float64 for --query distance, and for --query pairs records of "intersects", bool, and
"pairs", uint64, how many there are. All threads share the poses, unless --threads says how many.
Those of a regular file are read a part at a time, so that memory does not grow with them. The file
appears whole or not at all, and standard output says one line alone; with --json:
  {"poses":1000000,"intersecting":2001,"file":"answers.npy","work":{...}}
with "pairs", their sum, or "least_distance" and "nearest_pose" before "file".
Volumes are wide (oriented boxes, eight to a node), aabb, sphere, obb and kdop. Times are in
microseconds; the first query's time
includes building both trees and their volumes.

Examples:
  graze pair bolt.obj nut.stl
  graze pair bolt.obj nut.stl --pose-b "1 0 0 0  0 1 0 0  0 0 1 0.002" --list
  graze pair bolt.obj nut.stl --poses path.txt --query any --json
  graze pair bolt.obj nut.stl --poses path.txt --query distance --output distances.npy
  graze pair bolt.obj nut.stl --poses path.txt --check fcl
  graze pair bolt.obj nut.stl --solid --touch exclude
  graze pair bolt.obj nut.stl --threads 0

Exit codes:
  0  an answer was given, whatever it is
  1  with --check: exact arithmetic found an answer of graze to be wrong
  2  bad input, with one line on stderr: usage, meshes, poses (FILE:LINE), a file that cannot be
     written)";

std::vector<std::string> volume_names() {
  std::vector<std::string> names;
  names.reserve(kPairVolumes.size());
  for (const PairVolume volume : kPairVolumes)
    names.emplace_back(name_of(volume));
  return names;
}

}  // namespace

void add_pair_command(CLI::App& program, Action& action) {
  auto options = std::make_shared<PairOptions>();
  CLI::App* command = program.add_subcommand("pair", "Which triangles of two meshes intersect");
  command->add_option("A", options->mesh_a, "first mesh: .obj, .stl, .ply or .off")->required();
  command->add_option("B", options->mesh_b, "second mesh")->required();
  command->add_option("--pose-a", options->pose_a, "pose of A (default: identity)")->type_name("P");
  command->add_option("--pose-b", options->pose_b, "pose of B (default: identity)")->type_name("P");
  command->add_option("--poses", options->poses, "poses of B, one per line, or .npy, each a query")
      ->type_name("FILE");
  command
      ->add_option("--query", options->query,
                   "any: do they intersect; pairs (default): which triangles do; distance")
      ->type_name("any|pairs|distance")
      ->check(CLI::IsMember({"any", "pairs", "distance"}).description(""));
  command
      ->add_option("--volume", options->volume,
                   "what prunes (default: wide); changes the time, never the answer")
      ->type_name("VOLUME")
      ->check(CLI::IsMember(volume_names()).description(""));
  command
      ->add_option("--touch", options->touch,
                   "include (default): touching counts; exclude: only triangles that cross")
      ->type_name("include|exclude")
      ->check(CLI::IsMember({"include", "exclude"}).description(""));
  command->add_flag("--solid", options->is_solid,
                    "a closed mesh wholly inside the other intersects it too");
  command->add_flag("--list", options->is_listing, "print the pairs of triangles, in order");
  command
      ->add_option("--check", options->check,
                   "compare with FCL, settling differences in exact arithmetic")
      ->type_name("fcl")
      ->check(CLI::IsMember({"fcl"}).description(""));
  command
      ->add_option("--threads", options->threads,
                   "for each --query pairs (default: 1), or the poses of --output; 0: all")
      ->type_name("N");
  command
      ->add_option("--output", options->output, "write one answer a pose to a .npy file of numpy's")
      ->type_name("FILE")
      ->check(file_name());
  command->add_flag("--json", options->is_json, "one JSON object per line and pose");
  command->add_flag("--progress", options->has_progress,
                    "report progress on stderr even if it is no terminal");
  command->footer(kPairFooter);
  command->callback([options, &action] {
    action = [options](Output& output) { return run_pair(*options, output); };
  });
}

}  // namespace graze::cli
