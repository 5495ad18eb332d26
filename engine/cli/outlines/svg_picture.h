#pragma once

#include <string>

#include <graze/engine/cases/case.h>

namespace graze::cli {

/// Returns the two shapes of a case as an SVG picture from two sides, each with a scale bar; empty
/// if it cannot be drawn.
std::string svg_picture(const Case& query);

}  // namespace graze::cli
