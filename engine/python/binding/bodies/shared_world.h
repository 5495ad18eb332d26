#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>
#include <graze/engine/python/binding/arguments/batch.h>
#include <graze/engine/python/binding/bodies/body_ids.h>

#include <graze/bvh/error.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/world/contact_tracker.h>
#include <graze/engine/world/world.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace graze::python {

/// Holds a world that threads of Python may share: one waits for the other. A filter of a user's
/// own may ask the world within an update.
struct SharedWorld {
  explicit SharedWorld(const WorldSettings& settings) : world(settings) {}

  /// Returns what `ask(world)` returns, with the world's lock and without Python's.
  template <typename Ask>
  auto ask(const Ask& question) {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(mutex);
    check_free();
    return question(world);
  }

  /// Throws InputError while a batch is asking the world: then one thread holds the lock, and calls
  /// back to tell of progress, while others read.
  void check_free() const {
    if (is_in_batch) throw InputError("progress: cannot use the world that is being asked");
  }

  World world;
  std::optional<ContactTracker> tracker;  ///< set if it tracks contacts
  std::recursive_mutex mutex;
  bool is_in_batch = false;  ///< read and written with the lock
};

/// Calls `ask(world, settings)` for a batch that has the world's lock: its threads read it, and
/// nobody changes it meanwhile. `blame` is that of run_batch().
template <typename Ask>
void ask_world_in_batch(SharedWorld& shared, const Batch& batch, const Ask& ask,
                        const std::function<void()>& blame = {}) {
  run_batch(
      batch, nullptr,
      [&](const BatchSettings& settings, Work&) {
        const std::scoped_lock lock(shared.mutex);
        shared.check_free();
        const World& world = shared.world;
        const struct InBatch {
          explicit InBatch(bool& is_so) : is_so_(is_so) { is_so_ = true; }
          ~InBatch() { is_so_ = false; }
          InBatch(const InBatch&) = delete;
          InBatch& operator=(const InBatch&) = delete;
          bool& is_so_;
        } in_batch(shared.is_in_batch);
        ask(world, settings);
      },
      blame);
}

/// Calls `ask(world, i)` for `count` questions in the same way, where what they ask is read in
/// place and what they answer is written to it.
template <typename Ask>
void ask_world_for_all(SharedWorld& shared, std::size_t count, const Batch& batch, const Ask& ask,
                       const std::function<void()>& blame) {
  ask_world_in_batch(
      shared, batch,
      [&](const World& world, const BatchSettings& settings) {
        for_each_in_batch(count, kMostInAPart, settings, nullptr,
                          [&](std::size_t i, Work&) { ask(world, i); });
      },
      blame);
}

/// Returns all lists in one, and as an array where each begins, and the end of the last.
template <typename T>
std::pair<std::vector<T>, py::object> joined(const std::vector<std::vector<T>>& lists) {
  std::vector<std::int64_t> offsets{0};
  offsets.reserve(lists.size() + 1);
  for (const std::vector<T>& list : lists)
    offsets.push_back(offsets.back() + static_cast<std::int64_t>(list.size()));
  std::vector<T> all;
  all.reserve(static_cast<std::size_t>(offsets.back()));
  for (const std::vector<T>& list : lists)
    all.insert(all.end(), list.begin(), list.end());
  return {std::move(all), array_over<std::int64_t>(std::move(offsets))};
}

/// Calls `ask(world, id)` for each, for all or none: unknown ids are refused first.
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

/// Returns what `ask(world, other)` returns, with the locks of both and without Python's.
template <typename Ask>
auto ask_both(SharedWorld& shared, SharedWorld& other, const Ask& question) {
  const py::gil_scoped_release released;
  const std::scoped_lock lock(shared.mutex, other.mutex);
  shared.check_free();
  other.check_free();
  return question(shared.world, other.world);
}

/// Holds a function of Python that says which pairs may meet. Threads without Python's lock may
/// release it.
class PythonFilter {
 public:
  /// Throws TypeError for an object that cannot be called.
  explicit PythonFilter(py::handle argument);
  bool operator()(BodyId a, BodyId b) const;
  py::object function() const { return *function_; }

 private:
  std::shared_ptr<py::object> function_;
};

/// Holds another world in a pose, as an argument where a shape may stand.
struct PlacedWorld {
  SharedWorld* shared;
  Pose pose;
};
std::optional<PlacedWorld> world_from(py::handle argument);

// These functions ask worlds about each other.
py::object pairs_touching(SharedWorld& shared, const PlacedWorld& other,
                          const WorldPairSettings& settings);
py::object pairs_within(SharedWorld& shared, const PlacedWorld& other, double clearance,
                        const WorldPairSettings& settings);
py::object closest_pair(SharedWorld& shared, const PlacedWorld& other,
                        const WorldPairSettings& settings);
/// Throws InputError for a filter, as those of the worlds count.
WorldPairSettings pair_settings(py::handle filter, py::handle role);

/// Returns contacts of pairs as WorldContacts, with their numbers if they are tracked.
py::object result_of(const std::vector<BodyContact>& contacts, std::vector<std::uint64_t> ids = {});
BodyQuerySettings query_settings(py::handle filter, py::handle role);
/// Returns the filter of (category, mask, group).
Filter filter_from(py::handle argument);
/// Returns (category, mask, group) of a filter.
py::tuple tuple_of(const Filter& filter);
Role role_from(py::handle argument);
BodyKind kind_from(py::handle argument);
Detection detection_from(py::handle argument);

}  // namespace graze::python
