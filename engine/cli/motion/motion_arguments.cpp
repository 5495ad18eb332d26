#include <graze/engine/cli/motion/motion_arguments.h>
#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/files/number_list.h>
#include <graze/engine/files/source.h>
#include <graze/engine/pose_text.h>

#include <cstddef>

namespace graze::cli {
namespace {

RigidMotion between(const Pose& start, const Pose& end, const MotionArguments& arguments) {
  return arguments.is_screwed ? RigidMotion::screw_between(start, end)
                              : RigidMotion::between(start, end);
}

Screw read_screw(const std::string& text) {
  constexpr std::size_t kCount = 8;
  const std::vector<double> n = files::parse_numbers(text, "--screw");
  if (n.size() != kCount) {
    throw PoseError("--screw: " + std::to_string(n.size()) +
                    (n.size() == 1 ? " number" : " numbers") +
                    ", a screw has 8: a point, an axis, an angle and a pitch");
  }
  return {.point = {n[0], n[1], n[2]}, .axis = {n[3], n[4], n[5]}, .angle = n[6], .pitch = n[7]};
}

std::vector<RigidMotion> read_path(const MotionArguments& arguments) {
  const std::vector<PoseLine> poses = load_pose_lines(arguments.path);
  if (poses.size() < 2) {
    throw PoseError(mesh_io::printable(arguments.path) + ": one pose, a path has two or more",
                    {.file = arguments.path});
  }
  std::vector<RigidMotion> motions;
  for (std::size_t i = 1; i < poses.size(); ++i)
    motions.push_back(between(poses[i - 1].pose, poses[i].pose, arguments));
  return motions;
}

}  // namespace

std::vector<RigidMotion> read_motions(const MotionArguments& arguments) {
  const int given = !arguments.to.empty() + !arguments.screw.empty() + !arguments.path.empty();
  if (given != 1) throw UsageError("one of --to, --screw and --path says how B moves");
  if (!arguments.path.empty()) {
    if (!arguments.from.empty())
      throw UsageError("--from and --path exclude each other: a path begins with its first pose");
    return read_path(arguments);
  }
  const Pose start =
      arguments.from.empty() ? Pose::Identity() : parse_pose(arguments.from, "--from");
  if (arguments.screw.empty()) return {between(start, parse_pose(arguments.to, "--to"), arguments)};
  if (arguments.is_screwed)
    throw UsageError("--as-screw is about motions between poses, which --screw is not");
  return {RigidMotion::screw(start, read_screw(arguments.screw))};
}

}  // namespace graze::cli
