#include <graze/engine/cases/world_case.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/voxel_map.h>

namespace graze {

/// Returns a part of a body, or the body if it has none.
static CaseBody part_of(const World& world, BodyId id, std::uint32_t number) {
  if (const VoxelMap* map = voxel_map_of(world.shape(id)))
    return {map->box(), placed_part(world.pose(id), map->pose(number))};
  const Compound* compound = compound_of(world.shape(id));
  if (compound == nullptr) return case_body(world, id);
  const PlacedShape& part = compound->part(number);
  return {part.shape, placed_part(world.pose(id), part.pose)};
}

CaseBody case_body(const World& world, BodyId id) {
  const Shape* shape = world.shape(id).shape();
  if (compound_of(world.shape(id)) != nullptr || voxel_map_of(world.shape(id)) != nullptr) {
    throw UnsupportedPairError("to_case: a body has parts, and only one of these can be in a case");
  }
  if (shape == nullptr) {
    throw UnsupportedPairError("to_case: a body has a shape of a user's own, which is in no case");
  }
  return {*shape, world.pose(id)};
}

Case to_case(const World& world, const BodyPair& pair, bool touches) {
  return to_case(CaseShape(case_body(world, pair.a)), case_body(world, pair.b), touches);
}

Case to_case(const World& world, const BodyContact& contact) {
  const BodyPair& pair = contact.pair;
  return to_case(part_of(world, pair.a, contact.manifold.part_a()),
                 part_of(world, pair.b, contact.manifold.part_b()), contact.manifold);
}

Case to_case(const World& world, const CaseBody& asked, BodyId body, bool touches) {
  return to_case(CaseShape(asked), case_body(world, body), touches);
}

Case to_case(const World& world, const CaseBody& asked, const BodyDistance& found) {
  return to_case(asked, part_of(world, found.id, found.part), found.distance);
}

Case to_case(const World& world, const Ray& ray, const BodyRayHit& found) {
  return to_case(CaseShape(part_of(world, found.id, found.part)), ray, found.hit);
}

}  // namespace graze
