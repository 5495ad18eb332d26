#pragma once

namespace graze::narrowphase {

/// The corners of a triangle in space, each an array of three numbers: doubles, or integers that
/// stand for them (fixed_point.h).
template <typename Number>
struct Corners {
  const Number* point[3];
};

}  // namespace graze::narrowphase
