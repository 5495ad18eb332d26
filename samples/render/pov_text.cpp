#include "samples/render/pov_text.h"

#include <charconv>

namespace graze::render {

std::string number(double value) {
  char buffer[40];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 9).ptr;
  return {buffer, end};
}

std::string vector(const Eigen::Vector3d& v) {
  return '<' + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + '>';
}

std::string srgb(const Colour& colour) {
  return "srgb " + vector({colour.red, colour.green, colour.blue});
}

std::string flat(const Colour& colour) {
  return "texture { pigment { " + srgb(colour) + " } finish { ambient 1 diffuse 0 } }";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

}  // namespace graze::render
