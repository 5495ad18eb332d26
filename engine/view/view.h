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

/// Holds what a page says of itself, and how finely shapes are drawn.
struct ViewSettings {
  std::string title = "graze";  ///< the page's heading; any text, shown as text
  std::string unit = "m";  ///< the unit behind lengths; those in metres get the prefix that suits
                           ///< them
  std::vector<std::string> notes = {};  ///< notes for the reader, as on what was left out
  std::uint32_t segments = 48;          ///< the number of segments of a circle, 8 to 1024
  /// Bodies of up to so many vertices keep them as doubles, too: the page shows the exact corners
  /// of a triangle that is picked, also in hexadecimal. That takes 24 bytes a vertex, which hardly
  /// pack.
  std::uint32_t most_exact_vertices = 20'000;
};

/// Says what a body of a page looks like.
struct ViewBodySettings {
  std::string name = {};  ///< a name, shown as text; if it is empty, the name of the body's kind,
                          ///< and its number
  /// The colour in red, green and blue; without one it is one of six that the colour-blind tell
  /// apart.
  std::optional<std::array<std::uint8_t, 3>> color = {};
  double half_space_extent = 10;  ///< half the side of the square that stands for a plane, metres
};

/// Names a body of a page, as View::add() gave it out.
struct ViewBody {
  std::uint32_t index = 0;  ///< the body's number, counted from 0 in the order of add()
};

/// Says what is known of the bodies in a frame.
enum class ViewState {
  Unsaid,    ///< nothing is said
  Touching,  ///< something touches
  Clear,     ///< nothing touches
  Unknown,   ///< the question was asked, and has no known answer
};

/// Holds a number that stands beside the picture.
struct ViewFact {
  std::string name;        ///< what the number is
  double value = 0;        ///< the number, finite
  bool is_length = false;  ///< true if the number is in ViewSettings::unit
};

/// Describes a piece of a plane, a square: one that separates two bodies, say.
struct ViewPlane {
  Eigen::Vector3d point;   ///< its middle, in the common frame, metres
  Eigen::Vector3d normal;  ///< its normal, of any length but 0
  double half_extent = 1;  ///< half of its side, metres, positive
};

/// Describes a moment, or whatever else is one picture.
struct ViewFrame {
  std::string label = {};               ///< "pose 3", "t = 0.25 s"; may be empty
  ViewState state = ViewState::Unsaid;  ///< the frame's colour on the slider; keys jump to where it
                                        ///< changes
  std::string says = {};  ///< text in large letters; if it is empty, a word for the state
  std::vector<ViewFact> facts = {};  ///< numbers below that text
  std::string note = {};             ///< a sentence below these; may be empty
  /// True if something begins or ends here though the state stays: keys stop here, too.
  bool is_change = false;
  /// True if the frame has nothing to do with those before it: it is drawn about a middle and in a
  /// size of its own, and the camera goes there.
  bool is_apart = false;
};

/// Collects bodies and frames, and writes them as a page. Each shape is kept once, however many
/// bodies and frames have it: bodies that are handles to one mesh share it, as do equal shapes of
/// other kinds. Coordinates stand in the page as floats about the middle of their mesh, poses as
/// floats about that of their frames: off by some 1e-7 of these sizes. Nothing is thinned out;
/// where there are many triangles the browser draws more coarsely what is small on the screen, and
/// says so.
///
/// Whatever is placed or added goes to the frame that was begun last; before the first one a frame
/// without a label begins by itself. One thread may use a View at a time.
class View {
 public:
  /// Begins a page. Throws InputError for invalid settings.
  explicit View(ViewSettings settings = {});
  ~View();
  View(View&& other) noexcept;             ///< what was moved from can be destroyed or assigned to
  View& operator=(View&& other) noexcept;  ///< what was moved from can be destroyed or assigned to

  /// Adds a body, which stands nowhere until it is placed. Round shapes become polygons, a height
  /// field its mesh, a half-space a square. Throws InputError for invalid settings. Takes
  /// O(triangles).
  ViewBody add(const Shape& shape, const ViewBodySettings& settings = {});
  /// Adds a mesh of any size in the same way, also one that reaches beyond kLargestLength.
  ViewBody add(const Mesh& mesh, const ViewBodySettings& settings = {});

  /// Adds a note for the reader, behind those of the settings.
  void add_note(const std::string& note);

  /// Begins the next frame, in which no body stands yet. Throws InputError for a fact that is not
  /// finite.
  void begin_frame(const ViewFrame& frame = {});

  /// Says where a body stands in this frame; if it is said twice, the last counts. Throws
  /// InputError for a body that is none of this view, PoseError for a pose that is not rigid or
  /// leads beyond double.
  void place(ViewBody body, const Pose& pose);

  /// Makes triangles of a body red in this frame; they are numbered in the order of its mesh.
  /// Throws InputError for a body that is not placed in this frame, and for a triangle that is out
  /// of range.
  void mark_triangles(ViewBody body, std::span<const std::uint32_t> triangles);

  /// Adds points in the common frame, joined by thick lines. All functions that add coordinates
  /// throw InputError for a coordinate that is not finite.
  void add_curve(std::span<const Eigen::Vector3d> points);
  /// Adds a point alone.
  void add_point(const Eigen::Vector3d& at);
  /// Adds a thin line.
  void add_line(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  /// Adds a point with a normal, of any length but 0, and a depth in metres, which is not negative.
  void add_contact(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double depth);
  /// Adds two nearest points, and how far apart they are, metres and not negative.
  void add_gap(const Eigen::Vector3d& point_a, const Eigen::Vector3d& point_b, double distance);
  /// Adds text at a place.
  void add_label(const Eigen::Vector3d& at, const std::string& text);
  /// Adds a plane that one sees through. Throws InputError for a normal of 0 and for no extent.
  void add_plane(const ViewPlane& plane);

  /// Adds two bodies that touch in this frame: the page lists such pairs, and leads to where they
  /// begin to touch. The order of the two and how often it is said do not matter. Throws InputError
  /// for a body that is not placed in this frame, and for a body and itself.
  void add_pair(ViewBody a, ViewBody b);

  /// Adds boxes in the frame of a body, drawn wherever it stands: a level of a tree, where 0 is its
  /// root. The page shows one level at a time, none at first. A second call for one level adds to
  /// the first. Throws InputError for a level above 99 and PoseError or InputError for an invalid
  /// box.
  void add_boxes(ViewBody body, std::uint32_t level, std::span<const Obb> boxes);

  /// Adds what draw() of a world draws as lines, points and labels of this frame. Throws what
  /// draw() throws.
  void draw(const World& world, const WorldDrawingSettings& settings = {});

  /// Returns the whole page. Throws InputError if there is no frame, and for more than a browser
  /// reads, 256 MiB when packed. The same calls give the same bytes.
  std::string page() const;

  /// Writes the page to a file, which appears whole or not at all. Throws an Error that names the
  /// file if it cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace graze
