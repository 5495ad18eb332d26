// Errors: one line for people, and the place for programs.

#include <filesystem>
#include <fstream>
#include <stop_token>
#include <string>

#include "samples/examples/example.h"

using examples::at;
using examples::expect;

namespace {

/// What a call throws of a class of errors.
template <typename Kind, typename Call>
graze::ErrorPlace thrown_by(Call&& call) {
  try {
    call();
  } catch (const Kind& error) {
    expect(std::string(error.what()).find('\n') == std::string::npos, "one line");
    return error.place();
  }
  expect(false, "nothing was thrown");
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;  // a folder to write to
  const std::filesystem::path file = std::filesystem::path(argv[1]) / "broken.obj";
  std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 0 1 zero\nf 1 2 3\n";
  const graze::ErrorPlace in_file = thrown_by<graze::MeshError>([&] { graze::load_mesh(file); });
  expect(in_file.line == 3 && in_file.file == file.string(), "the file and the line");
  std::filesystem::remove(file);

  const std::vector<Eigen::Vector3d> corners(3, Eigen::Vector3d::Zero());
  const graze::ErrorPlace element = thrown_by<graze::MeshError>([&] {
    graze::Mesh(corners, std::array<graze::TriangleIndices, 1>{{{0, 1, 3}}});
  });
  expect(element.element == "triangle" && element.index == 0u, "which triangle has no such vertex");

  thrown_by<graze::InputError>([] { graze::check_sphere({{0, 0, 0}, -1}, "ball"); });
  thrown_by<graze::PoseError>([] { graze::parse_pose("1 2 3", "three numbers"); });
  thrown_by<graze::StaleIdError>([] { graze::World().remove(graze::BodyId{}); });
  const graze::HalfSpace below{{0, 0, 1}};
  thrown_by<graze::UnsupportedPairError>([&] {
    graze::find_contacts({below}, {below, at(0, 0, 0)});
  });
  std::stop_source source;
  source.request_stop();
  const std::vector<graze::Pose> poses(100, graze::Pose::Identity());
  try {
    const graze::Mesh cube = examples::cube(1);
    graze::intersects({cube}, {cube, poses}, {}, {.stop = source.get_token()});
    expect(false, "a batch that was stopped has no answer");
  } catch (const graze::StoppedError& error) {
    expect(error.done() == 0 && error.total() == 100, "how many of how many were done");
  }
  thrown_by<graze::Error>([] { graze::load_poses("no such file"); });  // all derive from this
}
