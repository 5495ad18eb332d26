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
  Eigen::Vector3d from;  ///< one end
  Eigen::Vector3d to;    ///< the other
  Drawn what;            ///< what it shows
  BodyId body;           ///< of a contact that of A, of an island its first
};

/// The point of a contact in the world's frame, metres.
struct DrawnPoint {
  Eigen::Vector3d at;  ///< halfway between the points of A and B
  BodyId body_a;       ///< the body of the lower id
  BodyId body_b;       ///< the other
};

/// A word at a place in the world's frame, metres.
struct DrawnLabel {
  Eigen::Vector3d at;  ///< the middle of the body's box
  std::string text;    ///< what is written there
  BodyId body;         ///< the body it names
};

/// Where drawings go: a user's own renderer, log or file. What its functions throw comes out of
/// draw(). They may not change the world.
class WorldDrawer {
 public:
  virtual ~WorldDrawer() = default;
  /// Draws a segment.
  virtual void line(const DrawnLine& line) = 0;
  /// Draws a point; nothing unless this is overridden.
  virtual void point(const DrawnPoint&) {}
  /// Draws a word; nothing unless this is overridden.
  virtual void label(const DrawnLabel&) {}
};

/// What of a world is drawn, and how finely.
struct WorldDrawingSettings {
  bool has_shapes = true;     ///< each edge of a mesh or hull once; of a user's own shape nothing
  bool has_boxes = false;     ///< the axis-aligned box around each body
  bool has_contacts = true;   ///< as World::contacts(): none while changes wait for an update
  bool has_islands = false;   ///< needs WorldSettings::islands
  bool has_labels = false;    ///< of each body: its index, and whether it sleeps
  std::size_t segments = 24;  ///< of a circle, 3 to 4096
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
