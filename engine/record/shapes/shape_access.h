#pragma once

#include <graze/engine/world/shape.h>

#include <cmath>

namespace graze {

/// Shapes of numbers that a shape has had before. Private to engine/record.
struct ShapeAccess {
  /// A half-space or a plane with the normal and the offset to the bit, which the constructor would
  /// scale once more. Throws as it does, and InputError for a normal that it has not scaled.
  template <typename Flat>
  static Shape as_it_was(const Flat& flat) {
    Shape shape(flat);
    const double* scaled = std::get<Flat>(shape.value_).normal.data();
    // Of a sum of three squares, a root and two quotients, each rounded once: 8 u are enough.
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(scaled[i] - flat.normal.data()[i]) <= 0x1p-50))
        throw InputError("half-space: the normal is not of length 1");
    shape.value_ = flat;
    return shape;
  }
};

}  // namespace graze
