#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/file_bytes.h>
#include <graze/engine/scenes/read/scene_parts.h>
#include <graze/engine/scenes/read_scene.h>

#include <algorithm>
#include <string>

namespace graze {
namespace {

using cases::JsonCursor;

constexpr std::uint32_t kSceneVersion = 1;

scenes::SceneUnits read_units(const JsonCursor& root) {
  scenes::SceneUnits units;
  if (!root.has("units")) return units;
  const JsonCursor at = root.member("units");
  at.require_keys({"length", "angle"});
  if (at.has("length")) units.length = scenes::read_length_unit(at.member("length"));
  if (at.has("angle")) units.angle = scenes::read_angle_unit(at.member("angle"));
  return units;
}

void read_steps(const JsonCursor& root, Scene& scene) {
  if (root.has("step")) {
    const JsonCursor at = root.member("step");
    scene.step = at.number();
    if (!(scene.step > 0)) at.fail("is not positive");
  }
  if (root.has("steps")) {
    scene.steps = static_cast<std::size_t>(
        root.member("steps").whole(0, static_cast<std::int64_t>(kMaxSceneSteps)));
  }
}

void read_exclusions(const JsonCursor& at, const scenes::NameTable& bodies, Scene& scene) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    const JsonCursor pair = at.item(i);
    pair.require_size(2);
    const std::size_t a = bodies.find(pair.item(0));
    const std::size_t b = bodies.find(pair.item(1));
    if (a == b) pair.fail("a body is excluded from itself");
    scene.exclusions.push_back({std::min(a, b), std::max(a, b)});
  }
}

Scene scene_of(const JsonCursor& root, scenes::MeshFiles& files) {
  root.require_keys(
      {"graze_scene", "note", "units", "step", "steps", "shapes", "bodies", "exclusions"});
  const JsonCursor version = root.member("graze_scene");
  if (version.index(0xffffffffu) != kSceneVersion) {
    version.fail("is version " + std::to_string(version.index(0xffffffffu)) +
                 "; this program reads " + std::to_string(kSceneVersion));
  }
  Scene scene;
  if (root.has("note")) scene.note = root.member("note").text();
  read_steps(root, scene);
  const scenes::SceneUnits units = read_units(root);
  scenes::NameTable shapes("shape");
  const JsonCursor shape_list = root.member("shapes");
  for (std::size_t i = 0; i < shape_list.size(); ++i) {
    const JsonCursor at = shape_list.item(i);
    Shape shape = read_scene_shape(at, units, files);
    scene.shapes.push_back({shapes.add(at.member("name")), std::move(shape)});
  }
  scenes::NameTable bodies("body");
  const JsonCursor body_list = root.member("bodies");
  for (std::size_t i = 0; i < body_list.size(); ++i) {
    const JsonCursor at = body_list.item(i);
    scene.bodies.push_back(read_body(at, units, scene, shapes));
    bodies.add(at.member("name"));
  }
  if (root.has("exclusions")) read_exclusions(root.member("exclusions"), bodies, scene);
  return scene;
}

}  // namespace

Scene parse_scene(std::string_view bytes, const std::string& name,
                  const ReadSceneSettings& settings) {
  return bvh::in_standard_arithmetic([&]() -> Scene {
    const std::string printable = mesh_io::printable(name);
    try {
      const cases::JsonValue tree = cases::parse_json(bytes, printable);
      scenes::MeshFiles files(settings.mesh_folder);
      return scene_of(JsonCursor(tree, printable), files);
    } catch (const CaseError& error) {
      throw SceneError(error.what(), error.place());
    }
  });
}

Scene read_scene(const std::filesystem::path& path, const ReadSceneSettings& settings) {
  return bvh::in_standard_arithmetic([&]() -> Scene {
    const std::string name = path.string();
    ReadSceneSettings here = settings;
    if (here.mesh_folder.empty()) here.mesh_folder = path.parent_path();
    std::string bytes;
    try {
      mesh_io::require_regular_file(path, mesh_io::printable(name));
      bytes = mesh_io::read_file(path, mesh_io::printable(name));
    } catch (const MeshError& error) {
      throw SceneError(error.what(), error.place());
    }
    return parse_scene(bytes, name, here);
  });
}

}  // namespace graze
