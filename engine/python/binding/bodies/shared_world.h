#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>
#include <graze/engine/python/binding/bodies/body_ids.h>

#include <graze/bvh/value/element_error.h>
#include <graze/engine/world/world.h>

#include <mutex>
#include <utility>

namespace graze::python {

/// A world that threads of Python may share: one waits for the other. A filter of a user's own may
/// ask the world within an update.
struct SharedWorld {
  explicit SharedWorld(const WorldSettings& settings) : world(settings) {}

  /// What `ask(world)` returns, with the world's lock and without Python's.
  template <typename Ask>
  auto ask(const Ask& question) {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(mutex);
    return question(world);
  }

  World world;
  std::recursive_mutex mutex;
};

/// Calls `ask(world, id)` for each, all or none: unknown ids are refused first.
template <typename Ask>
void for_each_id(SharedWorld& shared, py::handle argument, const Ask& ask) {
  const Ids<BodyId> ids(argument);
  shared.ask([&](World& world) {
    for (std::size_t i = 0; i < ids.all.size(); ++i)
      bvh::at_element("id", i, [&] { static_cast<void>(world.kind(ids.all[i])); });
    for (const BodyId id : ids.all)
      ask(world, id);
  });
}

/// Contacts of pairs as WorldContacts.
py::object result_of(const std::vector<BodyContact>& contacts);
BodyQuerySettings query_settings(py::handle filter, py::handle role);
/// (category, mask, group).
Filter filter_from(py::handle argument);
Role role_from(py::handle argument);
BodyKind kind_from(py::handle argument);
Detection detection_from(py::handle argument);

}  // namespace graze::python
