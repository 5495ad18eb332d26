#pragma once

#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/mesh_builder.h>
#include <span>
#include <string_view>

namespace graze::mesh_io {

/// A kind of file: its names end with `extension`, in upper or lower case.
struct Format {
  std::string_view extension;
  MeshArrays (*read)(const Source& source);
};

std::span<const Format> all_formats();

/// Null if there is none for this extension, which includes the dot.
const Format* find_format(std::string_view extension);

}  // namespace graze::mesh_io
