#include "samples/render/pov_part.h"

#include <graze/bvh/error.h>

#include "samples/render/pov_text.h"

namespace graze::render {
namespace {

std::string skin_texture(const Colour& colour) {
  return "texture { pigment { " + srgb(colour) +
         " } finish { ambient 0.28 diffuse 0.62 specular 0.12 roughness 0.05 } }";
}

// Caps are flat colour, paler than the surface, as on a drawing.
std::string cap_texture(const Colour& colour) {
  const auto paler = [](double value) { return 0.55 * value + 0.45; };
  return flat({paler(colour.red), paler(colour.green), paler(colour.blue)});
}

std::vector<bool> is_marked(const Part& part) {
  std::vector<bool> result(part.mesh.triangles().size(), false);
  for (std::uint32_t t : part.marked) {
    if (t >= result.size()) {
      throw InputError(part.name + ": marked triangle " + std::to_string(t) + " does not exist");
    }
    result[t] = true;
  }
  return result;
}

std::string vertex_vectors(const Part& part) {
  std::string text = "  vertex_vectors { " + std::to_string(part.mesh.vertices().size());
  for (const Eigen::Vector3d& v : part.mesh.vertices()) {
    text += ",\n" + vector(part.pose * v * kMillimetres);
  }
  return text + " }\n";
}

std::string face(const TriangleIndices& triangle) {
  return ",\n<" + std::to_string(triangle[0]) + ", " + std::to_string(triangle[1]) + ", " +
         std::to_string(triangle[2]) + ">";
}

// POV-Ray multiplies rows from the left: row i is where unit vector i goes.
std::string moved(const std::string& name, const Pose& by) {
  std::string text = "object { " + name + " matrix <";
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      text += number(by.linear()(k, i)) + ", ";
  }
  const Eigen::Vector3d shift = by.translation() * kMillimetres;
  return text + number(shift.x()) + ", " + number(shift.y()) + ", " + number(shift.z()) + "> }\n";
}

/// Makes of a name that is declared the same with all the part's copies. A mesh is stored once.
std::string with_copies(const Part& part, const std::string& name) {
  if (part.copies.empty()) return "";
  std::string text = "#declare " + name + " = union {\nobject { " + name + " }\n";
  for (const Pose& copy : part.copies)
    text += moved(name, copy * part.pose.inverse());
  return text + "}\n";
}

}  // namespace

std::string solid_name(std::size_t index) {
  return "solid_" + std::to_string(index);
}

std::string coloured_name(std::size_t index, Marks marks) {
  return (marks == Marks::Shown ? "marked_" : "plain_") + std::to_string(index);
}

std::string cap_name(std::size_t index) {
  return "cap_" + std::to_string(index);
}

std::string declare_alarms() {
  return "#declare alarm = " + flat(kAlarm) + "\n#declare marked = texture { pigment { " +
         srgb(kAlarm) + " } finish { ambient 0.55 diffuse 0.45 } }\n";
}

std::string declare_part(const Part& part, std::size_t index) {
  const std::vector<bool> marks = is_marked(part);
  const std::string vertices = vertex_vectors(part);
  const std::string count = std::to_string(marks.size());
  std::string plain;
  std::string marked;
  for (std::size_t t = 0; t < marks.size(); ++t) {
    plain += face(part.mesh.triangles()[t]);
    marked += face(part.mesh.triangles()[t]) + (marks[t] ? ", 1" : ", 0");
  }
  const std::string skin = "skin_" + std::to_string(index);
  // POV-Ray wants the bare solid to tell inside from outside: it counts how often a ray in the
  // direction of inside_vector meets the surface.
  return "#declare " + skin + " = " + skin_texture(part.colour) + "\n#declare " + cap_name(index) +
         " = " + cap_texture(part.colour) + "\n#declare " + solid_name(index) + " = mesh2 {\n" +
         vertices + "  face_indices { " + count + plain +
         " }\n  inside_vector <0.3141, 0.2718, 0.9097>\n}\n#declare " +
         coloured_name(index, Marks::Hidden) + " = object { " + solid_name(index) + " texture { " +
         skin + " } }\n#declare " + coloured_name(index, Marks::Shown) + " = mesh2 {\n" + vertices +
         "  texture_list { 2, texture { " + skin + " } texture { marked } }\n  face_indices { " +
         count + marked + " }\n}\n" + with_copies(part, solid_name(index)) +
         with_copies(part, coloured_name(index, Marks::Hidden)) +
         with_copies(part, coloured_name(index, Marks::Shown));
}

}  // namespace graze::render
