#pragma once

// The tiles of a height field. Private to engine/world.

#include <graze/engine/world/fields/field_data.h>

#include <cstdint>
#include <span>

namespace graze {

/// Of a field that has no tiles yet, and of values that were checked.
void make_tiles(HeightFieldData& data, std::span<const float> heights,
                const HeightFieldSettings& settings);
void make_tiles(HeightFieldData& data, std::span<const std::uint16_t> heights,
                const HeightFieldSettings& settings);

/// New tiles in the place of those that hold one of these heights or a cell beside one.
void replace_heights(HeightFieldData& data, const FieldRange& part, std::span<const float> heights);
void replace_heights(HeightFieldData& data, const FieldRange& part,
                     std::span<const std::uint16_t> heights);

}  // namespace graze
