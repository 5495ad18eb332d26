#pragma once

namespace graze {

/// What a closed mesh is to a query that answers yes or no.
enum class Interior {
  /// Its triangles: a mesh wholly inside another does not touch it.
  Surface,
  /// Its triangles and all that they enclose by the even-odd rule (containment.h): a cavity is
  /// outside, and so is what two shells both enclose.
  Solid,
};

}  // namespace graze
