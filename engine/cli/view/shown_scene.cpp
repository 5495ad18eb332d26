#include <graze/engine/cli/view/shown_pages.h>

#include <graze/engine/cli/output/progress.h>
#include <graze/engine/scenes/read_scene.h>
#include <graze/engine/scenes/simulation.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>
#include <vector>

namespace graze::cli {
namespace {

/// Holds a shape of a body on the page: all of it, or a part.
struct ScenePiece {
  ViewBody body;
  std::size_t of;  ///< index into Scene::bodies
  Pose pose;       ///< its pose in the body's frame
  bool is_part;
};

std::vector<ScenePiece> pieces_of(const Scene& scene, View& view) {
  std::vector<ScenePiece> pieces;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (body.parts.empty())
      pieces.push_back({view.add(scene.shapes[body.shape].shape, {.name = body.name}), i,
                        Pose::Identity(), false});
    for (std::size_t k = 0; k < body.parts.size(); ++k)
      pieces.push_back({view.add(scene.shapes[body.parts[k].shape].shape,
                                 {.name = fmt::format("{}, part {}", body.name, k)}),
                        i, body.parts[k].pose, true});
  }
  return pieces;
}

/// Says what a step is called, and what has happened in it.
ViewFrame frame_of(const Simulation& simulation, std::size_t touching, const WorldUpdate& update) {
  ViewFrame frame = {
      .label = fmt::format("step {}, t = {:.6g} s", simulation.steps(), simulation.time()),
      .state = touching > 0 ? ViewState::Touching : ViewState::Clear,
      .facts = {{"pairs that touch", static_cast<double>(touching)}}};
  // Before step 0 there was nothing.
  frame.is_change = simulation.steps() > 0 && (!update.begun.empty() || !update.ended.empty());
  if (frame.is_change)
    frame.facts.insert(frame.facts.end(), {{"begun", static_cast<double>(update.begun.size())},
                                           {"ended", static_cast<double>(update.ended.size())}});
  return frame;
}

/// Adds what touches in a step: contacts, and pairs of bodies. It takes the parts of compounds that
/// contacts name, and for a pair without contacts the first ones.
class TouchingPieces {
 public:
  explicit TouchingPieces(const std::vector<ScenePiece>& pieces) {
    for (const ScenePiece& piece : pieces) {
      if (bodies_.empty() || piece.of != of_) bodies_.emplace_back();
      of_ = piece.of;
      bodies_.back().push_back(piece.body);
    }
  }

  void add_to(View& view, const World& world, const std::vector<BodyPair>& touching) const {
    std::set<BodyPair> others(touching.begin(), touching.end());
    for (const auto& [pair, manifold] : world.contacts()) {
      for (const ShapeContact& point : manifold)
        view.add_contact(point.point, point.normal, std::max(0.0, point.depth));
      // Some are near, and do not touch.
      if (std::binary_search(touching.begin(), touching.end(), pair))
        view.add_pair(bodies_[pair.a.index][manifold.part_a()],
                      bodies_[pair.b.index][manifold.part_b()]);
      others.erase(pair);
    }
    for (const BodyPair& pair : others)
      view.add_pair(bodies_[pair.a.index][0], bodies_[pair.b.index][0]);
  }

 private:
  std::vector<std::vector<ViewBody>> bodies_;  ///< the pieces of each body of the scene
  std::size_t of_ = 0;
};

}  // namespace

bool is_scene(const std::string& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return false;
  std::ifstream bytes(file, std::ios::binary);
  const auto json = nlohmann::json::parse(bytes, nullptr, false);
  return json.is_object() && json.contains("graze_scene");
}

ShownPage show_scene(const ViewOptions& options) {
  const std::string& file = options.files.front();
  const Scene scene = read_scene(file, {.mesh_folder = options.mesh_folder});
  Simulation simulation(scene, {.world = {.threads = 1, .contacts = true}});
  check_paths(scene, simulation.time_of(scene.steps));
  ViewSettings settings = {.title = options.title.empty()
                                        ? std::filesystem::path(file).filename().string()
                                        : options.title};
  if (!scene.note.empty()) settings.notes.push_back(scene.note);
  settings.notes.emplace_back(
      "Each picture is a step. What is between two of them is not seen here.");
  ShownPage page(settings);
  const std::vector<ScenePiece> pieces = pieces_of(scene, page.view);
  const TouchingPieces touching_pieces(pieces);
  Progress progress("steps:", scene.steps, {.is_forced = options.has_progress, .has_rows = false});
  for (std::size_t i = 0; i <= scene.steps; ++i) {
    const WorldUpdate update = simulation.advance();
    const std::vector<BodyPair> touching = simulation.world().pairs();
    page.view.begin_frame(frame_of(simulation, touching.size(), update));
    ++page.frames;
    if (!touching.empty()) ++page.touching;
    for (const ScenePiece& piece : pieces) {
      const Pose pose = pose_at(scene.bodies[piece.of], simulation.time());
      page.view.place(piece.body, piece.is_part ? placed_part(pose, piece.pose) : pose);
    }
    touching_pieces.add_to(page.view, simulation.world(), touching);
    progress.update(i);
  }
  return page;
}

}  // namespace graze::cli
