#pragma once

#include <graze/engine/python/binding/arguments/batch.h>
#include <graze/engine/python/binding/arguments/placed.h>

#include <graze/engine/mesh/pair_memory.h>

#include <mutex>

namespace graze::python {

/// Holds a PairMemory that Python's threads may share: one waits for the other.
struct SharedMemory {
  PairMemory memory;
  std::mutex mutex;
};

/// Holds the memory that a query was given, if any.
class LockedMemory {
 public:
  /// Throws TypeError for anything but a memory, and for a pair that is not of two meshes.
  LockedMemory(py::handle argument, const PlacedPair& pair);

  PairMemory* get() const { return shared_ == nullptr ? nullptr : &shared_->memory; }

  /// Locks the memory, for callers without the lock of Python; it must be held while the memory is
  /// used.
  std::unique_lock<std::mutex> lock() const {
    return shared_ == nullptr ? std::unique_lock<std::mutex>() : std::unique_lock(shared_->mutex);
  }
  /// Locks the memory, for callers with the lock of Python.
  std::unique_lock<std::mutex> lock_for_batch() const;

  /// Returns the batch. With a memory poses are asked in their order.
  Batch batch(py::handle threads, py::handle progress) const;

 private:
  SharedMemory* shared_ = nullptr;
};

}  // namespace graze::python
