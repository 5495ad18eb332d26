#pragma once

#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/coding/byte_writer.h>
#include <graze/engine/world/world.h>

namespace graze::record {

void write_filter(const Filter& filter, ByteWriter& to);
Filter read_filter(ByteReader& from);

/// Write and read settings: kind, role, detection and sides in a byte, then the rest.
void write_settings(const BodySettings& settings, ByteWriter& to);
BodySettings read_settings(ByteReader& from);

}  // namespace graze::record
