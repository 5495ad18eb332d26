// Puts bodies to sleep and wakes them, one by one or many at once.

#include <graze/bvh/value/element_error.h>
#include <graze/engine/world/bodies/world_state.h>

#include <string>

namespace graze {

/// Throws for the first id that is not of a body, and names its element.
void World::State::check_bodies(std::span<const BodyId> ids, const char* what) const {
  check_is_free(what);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (all.has(ids[i])) continue;
    bvh::at_element("element", i, [&] {
      body(ids[i], (std::string(what) + ", element " + std::to_string(i)).c_str());
    });
  }
}

void World::sleep(BodyId id) {
  state_->body(id, "sleep").is_awake = false;
  state_->journal.tell(BodyChange::Sleep, state_->all, id.index);
}

void World::wake(BodyId id) {
  Bodies::Body& body = state_->body(id, "wake");
  if (body.is_awake) return;
  state_->note_change(id.index);
  body.is_awake = true;
  state_->journal.tell(BodyChange::Wake, state_->all, id.index);
}

void World::sleep(std::span<const BodyId> ids) {
  state_->check_bodies(ids, "sleep");
  for (const BodyId id : ids) {
    state_->all.bodies[id.index].is_awake = false;
    state_->journal.tell(BodyChange::Sleep, state_->all, id.index);
  }
}

void World::wake(std::span<const BodyId> ids) {
  state_->check_bodies(ids, "wake");
  state_->make_room_for_changes(ids.size());
  for (const BodyId id : ids) {
    Bodies::Body& body = state_->all.bodies[id.index];
    if (!body.is_awake) state_->note_change(id.index);
    body.is_awake = true;
    state_->journal.tell(BodyChange::Wake, state_->all, id.index);
  }
}

}  // namespace graze
