#pragma once

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/engine/world/voxel_map.h>

#include <mutex>

namespace graze::python {

/// Holds a map that threads of Python may share: one waits for the other.
struct SharedMap {
  explicit SharedMap(VoxelMap&& full) : map(std::move(full)) {}

  template <typename Ask>
  auto ask(const Ask& question) {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(mutex);
    return question(map);
  }

  VoxelMap map;
  std::mutex mutex;
};

}  // namespace graze::python
