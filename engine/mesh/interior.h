#pragma once

namespace graze {

/// The ways in which a query that answers yes or no can take a closed mesh.
enum class Interior {
  /// The mesh is its triangles: a mesh wholly inside another does not touch it.
  Surface,
  /// The mesh is its triangles and all that they enclose by the even-odd rule (containment.h): a
  /// cavity is outside, and so is what two shells both enclose.
  Solid,
};

}  // namespace graze
