#pragma once

// Makes the tiles of a height field. Private to engine/world.

#include <graze/engine/world/fields/field_data.h>

#include <cstdint>
#include <span>

namespace graze {

/// Make the tiles of a field that has none yet. The values must have been checked.
void make_tiles(HeightFieldData& data, std::span<const float> heights,
                const HeightFieldSettings& settings);
void make_tiles(HeightFieldData& data, std::span<const std::uint16_t> heights,
                const HeightFieldSettings& settings);

/// Replace the tiles that hold one of these heights or a cell beside one by new tiles.
void replace_heights(HeightFieldData& data, const FieldRange& part, std::span<const float> heights);
void replace_heights(HeightFieldData& data, const FieldRange& part,
                     std::span<const std::uint16_t> heights);

}  // namespace graze
