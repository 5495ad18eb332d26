#pragma once

#include <graze/engine/world/placed_shape.h>
#include <graze/engine/world/shape.h>

#include "tests/fuzz/byte_shapes.h"

namespace graze::fuzz {

/// A length: mostly an ordinary one, or any number, which a door may refuse.
double length(ByteShapes& bytes);

/// One to four triangles.
Mesh mesh(ByteShapes& bytes);

/// A shape of any kind but height fields. Throws what constructors throw.
Shape shape(ByteShapes& bytes);

/// Prints what is wrong and aborts.
void fail_if(bool is_wrong, const char* what);

/// Whether a shape is within a kilometre: tolerances are shares of lengths, and beside what is
/// larger no distance need be the same by another way.
bool is_ordinary(const PlacedShapeView& shape);

}  // namespace graze::fuzz
