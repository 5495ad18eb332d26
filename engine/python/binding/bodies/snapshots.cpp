// Pickles snapshots of worlds: all that they hold, shapes once each.

#include <graze/engine/python/binding/bodies/compounds.h>
#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>

#include <graze/bvh/error.h>
#include <graze/engine/world/bodies/world_state.h>

#include <array>
#include <map>
#include <memory>
#include <string>

namespace graze::python {
namespace {

using State = WorldSnapshotAccess::State;

template <typename Number, typename Numbers>
py::object array_of_numbers(const Numbers& numbers) {
  return array_over<Number>(std::vector<Number>(numbers.begin(), numbers.end()));
}

template <typename Number>
std::vector<Number> numbers_from(py::handle argument) {
  const auto array =
      py::array_t<Number, py::array::c_style | py::array::forcecast>::ensure(argument);
  if (!array) throw py::error_already_set();
  return {array.data(), array.data() + array.size()};
}

void refuse_unless(bool holds) {
  if (!holds) throw InputError("pickle: is no snapshot of a world");
}

py::tuple tuple_of_ids(const IdTable<std::uint32_t>& ids) {
  py::tuple made;
  IdTableAccess::visit(ids, [&](const auto& generations, const auto& free, const auto& resting,
                                const auto& older, std::size_t live, std::uint32_t limit) {
    made = py::make_tuple(array_of_numbers<std::uint32_t>(generations),
                          array_of_numbers<std::uint32_t>(free),
                          array_of_numbers<std::uint32_t>(resting),
                          array_of_numbers<std::uint32_t>(older), live, limit);
  });
  return made;
}

void fill_ids(IdTable<std::uint32_t>& ids, const py::tuple& from) {
  refuse_unless(from.size() == 6);
  IdTableAccess::visit(ids, [&](auto& generations, auto& free, auto& resting, auto& older,
                                std::size_t& live, std::uint32_t& limit) {
    generations = numbers_from<std::uint32_t>(from[0]);
    free = numbers_from<std::uint32_t>(from[1]);
    resting = numbers_from<std::uint32_t>(from[2]);
    older = numbers_from<std::uint32_t>(from[3]);
    live = from[4].cast<std::size_t>();
    limit = from[5].cast<std::uint32_t>();
    std::size_t counted = 0;
    for (const std::uint32_t generation : generations)
      counted += generation & 1;
    refuse_unless(counted == live);
    for (const auto* list : {&free, &resting, &older}) {
      for (const std::uint32_t index : *list)
        refuse_unless(index < generations.size() && (generations[index] & 1) == 0);
    }
  });
}

/// Returns the flags of a body that is there as small numbers: kind, role, detection, sides,
/// whether it is awake, and from its record whether it, its filter and its shape have changed.
py::tuple tuple_of_body(const Bodies::Body& body, const Bodies::Changes& record,
                        std::size_t shape) {
  return py::make_tuple(
      shape, array_of(body.pose), tuple_of(body.filter), body.user_data, body.margin,
      body.sides.thickness(), body.exclusions, record.path,
      py::make_tuple(static_cast<int>(body.kind), static_cast<int>(body.role),
                     static_cast<int>(body.detection), static_cast<int>(body.sides.kind()),
                     body.is_awake, record.has_changed, record.has_other_filter,
                     record.has_other_shape));
}

void fill_body(Bodies::Body& body, Bodies::Changes& record, const py::tuple& from,
               const std::vector<std::shared_ptr<const BodyShape>>& shapes) {
  refuse_unless(from.size() == 9);
  const auto shape = from[0].cast<std::size_t>();
  std::vector<int> flags;
  for (const py::handle flag : from[8])
    flags.push_back(flag.cast<int>());
  refuse_unless(shape < shapes.size() && flags.size() == 8 && flags[0] >= 0 && flags[0] <= 2 &&
                flags[1] >= 0 && flags[1] <= 1 && flags[2] >= 0 && flags[2] <= 1 && flags[3] >= 0 &&
                flags[3] <= 2);
  body.shape = shapes[shape];
  const Shape* known = body.shape->shape();
  body.mesh = known == nullptr ? nullptr : known->as<Mesh>();
  body.has_parts = known == nullptr;
  body.pose = pose_from(from[1], "pickle");
  body.filter = filter_from(from[2]);
  body.user_data = from[3].cast<std::uint64_t>();
  body.margin = from[4].cast<double>();
  const std::array all_sides{MeshSides::surface(), MeshSides::solid(),
                             MeshSides::one_sided(from[5].cast<double>())};
  body.sides = all_sides[static_cast<std::size_t>(flags[3])];
  body.exclusions = from[6].cast<std::uint32_t>();
  body.kind = static_cast<BodyKind>(flags[0]);
  body.role = static_cast<Role>(flags[1]);
  body.detection = static_cast<Detection>(flags[2]);
  body.is_awake = flags[4] != 0;
  record.path = from[7].cast<double>();
  record.has_changed = flags[5] != 0;
  record.has_other_filter = flags[6] != 0;
  record.has_other_shape = flags[7] != 0;
  record.is_mesh = body.mesh != nullptr;
}

py::object filter_of(const Bodies& all) {
  if (!all.pair_filter) return py::none();
  const auto* filter = all.pair_filter.target<PythonFilter>();
  return filter == nullptr ? py::none() : filter->function();
}

py::tuple tuple_of_snapshot(const WorldSnapshot& snapshot) {
  const State& state = WorldSnapshotAccess::state(snapshot);
  py::list shapes, bodies;
  std::map<const BodyShape*, std::size_t> known;
  for (std::size_t index = 0; index < state.all.bodies.size(); ++index) {
    const Bodies::Body& body = state.all.bodies[index];
    if (!state.all.ids.is_live(static_cast<std::uint32_t>(index))) {
      bodies.append(py::none());
      continue;
    }
    const auto [at, is_new] = known.try_emplace(body.shape.get(), known.size());
    if (is_new) shapes.append(object_of(*body.shape));
    bodies.append(tuple_of_body(body, state.all.changes[index], at->second));
  }
  std::vector<BoxPair> candidates = state.candidates;
  return py::make_tuple(shapes, bodies, tuple_of_ids(state.all.ids),
                        array_of_numbers<std::uint64_t>(state.all.excluded), filter_of(state.all),
                        state.all.number_bits, array_over<std::uint32_t>(std::move(candidates), 2),
                        array_of_numbers<std::uint8_t>(state.states));
}

WorldSnapshot snapshot_of_parts(const py::tuple& from) {
  refuse_unless(from.size() == 8);
  auto state = std::make_shared<State>();
  std::vector<std::shared_ptr<const BodyShape>> shapes;
  for (const py::handle shape : from[0])
    shapes.push_back(body_shape_from(shape));
  Bodies& all = state->all;
  fill_ids(all.ids, from[2]);
  for (const py::handle body : from[1]) {
    const auto index = static_cast<std::uint32_t>(all.bodies.size());
    all.bodies.emplace_back(), all.changes.emplace_back();
    refuse_unless(body.is_none() != all.ids.is_live(index));
    if (!body.is_none())
      fill_body(all.bodies.back(), all.changes.back(), body.cast<py::tuple>(), shapes);
  }
  std::size_t generations = 0;
  IdTableAccess::visit(all.ids,
                       [&](const auto& of_ids, const auto&...) { generations = of_ids.size(); });
  refuse_unless(all.bodies.size() >= generations);
  for (const std::uint64_t pair : numbers_from<std::uint64_t>(from[3]))
    all.excluded.insert(pair);
  if (!from[4].is_none()) all.pair_filter = PythonFilter(from[4]);
  all.number_bits = from[5].cast<std::uint32_t>();
  const auto candidates = numbers_from<std::uint32_t>(from[6]);
  state->states = numbers_from<std::uint8_t>(from[7]);
  refuse_unless(candidates.size() == 2 * state->states.size());
  for (std::size_t i = 0; i < candidates.size(); i += 2) {
    refuse_unless(all.ids.is_live(candidates[i]) && all.ids.is_live(candidates[i + 1]));
    state->candidates.push_back({candidates[i], candidates[i + 1]});
  }
  return WorldSnapshotAccess::make(std::move(state));
}

WorldSnapshot snapshot_from(const py::tuple& from) {
  try {
    return snapshot_of_parts(from);
  } catch (const py::cast_error&) {
    refuse_unless(false);
    throw;
  }
}

}  // namespace

void add_snapshots(py::module_& module) {
  py::class_<WorldSnapshot>(module, "WorldSnapshot",
                            "A copy of a world's state, for World.restore(), of this world or of "
                            "another one. Can be pickled, if a filter that was set can be.")
      .def(py::pickle([](const WorldSnapshot& snapshot) { return tuple_of_snapshot(snapshot); },
                      &snapshot_from));
  py::class_<SharedWorld> type(module.attr("World"));
  type.def(
      "snapshot",
      [](SharedWorld& shared) { return shared.ask([](World& world) { return world.snapshot(); }); },
      "snapshot(self)\n--\n\nA copy of all there is, for restore(). Raises InputError while "
      "changes wait for an update.");
  type.def(
      "restore",
      [](SharedWorld& shared, const WorldSnapshot& snapshot) {
        shared.ask([&](World& world) {
          world.restore(snapshot);
          if (shared.tracker) shared.tracker->clear();
        });
      },
      "restore(self, snapshot)\n--\n\nThe world as it was, bit for bit. Tracked contacts begin "
      "anew, with numbers that none had.",
      py::arg("snapshot"));
}

}  // namespace graze::python
