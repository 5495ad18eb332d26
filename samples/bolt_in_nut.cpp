// A nut on a bolt: screwed on straight it never touches, cross-threaded it binds; in poses, and in
// the motions between them. bolt_in_nut DATA_DIR [SCENE.pov]: the scene is a picture of the nut
// at 1.5 degrees, for samples/draw.

#include <graze/graze.h>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "samples/pose_table.h"
#include "samples/render/picture.h"

namespace {

// Known from how the poses are made (data/README.md): the nut binds from half a degree on.
constexpr std::size_t kFirstBinding = 6;
constexpr double kDegreesPerPose = 2.0 / 24;
constexpr std::size_t kPicturedPose = 18;

void write_picture(const graze::Mesh& bolt, const graze::Mesh& nut, const graze::Pose& pose,
                   const char* path) {
  const graze::TrianglePairs pairs = graze::find_triangle_pairs({bolt}, {nut, pose});
  graze::render::Part steel{"bolt M8", bolt, graze::Pose::Identity(), graze::render::kSteel, {}};
  graze::render::Part sand{"nut", nut, pose, graze::render::kSand, {}};
  for (const graze::TrianglePair& pair : pairs) {
    steel.marked.push_back(pair.a);
    sand.marked.push_back(pair.b);
  }
  // The nut tilts about x, so that it binds at -y, where the first view looks; the second one cuts
  // along the y axis and shows the flanks there.
  const Eigen::Vector3d front(std::sin(0.5), -std::cos(0.5), 0);
  const Eigen::Vector3d up(0, 0, 1);
  const Eigen::Vector3d flanks(0, -0.00362, 0.01125);
  char title[100];
  std::snprintf(title, sizeof title,
                "A nut cross-threaded by %.1f degrees: %zu pairs of triangles intersect",
                kPicturedPose * kDegreesPerPose, pairs.size());
  graze::render::write_scene(path, {title,
                                    {steel, sand},
                                    {{.caption = "The nut cut open: triangles that intersect",
                                      .centre = {0, 0, 0.0074},
                                      .towards_viewer = front + 0.55 * up,
                                      .up = up,
                                      .height = 0.029,
                                      .cut = graze::render::Cut{{0, 0, 0}, front, {1}}},
                                     {.caption = "Section, 4 mm high: the solids overlap",
                                      .centre = flanks,
                                      .towards_viewer = {1, 0, 0},
                                      .up = up,
                                      .height = 0.0042,
                                      .cut = graze::render::Cut{{0, 0, 0}, {1, 0, 0}, {0, 1}},
                                      .marks = graze::render::Marks::Hidden}}});
}

/// What happens between poses: the nut falls onto the bolt, and is screwed on with the thread's
/// lead and with one that is a fifth too long. Whether all came out as it must.
bool answer_motions(const graze::Mesh& bolt, const graze::Mesh& nut,
                    const graze::Pose& screwed_on) {
  constexpr double kLead = 1.25e-3;  // metres for each turn (data/README.md)
  constexpr double kAngle = 0.45 * 2 * 3.141592653589793;
  graze::Pose above = screwed_on;
  above.translation().z() = 0.04;
  const auto landed = graze::cast({bolt}, {nut, above}, {0, 0, -0.04});
  std::printf("\nThe nut let fall from 40 mm");
  if (landed) {
    std::printf(": it lands after %.6f mm, its triangle %u on triangle %u of the bolt",
                40 * landed->time, landed->pair.b, landed->pair.a);
  }
  const graze::RigidMotion rest(graze::Pose::Identity());
  const auto turned = [&](double lead) {
    return graze::first_contact(
        {bolt, rest}, {nut, graze::RigidMotion::screw(
                                screwed_on, {.axis = {0, 0, -1}, .angle = kAngle, .pitch = lead})});
  };
  const graze::RigidContact right = turned(kLead), wrong = turned(1.2 * kLead);
  const bool is_free = right.status == graze::RigidStatus::Free;
  const bool does_bind = wrong.status == graze::RigidStatus::Hit;
  std::printf("\nScrewed on by 0.45 turns with the thread's lead: %s\n",
              is_free ? "proved free of contact all the way" : "not free");
  std::printf("With a lead that is a fifth too long: %s after %.6f turns\n",
              does_bind ? "it binds" : "it does not bind", 0.45 * wrong.low);
  return landed && landed->time > 0 && is_free && does_bind;
}

int run(const std::filesystem::path& data, const char* scene) {
  const graze::Mesh bolt = graze::load_mesh(data / "meshes/bolt.obj");
  const graze::Mesh nut = graze::load_mesh(data / "meshes/nut.stl");
  const auto turning = graze::load_poses(data / "poses/bolt-nut.turning.txt");
  const auto cross = graze::load_poses(data / "poses/bolt-nut.cross.txt");

  const auto is_turning_hit = graze::samples::answer_poses(
      bolt, nut, turning, {"The nut screwed on by two turns", "turned, deg", 0, -10, 9});
  const auto is_cross_hit = graze::samples::answer_poses(
      bolt, nut, cross, {"The nut tilted on the thread", "tilted, deg", 0, kDegreesPerPose, 1});
  const bool are_motions_right = answer_motions(bolt, nut, turning.front());
  if (scene != nullptr) write_picture(bolt, nut, cross.at(kPicturedPose), scene);

  const bool is_right = are_motions_right &&
                        graze::samples::first_hit(is_turning_hit) == turning.size() &&
                        graze::samples::first_hit(is_cross_hit) == kFirstBinding &&
                        std::all_of(is_cross_hit.begin() + kFirstBinding, is_cross_hit.end(),
                                    [](bool is_hit) { return is_hit; });
  std::printf("\n%s: straight it turns freely, tilted it binds from %.3f degrees on\n",
              is_right ? "as it must be" : "WRONG, it must be",
              static_cast<double>(kFirstBinding) * kDegreesPerPose);
  return is_right ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: bolt_in_nut DATA_DIR [SCENE.pov]\n");
    return 2;
  }
  try {
    return run(argv[1], argc == 3 ? argv[2] : nullptr);
  } catch (const graze::Error& error) {
    std::fprintf(stderr, "bolt_in_nut: %s\n", error.what());
    return 1;
  }
}
