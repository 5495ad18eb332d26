#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <Eigen/Core>

#include <graze/engine/world/ids.h>
#include <graze/engine/world/placed_shape.h>

namespace graze {

class World;

/// What is shown by something that is drawn.
enum class Drawn {
  Shape,    ///< edges and outlines of a body's shape
  Box,      ///< the axis-aligned box around it
  Contact,  ///< a contact, from where B begins to where A ends: as long as it is deep
  Island,   ///< from the middle of the first body's box to those of others in its island
};

/// A segment in the world's frame, metres.
struct DrawnLine {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  Drawn what;
  BodyId body;  ///< of a contact that of A, of an island its first
};

/// The point of a contact in the world's frame, metres.
struct DrawnPoint {
  Eigen::Vector3d at;
  BodyId body_a;
  BodyId body_b;
};

/// A word at a place in the world's frame, metres.
struct DrawnLabel {
  Eigen::Vector3d at;
  std::string text;
  BodyId body;
};

/// Where drawings go: a user's own renderer, log or file. What its functions throw comes out of
/// draw(). They may not change the world.
class WorldDrawer {
 public:
  virtual ~WorldDrawer() = default;
  /// One segment.
  virtual void line(const DrawnLine& line) = 0;
  /// One point; not drawn unless this is overridden.
  virtual void point(const DrawnPoint&) {}
  /// One word; likewise.
  virtual void label(const DrawnLabel&) {}
};

/// What of a world is drawn, and how finely.
struct WorldDrawingSettings {
  bool has_shapes = true;  ///< each edge of a mesh or hull once; of a user's own shape nothing
  bool has_boxes = false;
  bool has_contacts = true;       ///< as World::contacts(): none while changes wait for an update
  bool has_islands = false;       ///< needs WorldSettings::islands
  bool has_labels = false;        ///< of each body: its index, and whether it sleeps
  std::size_t segments = 24;      ///< of a circle, 3 to 4096
  double half_space_extent = 10;  ///< metres: half the side of the square that stands for a plane
};

/// Draws a world for people: lines, points and words that a renderer shows, bodies in the order of
/// their ids. For looking, not for deciding: circles are polygons, and points are rounded. Parts of
/// a compound are drawn as shapes of their own. Throws InputError for settings that are none, for
/// islands of a world without, and while changes wait for an update if contacts are asked for.
void draw(const World& world, WorldDrawer& drawer, const WorldDrawingSettings& settings = {});

/// The same of one shape, as that of `body`.
void draw(const PlacedShapeView& shape, WorldDrawer& drawer,
          const WorldDrawingSettings& settings = {}, BodyId body = {});

}  // namespace graze
