#pragma once

#include <string>

#include "samples/render/picture.h"

namespace graze::render {

/// Declares part number `index` in the scene: solid_, the bare surface, for clipping; plain_ and
/// marked_, the same with colours; cap_, the texture of a cut through it. Lengths are millimetres.
/// Throws InputError for a marked triangle that the mesh does not have.
std::string declare_part(const Part& part, std::size_t index);

/// The name of what declare_part() declares.
std::string solid_name(std::size_t index);
std::string coloured_name(std::size_t index, Marks marks);
std::string cap_name(std::size_t index);

/// Declares the textures `marked` and `alarm` that parts and cuts share.
std::string declare_alarms();

}  // namespace graze::render
