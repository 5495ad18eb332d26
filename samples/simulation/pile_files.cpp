#include "samples/simulation/pile_files.h"

#include <array>

#include "samples/render/picture.h"
#include "samples/simulation/gltf_writer.h"

namespace graze::samples {
namespace {

constexpr double kWaiting = 2;  // metres above: there the animation has bodies before they start
constexpr std::array kColours{render::kSteel, render::kSand};
constexpr render::Colour kBin{0.45, 0.5, 0.55};

render::Colour colour_of(std::size_t kind) {
  return kColours[kind % kColours.size()];
}

/// Converts what a screen shows to what glTF asks for.
std::array<double, 3> linear(const render::Colour& colour) {
  return {colour.red * colour.red, colour.green * colour.green, colour.blue * colour.blue};
}

}  // namespace

void write_animation(const std::filesystem::path& path, const Pile& pile) {
  GltfScene scene{.shapes = {{"bin", pile.bin, linear(kBin)}}, .bodies = {}, .times = pile.times};
  for (std::size_t kind = 0; kind < pile.kinds.size(); ++kind)
    scene.shapes.push_back({pile.kinds[kind].name, pile.kinds[kind].mesh, linear(colour_of(kind))});
  scene.bodies.push_back({0, {Pose::Identity()}});
  for (const Pile::Body& body : pile.bodies) {
    Pose waiting = body.frames.empty() ? body.pose : body.frames.front();
    waiting.translation().z() += kWaiting;
    std::vector<Pose> poses(body.first_frame, waiting);
    poses.insert(poses.end(), body.frames.begin(), body.frames.end());
    scene.bodies.push_back({body.kind + 1, std::move(poses)});
  }
  write_gltf(path, scene);
}

void write_picture(const std::filesystem::path& path, const Pile& pile) {
  std::vector<render::Part> parts{{"bin", pile.bin, Pose::Identity(), kBin, {}}};
  for (std::size_t kind = 0; kind < pile.kinds.size(); ++kind) {
    std::vector<Pose> poses;
    for (const Pile::Body& body : pile.bodies) {
      if (body.kind == kind) poses.push_back(body.pose);
    }
    if (poses.empty()) continue;
    parts.push_back({pile.kinds[kind].name, pile.kinds[kind].mesh, poses[0], colour_of(kind), {}});
    parts.back().copies.assign(poses.begin() + 1, poses.end());
  }
  const Eigen::Vector3d front(0.3, -1, 0);
  const Eigen::Vector3d up(0, 0, 1);
  const Eigen::Vector3d middle(0, 0, 0.5 * pile.bin_height);
  render::write_scene(path, {pile.title,
                             parts,
                             {{.caption = "The bin cut open",
                               .centre = middle,
                               .towards_viewer = front + 0.45 * up,
                               .up = up,
                               .height = 0.19,
                               .cut = render::Cut{0.03 * front, front.normalized(), {0}}},
                              {.caption = "From above",
                               .centre = middle,
                               .towards_viewer = up,
                               .up = -front,
                               .height = 0.19,
                               .cut = {}}}});
}

}  // namespace graze::samples
