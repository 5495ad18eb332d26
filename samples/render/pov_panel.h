#pragma once

#include <string>

#include "samples/render/picture.h"

namespace graze::render {

/// A rectangle of the page, in page units; the page is seen along -z.
struct Slot {
  double centre_x;
  double centre_y;
  double width;
  double height;
};

/// An object with all declared parts as the panel shows them, in its slot. Throws InputError for a
/// cut that names a part that does not exist.
std::string place_panel(const Panel& panel, std::size_t part_count, const Slot& slot);

}  // namespace graze::render
