#include "data/pose_file.h"

#include <graze/bvh/error.h>
#include <fstream>
#include <sstream>
#include <string>

namespace graze::data {
namespace {

Pose parse_pose(const std::string& line, const std::string& place) {
  std::istringstream numbers(line);
  numbers.imbue(std::locale::classic());
  Pose pose = Pose::Identity();
  for (int i = 0; i < 12; ++i) {
    if (!(numbers >> pose.matrix()(i / 4, i % 4))) {
      throw Error(place + "number " + std::to_string(i + 1) + " of 12 is missing or no number");
    }
  }
  if (!(numbers >> std::ws).eof()) throw Error(place + "more than 12 numbers");
  check_rigid(pose, (place + "pose").c_str());
  return pose;
}

}  // namespace

std::vector<Pose> read_poses(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<Pose> poses;
  for (std::string line; std::getline(file, line);) {
    const std::string place = path.string() + ':' + std::to_string(poses.size() + 1) + ": ";
    poses.push_back(parse_pose(line, place));
  }
  if (!file.eof()) throw Error(path.string() + ": cannot read");
  if (poses.empty()) throw Error(path.string() + ": no poses");
  return poses;
}

}  // namespace graze::data
