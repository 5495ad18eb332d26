#include <graze/bvh/error.h>
#include <algorithm>
#include <fstream>

#include "samples/render/picture.h"
#include "samples/render/pov_panel.h"
#include "samples/render/pov_part.h"
#include "samples/render/pov_text.h"

namespace graze::render {
namespace {

// The page: 16 x 9 units with the origin in its middle. samples/draw keeps this proportion.
constexpr double kPageWidth = 16;
constexpr double kPageHeight = 9;
constexpr double kMargin = 0.35;
constexpr double kHeader = 1.5;     // title and legend
constexpr double kFooter = 0.75;    // captions
constexpr double kTextDepth = 2e4;  // in front of everything

constexpr Colour kInk{0.13, 0.15, 0.18};
constexpr Colour kPanelGround{0.955, 0.96, 0.965};

std::string preamble() {
  return "#version 3.7;\n"
         "global_settings { assumed_gamma 1 }\n"
         "background { color srgb <1, 1, 1> }\n"
         "camera { orthographic location <0, 0, 30000> direction <0, 0, -1>\n"
         "  right <16, 0, 0> up <0, 9, 0> }\n"
         "light_source { <-12000, 16000, 25000> color rgb 0.75 parallel point_at <0, 0, 0>\n"
         "  shadowless }\n"
         "light_source { <20000, 3000, 16000> color rgb 0.40 parallel point_at <0, 0, 0>\n"
         "  shadowless }\n";
}

// POV-Ray brings this font, a sans-serif, with itself.
std::string text_object(const std::string& text, double size) {
  return "text { internal 2 " + quoted(text) + " 0.01, 0 scale " + number(size) + " " + flat(kInk) +
         " }";
}

std::string text_at(const std::string& text, double size, double x, double y) {
  return "object { " + text_object(text, size) + " translate " + vector({x, y, kTextDepth}) +
         " }\n";
}

std::string rectangle(const Slot& slot, double z, const Colour& colour) {
  const Eigen::Vector3d half(slot.width / 2, slot.height / 2, 0.01);
  const Eigen::Vector3d middle(slot.centre_x, slot.centre_y, z);
  return "box { " + vector(middle - half) + ", " + vector(middle + half) + " " + flat(colour) +
         " }\n";
}

// From left to right below the title; only POV-Ray knows how wide a word is, so it keeps the
// position.
std::string legend(const Picture& picture) {
  const double y = kPageHeight / 2 - kHeader + 0.22;
  std::string text = "#declare legend_x = " + number(-kPageWidth / 2 + kMargin) + ";\n";
  const auto add = [&](const std::string& name, const Colour& colour) {
    text += "#declare word = " + text_object(name, 0.36) + "\nobject { " +
            rectangle({0.17, 0.12, 0.34, 0.26}, kTextDepth, colour) + " translate <legend_x, " +
            number(y) + ", 0> }\nobject { word translate <legend_x + 0.47, " + number(y) + ", " +
            number(kTextDepth) +
            "> }\n#declare legend_x = legend_x + 0.47 + max_extent(word).x + 0.6;\n";
  };
  for (const Part& part : picture.parts)
    add(part.name, part.colour);
  const bool has_alarms =
      std::ranges::any_of(picture.parts, [](const Part& part) { return !part.marked.empty(); }) ||
      std::ranges::any_of(picture.panels, [](const Panel& panel) {
        return panel.cut && panel.cut->parts.size() > 1;
      });
  if (has_alarms) add("intersecting triangles, overlap", kAlarm);
  return text;
}

std::vector<Slot> slots(std::size_t count) {
  const double n = static_cast<double>(count);
  const double width = (kPageWidth - (n + 1) * kMargin) / n;
  const double height = kPageHeight - kHeader - kFooter;
  std::vector<Slot> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double left = -kPageWidth / 2 + kMargin + static_cast<double>(i) * (width + kMargin);
    result.push_back({left + width / 2, (kFooter - kHeader) / 2, width, height});
  }
  return result;
}

}  // namespace

void write_scene(const std::filesystem::path& path, const Picture& picture) {
  std::string text = preamble() + declare_alarms();
  for (std::size_t i = 0; i < picture.parts.size(); ++i)
    text += declare_part(picture.parts[i], i);
  text += text_at(picture.title, 0.5, -kPageWidth / 2 + kMargin, kPageHeight / 2 - 0.72);
  text += legend(picture);
  const std::vector<Slot> places = slots(picture.panels.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Slot& slot = places[i];
    text += rectangle(slot, -kTextDepth, kPanelGround);
    text += place_panel(picture.panels[i], picture.parts.size(), slot);
    text += text_at(picture.panels[i].caption, 0.36, slot.centre_x - slot.width / 2,
                    slot.centre_y - slot.height / 2 - 0.42);
  }
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw Error(path.string() + ": cannot write");
}

}  // namespace graze::render
