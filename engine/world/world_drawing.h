#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <Eigen/Core>

#include <graze/engine/world/ids.h>
#include <graze/engine/world/placed_shape.h>

namespace graze {

class World;

/// Says what a drawn line shows.
enum class Drawn {
  Shape,    ///< an edge or an outline of a body's shape
  Box,      ///< the axis-aligned box around a body
  Contact,  ///< a contact, from where B begins to where A ends, as long as it is deep
  Island,   ///< an island: the line goes from the middle of its first body's box to that of another
            ///< of its bodies
};

/// A segment in the world's frame, metres.
struct DrawnLine {
  Eigen::Vector3d from;  ///< one end of the segment
  Eigen::Vector3d to;    ///< the other end of the segment
  Drawn what;            ///< what the line shows
  BodyId body;           ///< the body of the shape or box; A of a contact; the first body of an
                         ///< island
};

/// The point of a contact in the world's frame, metres.
struct DrawnPoint {
  Eigen::Vector3d at;  ///< the point halfway between those of A and B
  BodyId body_a;       ///< the body with the lower id
  BodyId body_b;       ///< the body with the higher id
};

/// A word at a place in the world's frame, metres.
struct DrawnLabel {
  Eigen::Vector3d at;  ///< the middle of the body's box
  std::string text;    ///< the text of the label
  BodyId body;         ///< the body that the label names
};

/// Takes drawings to a user's own renderer, log or file. Exceptions of its functions come out of
/// draw(). The functions may not change the world.
class WorldDrawer {
 public:
  virtual ~WorldDrawer() = default;
  /// Draws a segment.
  virtual void line(const DrawnLine& line) = 0;
  /// Draws a point. By default it does nothing.
  virtual void point(const DrawnPoint&) {}
  /// Draws a word. By default it does nothing.
  virtual void label(const DrawnLabel&) {}
};

/// Says what of a world is drawn, and how finely.
struct WorldDrawingSettings {
  bool has_shapes = true;     ///< draws shapes: each edge of a mesh or hull once, and nothing for a
                              ///< user's own shape
  bool has_boxes = false;     ///< draws the axis-aligned box around each body
  bool has_contacts = true;   ///< draws World::contacts(), which throws while changes wait for an
                              ///< update
  bool has_islands = false;   ///< draws islands, which needs WorldSettings::islands
  bool has_labels = false;    ///< draws a label at each body: its index, and whether it sleeps
  std::size_t segments = 24;  ///< how many segments a circle has, 3 to 4096
  double half_space_extent = 10;  ///< half the side of the square that stands for a plane, metres
};

/// Draws a world for people: lines, points and words that a renderer shows, bodies in the order of
/// their ids. Drawings are for looking at, not for deciding: circles are polygons, and points are
/// rounded. Parts of a compound are drawn as shapes of their own. Throws InputError for invalid
/// settings, for islands of a world without islands, and while changes wait for an update if
/// contacts are asked for.
void draw(const World& world, WorldDrawer& drawer, const WorldDrawingSettings& settings = {});

/// Draws one shape as that of `body`.
void draw(const PlacedShapeView& shape, WorldDrawer& drawer,
          const WorldDrawingSettings& settings = {}, BodyId body = {});

}  // namespace graze
