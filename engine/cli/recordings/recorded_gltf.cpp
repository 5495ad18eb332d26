#include <graze/engine/cli/recordings/gltf_file.h>
#include <graze/engine/cli/recordings/recorded_gltf.h>
#include <graze/engine/cli/recordings/recorded_pieces.h>
#include <graze/engine/files/source.h>
#include <graze/engine/view/shapes/triangulate.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

namespace graze::cli {
namespace {

/// Holds a body in one shape, over time.
struct Track {
  std::string name;
  std::size_t first = 0;        ///< the first picture that it is in
  std::vector<Pose> poses;      ///< its poses from that one on, while it is there
  std::vector<float> presence;  ///< its presence in all pictures, as far as it is known
};

/// These are six colours that the colour-blind tell apart (Okabe and Ito, "Color universal design",
/// 2008), linear.
constexpr std::array<std::array<float, 3>, 6> kColours{{{0.79F, 0.35F, 0.0F},
                                                        {0.09F, 0.46F, 0.81F},
                                                        {0.0F, 0.34F, 0.17F},
                                                        {0.87F, 0.77F, 0.05F},
                                                        {0.0F, 0.17F, 0.45F},
                                                        {0.6F, 0.19F, 0.39F}}};

class Tracks {
 public:
  explicit Tracks(const RecordingReader& reader) : reader_(reader), bodies_(reader.start()) {
    take(reader.start());
  }

  void note(const RecordedStep& step) {
    bodies_.note(step.changes);
    names_.note(step.changes);
    for (const RecordedChange& change : step.changes) {
      if (const auto* added = std::get_if<BodyAdded>(&change)) poses_[added->id] = added->pose;
      if (const auto* moved = std::get_if<BodyMoved>(&change)) poses_[moved->id] = moved->pose;
      if (const auto* taken = std::get_if<BodyTaken>(&change))
        poses_[taken->id] = taken->motion.at(1);
      if (const auto* restored = std::get_if<WorldRestored>(&change)) take(*restored->state);
    }
    for (const BodyPair& pair : step.answers.ended)
      touching_.erase(pair);
    touching_.insert(step.answers.begun.begin(), step.answers.begun.end());
  }

  void add_picture(float seconds) {
    const std::size_t picture = seconds_.size();
    for (const auto& [id, shape] : bodies_.shapes()) {
      const auto [known, is_new] = tracks_.try_emplace({id, shape});
      Track& track = known->second;
      if (is_new) track.first = picture;
      track.name = names_.of(id);
      // While the body was not there it stood where it was last.
      if (!track.poses.empty()) track.poses.resize(picture - track.first, track.poses.back());
      track.poses.push_back(poses_.at(id));
      track.presence.resize(picture, 0);
      track.presence.push_back(1);
    }
    seconds_.push_back(seconds);
    if (!touching_.empty()) ++touching_pictures_;
  }

  RecordedGltf write(const std::string& note) {
    RecordedGltf made{.bytes = {}, .pictures = seconds_.size(), .touching = touching_pictures_};
    std::vector<std::size_t> nodes;
    times_ = file_.add_times(seconds_);
    for (auto& [look, track] : tracks_)
      nodes.push_back(add(look, track));
    made.bytes = file_.bytes(nodes, note);
    return made;
  }

 private:
  void take(const RecordedState& state) {
    for (const RecordedBody& body : state.bodies)
      poses_[body.id] = body.pose;
    touching_ = {state.touching.begin(), state.touching.end()};
  }

  /// Returns the meshes of a shape's pieces, each once.
  const std::vector<std::size_t>& meshes(std::uint32_t shape,
                                         const std::vector<RecordedPiece>& pieces) {
    const auto [known, is_new] = meshes_.try_emplace(shape);
    if (!is_new) return known->second;
    const std::array<float, 3>& colour = kColours[shape % kColours.size()];
    const std::size_t material = file_.add_material({colour[0], colour[1], colour[2]});
    for (const RecordedPiece& piece : pieces) {
      const view::Triangulation made = view::triangulate(piece.shape, {});
      known->second.push_back(file_.add_mesh(made.vertices, made.triangles, material));
    }
    return known->second;
  }

  std::size_t add(const RecordedLook& look, Track& track) {
    const std::vector<RecordedPiece> pieces = pieces_of(*reader_.shape(look.shape));
    const std::vector<std::size_t>& of_pieces = meshes(look.shape, pieces);
    const bool is_one = pieces.size() == 1 && !pieces.front().part;
    std::vector<std::size_t> children;
    for (std::size_t i = 0; !is_one && i < pieces.size(); ++i) {
      children.push_back(file_.add_node(track.name + ", part " + std::to_string(*pieces[i].part),
                                        pieces[i].pose, of_pieces[i]));
    }
    const std::size_t node = file_.add_node(
        track.name, track.poses.front(),
        is_one ? std::optional<std::size_t>(of_pieces.front()) : std::nullopt, children);
    track.presence.resize(seconds_.size(), 0);
    if (std::find(track.presence.begin(), track.presence.end(), 0.0F) != track.presence.end())
      file_.add_presence(node, times_, track.presence);
    const bool stands = std::all_of(track.poses.begin(), track.poses.end(), [&](const Pose& pose) {
      return are_equal(pose, track.poses.front());
    });
    if (stands) return node;
    track.poses.insert(track.poses.begin(), track.first, track.poses.front());
    track.poses.resize(seconds_.size(), track.poses.back());
    file_.add_motion(node, times_, track.poses);
    return node;
  }

  const RecordingReader& reader_;
  RecordedBodies bodies_;
  RecordedNames names_;
  std::map<BodyId, Pose> poses_;
  std::set<BodyPair> touching_;
  std::map<RecordedLook, Track> tracks_;
  std::vector<float> seconds_;
  std::size_t touching_pictures_ = 0;
  GltfFile file_;
  std::size_t times_ = 0;
  std::map<std::uint32_t, std::vector<std::size_t>> meshes_;
};

}  // namespace

RecordedGltf gltf_of_recording(const std::string& file, std::size_t every) {
  RecordingReader reader{std::filesystem::path(file)};
  const double length = reader.head().seconds_per_update;
  Tracks tracks(reader);
  bool has_any = false;
  while (const RecordedStep* step = reader.next()) {
    tracks.note(*step);
    if (step->number % every != 0 && step->answers.begun.empty() && step->answers.ended.empty())
      continue;
    tracks.add_picture(
        static_cast<float>(static_cast<double>(step->number) * (length > 0 ? length : 1)));
    has_any = true;
  }
  if (!has_any) throw RecordingError(mesh_io::printable(file) + ": has no update to show");
  return tracks.write(reader.head().note);
}

}  // namespace graze::cli
