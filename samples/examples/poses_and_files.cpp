// Poses: as text and in files, whether they are rigid, and tables by pose.

#include <filesystem>
#include <fstream>
#include <unordered_map>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

int main(int argc, char** argv) {
  if (argc != 2) return 2;  // a folder to write to
  const graze::Pose up = graze::parse_pose("1 0 0 0  0 1 0 0  0 0 1 0.002", "our pose");
  expect(graze::are_equal(up, at(0, 0, 0.002)), "rows of [R | t], metres");
  expect(graze::are_equal(graze::parse_pose(graze::to_text(up), "again"), up), "to the last bit");

  // How far from a rotation; the second throws PoseError if that is too far.
  expect(graze::rotation_deviation(up) == 0, "a translation is rigid");
  expect(graze::check_rigid(up, "our pose") <= graze::kMaxRotationDeviation, "so it may pass");

  const std::filesystem::path file = std::filesystem::path(argv[1]) / "poses.txt";
  std::ofstream(file) << graze::to_text(up) << "\n\n" << graze::to_text(at(1, 0, 0)) << "\n";
  expect(graze::load_poses(file).size() == 2, "a pose each line");
  expect(graze::load_pose_lines(file)[1].line == 3, "with their lines, for messages");
  std::filesystem::remove(file);

  std::unordered_map<graze::Pose, int, graze::PoseHash, graze::PoseEqual> visits;
  ++visits[up];
  ++visits[at(0, 0, 0.002)];
  expect(visits.size() == 1 && visits[up] == 2, "equal poses are one key");
}
