// Binds what a world knows of its bodies and their pairs.

#include <graze/engine/python/binding/bodies/shared_world.h>
#include <graze/engine/python/binding/module.h>

#include <string>

namespace graze::python {
namespace {

using WorldType = py::class_<SharedWorld>;

const char* word_of_kind(BodyKind kind) {
  return kind == BodyKind::Static      ? "static"
         : kind == BodyKind::Kinematic ? "kinematic"
                                       : "dynamic";
}

py::object sides_of(const MeshSides& sides) {
  if (sides.kind() == Sides::OneSided) return py::make_tuple("one_sided", sides.thickness());
  return py::str(sides.kind() == Sides::Solid ? "solid" : "surface");
}

BodyId single_id(py::handle argument) {
  const Ids<BodyId> ids(argument);
  if (ids.is_many) throw InputError("id: is one body");
  return ids.all[0];
}

/// Adds a member of a body by its name: `object(get(world, id))`.
template <typename Get, typename Object>
void add_member(WorldType& type, const char* name, const char* text, const Get& get,
                const Object& object) {
  type.def(
      name,
      [get, object](SharedWorld& shared, py::handle id) -> py::object {
        const BodyId body = single_id(id);
        return object(shared.ask([&](World& world) { return get(world, body); }));
      },
      text, py::arg("id"));
}

void add_members(WorldType& type) {
  add_member(
      type, "kind", "kind(self, id)\n--\n\n\"static\", \"kinematic\" or \"dynamic\".",
      [](World& world, BodyId id) { return world.kind(id); },
      [](BodyKind kind) { return py::str(word_of_kind(kind)); });
  add_member(
      type, "role", "role(self, id)\n--\n\n\"solid\" or \"sensor\".",
      [](World& world, BodyId id) { return world.role(id); },
      [](Role role) { return py::str(role == Role::Solid ? "solid" : "sensor"); });
  add_member(
      type, "margin", "margin(self, id)\n--\n\nMetres.",
      [](World& world, BodyId id) { return world.margin(id); },
      [](double margin) { return py::float_(margin); });
  add_member(
      type, "detection", "detection(self, id)\n--\n\n\"discrete\" or \"continuous\".",
      [](World& world, BodyId id) { return world.detection(id); },
      [](Detection detection) {
        return py::str(detection == Detection::Discrete ? "discrete" : "continuous");
      });
  add_member(
      type, "filter", "filter(self, id)\n--\n\n(category, mask, group).",
      [](World& world, BodyId id) { return world.filter(id); },
      [](const Filter& filter) { return tuple_of(filter); });
  add_member(
      type, "sides",
      "sides(self, id)\n--\n\nWhat of a mesh counts: \"surface\", \"solid\" or (\"one_sided\", "
      "thickness).",
      [](World& world, BodyId id) { return world.sides(id); },
      [](const MeshSides& sides) { return sides_of(sides); });
  add_member(
      type, "user_data", "user_data(self, id)\n--\n\nThe number that the world keeps.",
      [](World& world, BodyId id) { return world.user_data(id); },
      [](std::uint64_t data) { return py::int_(data); });
  add_member(
      type, "is_awake",
      "is_awake(self, id)\n--\n\nWhether a body is awake. Static bodies are not, unless they are "
      "sensors.",
      [](World& world, BodyId id) { return world.is_awake(id); },
      [](bool is_awake) { return py::bool_(is_awake); });
  add_member(
      type, "touching",
      "touching(self, id)\n--\n\nThe bodies that one touched at the last update, ascending.",
      [](World& world, BodyId id) { return world.touching(id); },
      [](const std::vector<BodyId>& ids) { return array_of_ids(ids); });
  add_member(
      type, "island",
      "island(self, id)\n--\n\nThe island that a body is in, itself included, ascending; none for "
      "one that is in no island. Raises InputError unless the world keeps islands.",
      [](World& world, BodyId id) { return world.island(id); },
      [](const std::vector<BodyId>& ids) { return array_of_ids(ids); });
}

/// Adds a list of all bodies, or of one.
template <typename Of, typename All, typename Object>
void add_list(WorldType& type, const char* name, const char* text, const All& all, const Of& of,
              const Object& object) {
  type.def(
      name,
      [all, of, object](SharedWorld& shared, py::handle id) -> py::object {
        if (id.is_none()) return object(shared.ask(all));
        const BodyId body = single_id(id);
        return object(shared.ask([&](World& world) { return of(world, body); }));
      },
      text, py::arg("id") = py::none());
}

void add_lists(WorldType& type) {
  const auto pairs = [](const std::vector<BodyPair>& found) { return array_of_pairs(found); };
  add_list(
      type, "pairs",
      "pairs(self, id=None)\n--\n\nAll pairs that touched at the last update, or those of one "
      "body, ascending, of the shape (k, 2).",
      [](World& world) { return world.pairs(); },
      [](World& world, BodyId id) { return world.pairs(id); }, pairs);
  add_list(
      type, "near_pairs",
      "near_pairs(self, id=None)\n--\n\nLikewise all pairs with a margin that were within it, "
      "touching or not.",
      [](World& world) { return world.near_pairs(); },
      [](World& world, BodyId id) { return world.near_pairs(id); }, pairs);
  add_list(
      type, "contacts",
      "contacts(self, id=None)\n--\n\nThe contacts of all solid pairs that touch or are near, or "
      "of those of one body: WorldContacts. Raises InputError while changes wait for an update.",
      [](World& world) { return world.contacts(); },
      [](World& world, BodyId id) { return world.contacts(id); },
      [](const std::vector<BodyContact>& contacts) { return result_of(contacts); });
}

}  // namespace

void add_world_states(py::module_& module) {
  WorldType type(module.attr("World"));
  add_members(type);
  add_lists(type);
}

}  // namespace graze::python
