#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include <graze/engine/mesh/placed_mesh.h>
#include <graze/engine/view/view.h>
#include <graze/engine/world/placed_shape.h>

namespace graze::cli {

/// Holds a page as it grows.
struct ShownPage {
  explicit ShownPage(ViewSettings settings) : view(std::move(settings)) {}

  View view;
  std::size_t frames = 0;
  std::size_t touching = 0;
  bool is_all_read = true;  ///< true if no input was left out
};

/// Holds what a picture says of itself.
struct PictureWords {
  std::string label = {};
  std::string note = {};
  bool is_apart = false;  ///< as in ViewFrame
};

/// Holds bodies of the page, as they are placed.
struct ShownBodies {
  ViewBody a;
  ViewBody b;
};

/// Adds a picture of two meshes, and how they meet: intersecting triangles, curves, contacts; or
/// the nearest points. Throws what these queries throw.
void show_pair(const PlacedMeshView& a, const PlacedMeshView& b, const ShownBodies& bodies,
               const PictureWords& words, ShownPage& page);

/// Adds such a picture of two shapes, without triangles and curves. Where no query knows such a
/// pair the picture says so.
void show_pair(const PlacedShapeView& a, const PlacedShapeView& b, const ShownBodies& bodies,
               const PictureWords& words, ShownPage& page);

}  // namespace graze::cli
