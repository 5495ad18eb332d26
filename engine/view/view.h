#pragma once

// A page that shows what is and where it meets, for people: one file that any browser opens and
// turns, without a network.
//
//   graze::View view({.title = "a bolt in its nut"});
//   const graze::ViewBody a = view.add(bolt, {.name = "bolt"}), b = view.add(nut, {.name = "nut"});
//   for (const graze::Pose& pose : poses) {
//     view.begin_frame();
//     view.place(a, graze::Pose::Identity());
//     view.place(b, pose);
//   }
//   view.write("bolt.html");

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <graze/bvh/obb.h>
#include <graze/bvh/pose.h>
#include <graze/engine/world/shape.h>
#include <graze/engine/world/world_drawing.h>

#include <Eigen/Core>

namespace graze {

/// What a page says of itself, and how finely shapes are drawn.
struct ViewSettings {
  std::string title = "graze";  ///< its heading; any text, shown as text
  std::string unit = "m";       ///< behind lengths; those in metres get the prefix that suits them
  std::vector<std::string> notes = {};  ///< for the reader: what was left out, say
  std::uint32_t segments = 48;          ///< of a circle, 8 to 1024
  /// Bodies of up to so many vertices keep them as doubles, too: the page shows the exact corners
  /// of a triangle that is picked, also in hexadecimal. 24 bytes a vertex, which hardly pack.
  std::uint32_t most_exact_vertices = 20'000;
};

/// What a body of a page looks like.
struct ViewBodySettings {
  std::string name = {};  ///< shown as text; empty: the name of its kind, and its number
  /// Red, green and blue; none: one of six that the colour-blind tell apart.
  std::optional<std::array<std::uint8_t, 3>> color = {};
  double half_space_extent = 10;  ///< metres: half the side of the square that stands for a plane
};

/// A body of a page, as View::add() gave it out.
struct ViewBody {
  std::uint32_t index = 0;  ///< counted from 0 in the order of add()
};

/// What is known of the bodies in a frame.
enum class ViewState {
  Unsaid,    ///< nothing is said
  Touching,  ///< something touches
  Clear,     ///< nothing touches
  Unknown,   ///< it was asked, and is not known
};

/// A number that stands beside the picture.
struct ViewFact {
  std::string name;        ///< what it is
  double value = 0;        ///< finite
  bool is_length = false;  ///< it is in ViewSettings::unit
};

/// A piece of a plane, a square: one that separates two bodies, say.
struct ViewPlane {
  Eigen::Vector3d point;   ///< its middle, in the common frame, metres
  Eigen::Vector3d normal;  ///< of any length but 0
  double half_extent = 1;  ///< half of its side, metres, positive
};

/// A moment, or whatever else is one picture.
struct ViewFrame {
  std::string label = {};               ///< "pose 3", "t = 0.25 s"; may be empty
  ViewState state = ViewState::Unsaid;  ///< its colour on the slider; keys jump to where it changes
  std::string says = {};                ///< in large letters; empty: a word for the state
  std::vector<ViewFact> facts = {};     ///< below it
  std::string note = {};                ///< a sentence below these; may be empty
  /// Something begins or ends here though the state stays: keys stop here, too.
  bool is_change = false;
  /// It has nothing to do with the frames before it: it is drawn about a middle and in a size of
  /// its own, and the camera goes there.
  bool is_apart = false;
};

/// Collects bodies and frames, and writes them as a page. Each shape is kept once, however many
/// bodies and frames have it: bodies that are handles to one mesh share it, as do equal shapes of
/// other kinds. Coordinates stand in the page as floats about the middle of their mesh, poses as
/// floats about that of their frames: off by some 1e-7 of these sizes. Nothing is thinned out;
/// where there are many triangles the browser draws coarser what is small on the screen, and says
/// so.
///
/// Whatever is placed or added goes to the frame that was begun last; before the first one a frame
/// without a label begins by itself. For one thread at a time.
class View {
 public:
  /// Throws InputError for settings that are none.
  explicit View(ViewSettings settings = {});
  ~View();
  View(View&& other) noexcept;             ///< what was moved from can be destroyed or assigned to
  View& operator=(View&& other) noexcept;  ///< likewise

  /// A body, which stands nowhere until it is placed. Round shapes become polygons, a height field
  /// its mesh, a half-space a square. Throws InputError for settings that are none. O(triangles).
  ViewBody add(const Shape& shape, const ViewBodySettings& settings = {});
  /// Likewise of a mesh of any size, also one that reaches beyond kLargestLength.
  ViewBody add(const Mesh& mesh, const ViewBodySettings& settings = {});

  /// A note for the reader, behind those of the settings.
  void add_note(const std::string& note);

  /// The next frame, in which no body stands yet. Throws InputError for a fact that is not finite.
  void begin_frame(const ViewFrame& frame = {});

  /// Where a body stands in this frame; said twice, the last counts. Throws InputError for a body
  /// that is none of this view, PoseError for a pose that is not rigid or leads beyond double.
  void place(ViewBody body, const Pose& pose);

  /// Triangles of a body that are red in this frame, in the order of its mesh. Throws InputError
  /// for a body that is not placed in this frame, and for a triangle that is out of range.
  void mark_triangles(ViewBody body, std::span<const std::uint32_t> triangles);

  /// Points in the common frame, joined by thick lines. All of these throw InputError for a
  /// coordinate that is not finite.
  void add_curve(std::span<const Eigen::Vector3d> points);
  /// A point alone.
  void add_point(const Eigen::Vector3d& at);
  /// A thin line.
  void add_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  /// A point with a normal, of any length but 0, and a depth in metres, which is not negative.
  void add_contact(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double depth);
  /// Two nearest points, and how far apart they are, metres and not negative.
  void add_gap(const Eigen::Vector3d& point_a, const Eigen::Vector3d& point_b, double distance);
  /// Text at a place.
  void add_label(const Eigen::Vector3d& at, const std::string& text);
  /// Drawn so that one sees through it. Throws InputError for a normal of 0 and for no extent.
  void add_plane(const ViewPlane& plane);

  /// Two bodies that touch in this frame: the page lists such pairs, and leads to where they begin
  /// to touch. The order of the two and how often it is said do not matter. Throws InputError for a
  /// body that is not placed in this frame, and for a body and itself.
  void add_pair(ViewBody a, ViewBody b);

  /// Boxes in the frame of a body, drawn wherever it stands: a level of a tree, 0 its root. The
  /// page shows one level at a time, none at first. Said twice for one level, these are added.
  /// Throws InputError for a level above 99 and PoseError or InputError for a box that is none.
  void add_boxes(ViewBody body, std::uint32_t level, std::span<const Obb> boxes);

  /// What draw() of a world draws, as lines, points and labels of this frame. Throws what that
  /// does.
  void draw(const World& world, const WorldDrawingSettings& settings = {});

  /// The page, whole. Throws InputError if there is no frame, and for more than a browser reads,
  /// 256 MiB when packed. The same calls give the same bytes.
  std::string page() const;

  /// The same as a file, which appears whole or not at all. Throws an Error that names the file if
  /// it cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace graze
