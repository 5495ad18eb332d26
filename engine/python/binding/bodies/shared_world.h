#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>
#include <graze/engine/python/binding/bodies/body_ids.h>

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

/// Contacts of pairs as WorldContacts.
py::object result_of(const std::vector<BodyContact>& contacts);
BodyQuerySettings query_settings(py::handle filter, py::handle role);
/// (category, mask, group).
Filter filter_from(py::handle argument);
Role role_from(py::handle argument);

}  // namespace graze::python
