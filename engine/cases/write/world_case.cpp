#include <graze/engine/cases/world_case.h>

namespace graze {

CaseBody case_body(const World& world, BodyId id) {
  const Shape* shape = world.shape(id).shape();
  if (shape == nullptr) {
    throw UnsupportedPairError("to_case: a body has a shape of a user's own, which is in no case");
  }
  return {*shape, world.pose(id)};
}

Case to_case(const World& world, const BodyPair& pair, bool touches) {
  return to_case(CaseShape(case_body(world, pair.a)), case_body(world, pair.b), touches);
}

Case to_case(const World& world, const BodyContact& contact) {
  return to_case(case_body(world, contact.pair.a), case_body(world, contact.pair.b),
                 contact.manifold);
}

Case to_case(const World& world, const CaseBody& asked, BodyId body, bool touches) {
  return to_case(CaseShape(asked), case_body(world, body), touches);
}

Case to_case(const World& world, const CaseBody& asked, const BodyDistance& found) {
  return to_case(asked, case_body(world, found.id), found.distance);
}

Case to_case(const World& world, const Ray& ray, const BodyRayHit& found) {
  return to_case(CaseShape(case_body(world, found.id)), ray, found.hit);
}

}  // namespace graze
