#pragma once

// Words of POV-Ray's scene language.

#include <Eigen/Core>
#include <string>

#include "samples/render/picture.h"

namespace graze::render {

/// In a metre: scenes are drawn in these.
inline constexpr double kMillimetres = 1e3;

/// A number with nine digits, independent of the locale.
std::string number(double value);

/// <x, y, z>
std::string vector(const Eigen::Vector3d& v);

/// A colour as screens mean it.
std::string srgb(const Colour& colour);

/// A texture of this colour, whatever light falls on it.
std::string flat(const Colour& colour);

/// A string in double quotes, with what is special in it escaped.
std::string quoted(const std::string& text);

}  // namespace graze::render
