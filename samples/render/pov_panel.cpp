#include "samples/render/pov_panel.h"

#include <graze/bvh/error.h>
#include <Eigen/Geometry>
#include <algorithm>

#include "samples/render/pov_part.h"
#include "samples/render/pov_text.h"

namespace graze::render {
namespace {

// Overlaps are drawn in front of the caps by this part of the panel's height.
constexpr double kOverlapOffset = 1e-5;

void check_cut(const Panel& panel, std::size_t part_count) {
  if (!panel.cut) return;
  for (std::size_t part : panel.cut->parts) {
    if (part >= part_count) {
      throw InputError("panel '" + panel.caption + "' cuts part " + std::to_string(part) +
                       ", which does not exist");
    }
  }
}

bool is_cut(const Panel& panel, std::size_t part) {
  return panel.cut && std::ranges::count(panel.cut->parts, part) > 0;
}

// The plane of a cut, moved towards the viewer by `offset` millimetres; left open for modifiers.
std::string open_plane(const Cut& cut, double offset) {
  const Eigen::Vector3d normal = cut.normal.normalized();
  return "plane { " + vector(normal) + ", " + number(normal.dot(cut.point) * kMillimetres + offset);
}

std::string within(const std::string& solids) {
  return " clipped_by { intersection { " + solids + "} }";
}

std::string object(const std::string& name) {
  return "object { " + name + " } ";
}

// What is left of a part, and the plane where it lies inside the part. Both are clipped surfaces:
// the same picture as an intersection of solids, in a fraction of the time.
std::string cut_part(const Panel& panel, std::size_t part) {
  return "    object { " + coloured_name(part, panel.marks) + " clipped_by { " +
         open_plane(*panel.cut, 0) + " } } }\n    " + open_plane(*panel.cut, 0) + " texture { " +
         cap_name(part) + " }" + within(object(solid_name(part))) + " }\n";
}

std::string intersects(const Panel& panel) {
  const std::vector<std::size_t>& parts = panel.cut->parts;
  const double offset = kOverlapOffset * panel.height * kMillimetres;
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      text += "    " + open_plane(*panel.cut, offset) + " texture { alarm }" +
              within(object(solid_name(parts[i])) + object(solid_name(parts[j]))) + " }\n";
    }
  }
  return text;
}

// Turns the scene so that the viewer looks along -z of the page, and scales it into the slot.
// POV-Ray multiplies rows from the left: row i is where unit vector i goes.
std::string to_page(const Panel& panel, const Slot& slot) {
  const Eigen::Vector3d towards = panel.towards_viewer.normalized();
  const Eigen::Vector3d right = panel.up.cross(towards).normalized();
  const Eigen::Vector3d up = towards.cross(right);
  const double scale = slot.height / (panel.height * kMillimetres);
  std::string text = "matrix <";
  for (int i = 0; i < 3; ++i) {
    text += number(scale * right[i]) + ", " + number(scale * up[i]) + ", " +
            number(scale * towards[i]) + ", ";
  }
  const Eigen::Vector3d middle = panel.centre * kMillimetres * scale;
  return text + number(slot.centre_x - right.dot(middle)) + ", " +
         number(slot.centre_y - up.dot(middle)) + ", " + number(-towards.dot(middle)) + ">";
}

std::string clip_to(const Slot& slot) {
  const Eigen::Vector3d half(slot.width / 2, slot.height / 2, 1e4);
  const Eigen::Vector3d middle(slot.centre_x, slot.centre_y, 0);
  return "clipped_by { box { " + vector(middle - half) + ", " + vector(middle + half) + " } }";
}

}  // namespace

std::string place_panel(const Panel& panel, std::size_t part_count, const Slot& slot) {
  check_cut(panel, part_count);
  std::string text = "object {\n  union {\n";
  for (std::size_t i = 0; i < part_count; ++i) {
    text += is_cut(panel, i) ? cut_part(panel, i)
                             : "    " + object(coloured_name(i, panel.marks)) + "\n";
  }
  if (panel.cut) text += intersects(panel);
  return text + "  }\n  " + to_page(panel, slot) + "\n  " + clip_to(slot) + "\n}\n";
}

}  // namespace graze::render
