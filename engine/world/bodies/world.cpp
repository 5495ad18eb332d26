#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/prepare.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/contacts/margin/nearness.h>
#include <graze/engine/world/contacts/sides/enclosure.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <string>

namespace graze {
namespace {

std::uint64_t pair_key(std::uint32_t s, std::uint32_t t) {
  return static_cast<std::uint64_t>(s) << 32 | t;
}

/// Returns the Shape that a body's shape stands for, or nullptr.
const Shape* known_shape(const BodyShape& shape, bool is_users) {
  return ask_shape(is_users, [&] { return shape.shape(); });
}

/// Returns how many threads to use: no more than oneTBB has now, which would warn of those that it
/// cannot give.
std::size_t threads_of(const WorldSettings& settings) {
  using tbb::global_control;
  return std::min(thread_count(settings.threads),
                  global_control::active_value(global_control::max_allowed_parallelism));
}

}  // namespace

Aabb bounds_of(const BodyShape& shape, bool is_users, const Pose& pose, double room,
               const char* what) {
  Aabb box = ask_shape(is_users, [&] { return shape.bounds(pose); });
  bvh::check_box(box, what);
  return room > 0 ? grown(box, room) : box;
}

World::State::State(const WorldSettings& chosen)
    : settings(chosen),
      threads(threads_of(chosen)),
      workers(static_cast<int>(threads)),
      broad({.threads = chosen.threads}) {
  if (settings.number == 0) return;
  all.number_bits = settings.number << Bodies::kNumberShift;
  all.ids.set_limit(std::uint32_t{1} << Bodies::kNumberShift);
}

const Bodies::Body& World::State::body(BodyId id, const char* what) const {
  if (!all.has(id)) {
    const bool is_of_another = (id.generation ^ all.number_bits) >> Bodies::kNumberShift != 0;
    throw StaleIdError(std::string(what) + ": there is no body with index " +
                           std::to_string(id.index) + " and generation " +
                           std::to_string(id.generation) +
                           (is_of_another ? ": the id is of another world" : ""),
                       {.element = "body", .index = id.index});
  }
  return all.bodies[id.index];
}

void World::State::check_is_free(const char* what) const {
  if (is_updating) throw InputError(std::string(what) + ": the world is within an update");
}

/// Makes room, so that note_change() of so many bodies throws nothing: a marked body that is not in
/// the list would never be looked at again. Each body is in the list once.
void World::State::make_room_for_changes(std::size_t more) {
  make_room_in(changed,
               std::min(more, all.bodies.size() - std::min(all.bodies.size(), changed.size())));
}

void World::State::note_change(std::uint32_t index) {
  if (all.changes[index].has_changed) return;
  changed.push_back(index);
  all.changes[index].has_changed = true;
}

void World::State::note_other_filter(std::uint32_t index) {
  all.changes[index].has_other_filter = true;
  note_change(index);
}

/// Marks and lists all bodies anew: after an update that was cut short the marks may no longer
/// agree with the list.
void World::State::note_everything() {
  changed.reserve(all.bodies.size());
  changed.clear();
  for (std::uint32_t index = 0; index < all.bodies.size(); ++index) {
    Bodies::Changes& record = all.changes[index];
    record.has_changed = record.has_other_filter = all.ids.is_live(index);
    if (record.has_changed) changed.push_back(index);
  }
}

/// Makes room for one more body, except for its box and its mesh. Returns the index that the body
/// will have.
std::uint32_t World::State::make_room_for_one() {
  all.ids.prepare_take();
  const std::uint32_t index = all.ids.next();
  if (index >= all.bodies.size()) {
    make_room_in(all.changes, 1);
    all.bodies.emplace_back(), all.changes.emplace_back();
  }
  make_room_in(changed, 1);
  return index;
}

/// Adds the box of a body to the broad phase. If this throws it has changed nothing.
void World::State::insert_box(std::uint32_t index, const Aabb& box) {
  Bodies::Body& body = all.bodies[index];
  make_room_in(body_of_box, 1);  // indices of boxes come one after the other
  body.box = broad.add(box).index;
  if (body.box >= body_of_box.size()) body_of_box.resize(body.box + std::size_t{1});
  body_of_box[body.box] = index;
}

/// Returns the mesh that the shape stands for, or nullptr. It is called once, before a body takes
/// the shape, since a shape of a user's own may throw.
const Mesh* World::State::prepared_mesh(const BodyShape& shape, bool is_users) const {
  const Shape* known = known_shape(shape, is_users);
  const Mesh* mesh = known == nullptr ? nullptr : known->as<Mesh>();
  if (settings.skip_unused_trees) return mesh;
  if (mesh != nullptr) prepare(*mesh, {.queries = PreparedFor::All});
  if (const Compound* compound = compound_of(shape)) {
    for (const std::uint32_t part : compound->parts()) {
      if (const Mesh* of_part = compound->part(part).shape.as<Mesh>())
        prepare(*of_part, {.queries = PreparedFor::All});
    }
  }
  return mesh;
}

/// Gives a body a shape. If this throws it has changed nothing.
void World::State::take_shape(std::uint32_t index, std::shared_ptr<const BodyShape> shape,
                              const Mesh* mesh) {
  const bool is_users = is_users_shape(*shape);
  const bool is_for_caller =
      is_users && !ask_shape(is_users, [&] { return shape->allows_concurrent_calls(); });
  const bool is_unbuilt = unbuilt.add(mesh);
  drop_shape(index);
  all.bodies[index].is_users = is_users;
  all.bodies[index].has_parts = as_parts(*shape) != nullptr;
  all.bodies[index].shape = std::move(shape);
  all.bodies[index].mesh = mesh;
  all.changes[index].has_unbuilt_tree = is_unbuilt;
  all.changes[index].is_mesh = mesh != nullptr;
  all.changes[index].is_for_caller = is_for_caller;
}

void World::State::drop_shape(std::uint32_t index) {
  if (all.changes[index].has_unbuilt_tree) unbuilt.remove(*all.bodies[index].mesh);
  all.changes[index].has_unbuilt_tree = false;
  all.bodies[index].mesh = nullptr;
  all.bodies[index].shape.reset();
}

World::World(const WorldSettings& settings) {
  check_threads(settings.threads);
  if (settings.number > kLargestWorldNumber) {
    throw InputError("number: a world has a number of at most " +
                     std::to_string(kLargestWorldNumber) + ", not " +
                     std::to_string(settings.number));
  }
  check_settings(settings.sweeps);
  check_margin(settings.sliding_depth, "sliding depth");
  state_ = std::make_unique<State>(settings);
}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

BodyId World::add(const PlacedBodyShape& placed, const BodySettings& settings) {
  return bvh::in_standard_arithmetic([&]() -> BodyId {
    State& state = *state_;
    state.check_is_free("add");
    const auto& [shape, pose] = placed;
    if (shape == nullptr) throw InputError("add: no shape");
    bvh::check_rigid(pose, "add");
    const bool is_users = is_users_shape(*shape);
    check_margin(settings.margin, "add");
    check_sides(known_shape(*shape, is_users), settings.sides, "add");
    const Aabb box =
        bounds_of(*shape, is_users, pose, settings.margin + settings.sides.thickness(), "add");
    const Mesh* mesh = state.prepared_mesh(*shape, is_users);
    const std::uint32_t index = state.make_room_for_one();
    Bodies::Body& body = state.all.bodies[index];
    body = {};
    state.all.changes[index] = {};
    state.take_shape(index, shape, mesh);
    try {
      state.insert_box(index, box);
    } catch (...) {
      state.drop_shape(index);
      throw;
    }
    state.all.ids.take();
    body.pose = pose;
    body.kind = settings.kind;
    body.role = settings.role;
    body.filter = settings.filter;
    body.user_data = settings.user_data;
    body.margin = settings.margin;
    body.sides = settings.sides;
    body.detection = settings.detection;
    if (body.detection == Detection::Continuous) state.movers.add_swept();
    state.note_change(index);
    state.journal.tell(BodyChange::Added, state.all, index);
    return state.all.id(index);
  });
}

BodyId World::add(const PlacedShapeView& shape, const BodySettings& settings) {
  return add(PlacedBodyShape{share(shape.shape), shape.pose}, settings);
}

void World::remove(BodyId id) {
  State& state = *state_;
  Bodies::Body& body = state.body(id, "remove");
  state.all.ids.prepare_free();
  if (state.islands.has(id.index)) state.left_islands.push_back(id.index);
  state.broad.remove(state.broad.id(body.box));
  auto& excluded = state.all.excluded;
  for (auto next = excluded.lower_bound(pair_key(id.index, 0)); body.exclusions != 0;) {
    const auto other = static_cast<std::uint32_t>(*next);
    next = excluded.erase(next);
    excluded.erase(pair_key(other, id.index));
    --body.exclusions, --state.all.bodies[other].exclusions;
  }
  state.drop_shape(id.index);
  state.movers.forget(id.index);
  if (body.detection == Detection::Continuous) state.movers.remove_swept();
  state.all.ids.free(id.index);
  ++state.removed;
  state.journal.tell(BodyChange::Removed, state.all, id.index);
}

void World::set_shape(BodyId id, std::shared_ptr<const BodyShape> shape) {
  bvh::in_standard_arithmetic([&] {
    State& state = *state_;
    Bodies::Body& body = state.body(id, "set_shape");
    if (shape == nullptr) throw InputError("set_shape: no shape");
    const bool is_users = is_users_shape(*shape);
    check_sides(known_shape(*shape, is_users), body.sides, "set_shape");
    const Aabb box = bounds_of(*shape, is_users, body.pose, body.room(), "set_shape");
    const double radius = is_users
                              ? bvh::in_users_arithmetic([&] { return shape->bounding_radius(); })
                              : shape->bounding_radius();
    const Mesh* mesh = state.prepared_mesh(*shape, is_users);
    state.make_room_for_changes(1);
    state.take_shape(id.index, std::move(shape), mesh);
    state.broad.move(state.broad.id(body.box), box);
    if (state.movers.find(id.index) != nullptr) state.note_travel(id.index, body.pose, radius);
    body.is_awake = true;
    state.all.changes[id.index].has_other_shape = true;
    state.note_change(id.index);
    state.journal.tell(BodyChange::Shape, state.all, id.index);
  });
}

void World::set_shape(BodyId id, const Shape& shape) {
  bvh::in_standard_arithmetic([&] { set_shape(id, share(shape)); });
}

void World::set_filter(BodyId id, const Filter& filter) {
  Bodies::Body& body = state_->body(id, "set_filter");
  state_->make_room_for_changes(1);
  body.filter = filter;
  state_->note_other_filter(id.index);
  state_->journal.tell(BodyChange::Filter, state_->all, id.index);
}

void World::set_kind(BodyId id, BodyKind kind) {
  Bodies::Body& body = state_->body(id, "set_kind");
  state_->make_room_for_changes(1);
  body.kind = kind;
  state_->note_other_filter(id.index);
  state_->journal.tell(BodyChange::Kind, state_->all, id.index);
}

void World::set_role(BodyId id, Role role) {
  Bodies::Body& body = state_->body(id, "set_role");
  state_->make_room_for_changes(1);
  body.role = role;
  state_->note_other_filter(id.index);
  state_->journal.tell(BodyChange::Role, state_->all, id.index);
}

void World::set_detection(BodyId id, Detection detection) {
  State& state = *state_;
  Bodies::Body& body = state.body(id, "set_detection");
  if (detection == Detection::Continuous) {
    state.movers.forget(id.index);
    if (body.detection != detection) state.movers.add_swept();
  } else if (body.detection != detection) {
    state.movers.remove_swept();
  }
  body.detection = detection;
  state.journal.tell(BodyChange::Detection, state.all, id.index);
}

void World::set_margin(BodyId id, double margin) {
  bvh::in_standard_arithmetic([&] {
    State& state = *state_;
    Bodies::Body& body = state.body(id, "set_margin");
    check_margin(margin, "set_margin");
    const Aabb box = bounds_of(*body.shape, body.is_users, body.pose,
                               margin + body.sides.thickness(), "set_margin");
    state.make_room_for_changes(1);
    state.broad.move(state.broad.id(body.box), box);
    body.margin = margin;
    state.all.changes[id.index].has_other_shape = true;
    state.note_change(id.index);
    state.journal.tell(BodyChange::Margin, state.all, id.index);
  });
}

void World::set_user_data(BodyId id, std::uint64_t data) {
  state_->body(id, "set_user_data").user_data = data;
  state_->journal.tell(BodyChange::UserData, state_->all, id.index);
}

void World::exclude(BodyId a, BodyId b) {
  Bodies::Body& body_a = state_->body(a, "exclude");
  Bodies::Body& body_b = state_->body(b, "exclude");
  if (a == b) throw InputError("exclude: a body and itself", {.element = "body", .index = a.index});
  auto& excluded = state_->all.excluded;
  if (excluded.contains(pair_key(a.index, b.index))) return;
  state_->make_room_for_changes(1);
  const auto first = excluded.insert(pair_key(a.index, b.index)).first;
  try {
    excluded.insert(pair_key(b.index, a.index));
  } catch (...) {
    excluded.erase(first);
    throw;
  }
  ++body_a.exclusions, ++body_b.exclusions;
  state_->note_other_filter(a.index);
  state_->journal.tell(PairChange::Excluded, a.index, b.index);
}

void World::include(BodyId a, BodyId b) {
  Bodies::Body& body_a = state_->body(a, "include");
  Bodies::Body& body_b = state_->body(b, "include");
  state_->make_room_for_changes(1);
  if (state_->all.excluded.erase(pair_key(a.index, b.index)) == 0) return;
  state_->all.excluded.erase(pair_key(b.index, a.index));
  --body_a.exclusions, --body_b.exclusions;
  state_->note_other_filter(a.index);
  state_->journal.tell(PairChange::Included, a.index, b.index);
}

void World::set_pair_filter(std::function<bool(BodyId, BodyId)> filter) {
  state_->check_is_free("set_pair_filter");
  state_->note_everything();
  state_->all.pair_filter = std::move(filter);
  if (state_->journal.is_taken())
    state_->journal.journal()->note_pair_filter(state_->all.pair_filter != nullptr);
}

}  // namespace graze
