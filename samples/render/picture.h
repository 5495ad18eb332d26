#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace graze::render {

/// Red, green and blue between 0 and 1, as a screen shows them.
struct Colour {
  double red;
  double green;
  double blue;
};

inline constexpr Colour kSteel{0.62, 0.70, 0.80};
inline constexpr Colour kSand{0.87, 0.76, 0.55};
inline constexpr Colour kAlarm{0.90, 0.16, 0.06};

/// A placed mesh in one colour; the triangles listed in `marked` are drawn in kAlarm. It refers to
/// the mesh, which must outlive it. All `copies` belong to the part, too: they show the same, in
/// other poses, for little more than the space of a pose.
struct Part {
  std::string name;
  const Mesh& mesh;
  Pose pose;
  Colour colour;
  std::vector<std::uint32_t> marked;
  std::vector<Pose> copies{};
};

/// Takes away what lies on the side of a plane that `normal` points to. The parts are solids: the
/// plane closes them again, and shows in kAlarm where two parts that it cuts overlap.
struct Cut {
  Eigen::Vector3d point;           ///< metres
  Eigen::Vector3d normal;          ///< unit length
  std::vector<std::size_t> parts;  ///< which parts are cut, as indices; the others stay whole
};

/// Whether a panel shows the marks of the parts' triangles. A section is easier to read without.
enum class Marks { Shown, Hidden };

/// One view of all parts, without perspective.
struct Panel {
  std::string caption;
  Eigen::Vector3d centre;  ///< this point, metres, is in the middle
  Eigen::Vector3d towards_viewer;
  Eigen::Vector3d up;
  double height;  ///< how much of the scene the panel's height shows, metres
  std::optional<Cut> cut;
  Marks marks = Marks::Shown;
};

struct Picture {
  std::string title;
  std::vector<Part> parts;
  std::vector<Panel> panels;  ///< side by side, one to three
};

/// Writes the picture as a scene of the ray tracer POV-Ray; `samples/draw` turns it into a PNG.
/// Throws graze::Error, naming the file or the element, if it cannot be written or refers to a part
/// or triangle that does not exist.
void write_scene(const std::filesystem::path& path, const Picture& picture);

}  // namespace graze::render
