// Moves bodies.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/world/bodies/world_state.h>

#include <string>

namespace graze {

void World::State::begin_move() {
  boxes_to_move.clear();
  moved_boxes.clear();
  bounding_radii.clear();
}

/// Adds the body's new box to the list of boxes to move, or throws. It asks all questions to a
/// shape that a move needs, before anything has moved.
void World::State::prepare_move(BodyId id, const Pose& pose, const char* what) {
  check_is_free(what);
  const Bodies::Body& mover = body(id, what);
  bvh::check_rigid(pose, what);
  moved_boxes.push_back(bounds_of(*mover.shape, mover.is_users, pose, mover.room(), what));
  bounding_radii.push_back(
      mover.ask([](const BodyShape& shape) { return shape.bounding_radius(); }));
  boxes_to_move.push_back(broad.id(mover.box));
}

void World::State::move_prepared(std::span<const BodyId> ids, std::span<const Pose> poses) {
  make_room_for_changes(ids.size());
  movers.make_room(ids.size(), all.bodies.size());
  broad.move(boxes_to_move, moved_boxes);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Bodies::Body& mover = all.bodies[ids[i].index];
    double& path = all.changes[ids[i].index].path;
    path = longer_path(path, motion_bound(mover.pose, poses[i], bounding_radii[i]));
    if (movers.are_noted()) {
      note_travel(ids[i].index, poses[i], bounding_radii[i]);
      movers.find(ids[i].index)->motion.reset();
    }
    mover.pose = poses[i];
    mover.is_awake = true;
    note_change(ids[i].index);
  }
}

void World::State::note_travel(std::uint32_t index, const Pose& to, double bounding_radius) {
  Mover* mover = movers.find(index);
  if (mover == nullptr) mover = &movers.note(index, all.bodies[index].pose);
  mover->travel = travel_bound(mover->before, to, bounding_radius);
}

// Public functions do their work in in_standard_arithmetic(), which makes the CPU round as all
// error bounds assume while it calls the function that it is given.

void World::move(BodyId id, const Pose& pose) {
  bvh::in_standard_arithmetic([&] {
    state_->begin_move();
    state_->prepare_move(id, pose, "move");
    state_->move_prepared({&id, 1}, {&pose, 1});
    state_->journal.tell_moves({&id, 1}, {&pose, 1});
  });
}

void World::move(std::span<const BodyId> ids, std::span<const Pose> poses) {
  bvh::in_standard_arithmetic([&] {
    State& state = *state_;
    if (ids.size() != poses.size()) {
      throw InputError("move: " + std::to_string(ids.size()) + " ids, but " +
                       std::to_string(poses.size()) + " poses");
    }
    state.begin_move();
    std::size_t i = 0;
    try {
      for (; i < ids.size(); ++i)
        state.prepare_move(ids[i], poses[i], "move");
    } catch (const std::exception&) {
      const std::string what = "move, element " + std::to_string(i);
      bvh::at_element("element", i, [&] {
        state.prepare_move(ids[i], poses[i], what.c_str());  // throws again, with its own name
      });
      throw;
    }
    state.move_prepared(ids, poses);
    state.journal.tell_moves(ids, poses);
  });
}

void World::move(BodyId id, const RigidMotion& motion) {
  bvh::in_standard_arithmetic([&] {
    State& state = *state_;
    const Pose end = motion.at(1);
    state.begin_move();
    state.prepare_move(id, end, "move");
    const Bodies::Body& body = state.all.bodies[id.index];
    const Mover* mover = state.movers.find(id.index);
    const bool is_swept = body.detection == Detection::Continuous;
    if (is_swept && !are_equal(motion.start(), mover == nullptr ? body.pose : mover->before)) {
      throw InputError("move: the motion of the body with index " + std::to_string(id.index) +
                           " does not start where the body was at the last update",
                       {.element = "body", .index = id.index});
    }
    state.move_prepared({&id, 1}, {&end, 1});
    if (is_swept) state.movers.find(id.index)->motion = motion;
    if (!state.journal.is_taken()) return;
    is_swept ? state.journal.journal()->note_motion(id, motion)
             : state.journal.tell_moves({&id, 1}, {&end, 1});
  });
}

}  // namespace graze
