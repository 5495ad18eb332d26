#pragma once

#include <cstddef>

namespace graze::mesh_io {

/// The bytes that this program has asked operator new for so far, whether or not it has touched or
/// returned them.
std::size_t allocated_bytes();

}  // namespace graze::mesh_io
