#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/drawing/outlines.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/voxel_map.h>
#include <graze/engine/world/world.h>
#include <graze/engine/world/world_drawing.h>

#include <cmath>
#include <string>
#include <vector>

namespace graze {
namespace {

constexpr std::size_t kLeastSegments = 3;
constexpr std::size_t kMostSegments = 4096;

void check(const WorldDrawingSettings& settings) {
  if (settings.segments < kLeastSegments || settings.segments > kMostSegments) {
    throw InputError("draw: " + std::to_string(settings.segments) +
                     " segments of a circle, not 3 to 4096");
  }
  const double extent = settings.half_space_extent;
  if (!(extent > 0 && extent <= kLargestLength))
    throw InputError("draw: half_space_extent is " + bvh::number_text(extent) + " m");
}

Eigen::Vector3d middle_of(const Aabb& box) {
  return box.min / 2 + box.max / 2;
}

/// Hands drawings to the user's drawer, which is called in the user's arithmetic.
class Drawing {
 public:
  Drawing(WorldDrawer& drawer, const WorldDrawingSettings& settings)
      : drawer_(drawer), settings_(settings) {}

  void draw_shape(const PlacedShapeView& shape, BodyId body) {
    outline(shape, settings_, taker(Drawn::Shape, body));
  }

  void draw_box(const Aabb& box, BodyId body) { outline(box, taker(Drawn::Box, body)); }

  void draw_body(const World& world, BodyId id) {
    const BodyShape& shape = world.shape(id);
    const Pose& pose = world.pose(id);
    if (settings_.has_shapes) {
      if (const Shape* own = shape.shape()) draw_shape({*own, pose}, id);
      if (const Compound* compound = compound_of(shape)) draw_parts(*compound, pose, id);
      if (const VoxelMap* map = voxel_map_of(shape)) draw_voxels(*map, pose, id);
    }
    if (settings_.has_boxes) draw_box(shape.bounds(pose), id);
    if (settings_.has_labels) {
      const std::string text = std::to_string(id.index) + (world.is_awake(id) ? "" : " asleep");
      call([&] { drawer_.label({middle_of(shape.bounds(pose)), text, id}); });
    }
  }

  void draw_contacts(const World& world) {
    for (const BodyContact& each : world.contacts()) {
      for (const ShapeContact& contact : each.manifold) {
        call([&] { drawer_.point({contact.point, each.pair.a, each.pair.b}); });
        line(contact.point_b, contact.point_a, Drawn::Contact, each.pair.a);
      }
    }
  }

  void draw_islands(const World& world) {
    const auto middle = [&](BodyId id) {
      return middle_of(world.shape(id).bounds(world.pose(id)));
    };
    for (const std::vector<BodyId>& island : world.islands()) {
      for (std::size_t i = 1; i < island.size(); ++i)
        line(middle(island[0]), middle(island[i]), Drawn::Island, island[0]);
    }
  }

 private:
  void draw_parts(const Compound& compound, const Pose& pose, BodyId id) {
    for (const std::uint32_t part : compound.parts()) {
      const PlacedShape& placed = compound.part(part);
      draw_shape({placed.shape, placed_part(pose, placed.pose)}, id);
    }
  }

  void draw_voxels(const VoxelMap& map, const Pose& pose, BodyId id) {
    for (const Voxel& voxel : map.voxels())
      draw_shape({map.box(), placed_part(pose, map.pose(map.part(voxel)))}, id);
  }

  TakeLine taker(Drawn what, BodyId body) {
    return [this, what, body](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
      line(from, to, what, body);
    };
  }

  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Drawn what, BodyId body) {
    call([&] { drawer_.line({from, to, what, body}); });
  }

  template <typename Function>
  static void call(const Function& function) {
    bvh::in_users_arithmetic(function);
  }

  WorldDrawer& drawer_;
  const WorldDrawingSettings& settings_;
};

}  // namespace

void draw(const World& world, WorldDrawer& drawer, const WorldDrawingSettings& settings) {
  bvh::in_standard_arithmetic([&] {
    check(settings);
    Drawing drawing(drawer, settings);
    for (const BodyId id : world.bodies())
      drawing.draw_body(world, id);
    if (settings.has_contacts) drawing.draw_contacts(world);
    if (settings.has_islands) drawing.draw_islands(world);
  });
}

void draw(const PlacedShapeView& shape, WorldDrawer& drawer, const WorldDrawingSettings& settings,
          BodyId body) {
  bvh::in_standard_arithmetic([&] {
    check(settings);
    const Aabb box = bounding_aabb(shape);  // throws for poses that are not rigid
    Drawing drawing(drawer, settings);
    if (settings.has_shapes) drawing.draw_shape(shape, body);
    if (settings.has_boxes) drawing.draw_box(box, body);
  });
}

}  // namespace graze
