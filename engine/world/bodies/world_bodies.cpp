// Returns what a world knows of each body.

#include <graze/engine/world/bodies/world_state.h>

namespace graze {

bool World::contains(BodyId id) const {
  return state_->all.has(id);
}

std::size_t World::size() const {
  return state_->all.ids.live_count();
}

const Pose& World::pose(BodyId id) const {
  return state_->body(id, "pose").pose;
}

const BodyShape& World::shape(BodyId id) const {
  return *state_->body(id, "shape").shape;
}

BodyKind World::kind(BodyId id) const {
  return state_->body(id, "kind").kind;
}

Role World::role(BodyId id) const {
  return state_->body(id, "role").role;
}

double World::margin(BodyId id) const {
  return state_->body(id, "margin").margin;
}

Detection World::detection(BodyId id) const {
  return state_->body(id, "detection").detection;
}

const MeshSides& World::sides(BodyId id) const {
  return state_->body(id, "sides").sides;
}

const Filter& World::filter(BodyId id) const {
  return state_->body(id, "filter").filter;
}

std::uint64_t World::user_data(BodyId id) const {
  return state_->body(id, "user_data").user_data;
}

bool World::is_awake(BodyId id) const {
  const Bodies::Body& body = state_->body(id, "is_awake");
  return body.is_awake && !body.is_static();
}

}  // namespace graze
