#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/pair_memories.h>

#include <memory>

namespace graze::python {

LockedMemory::LockedMemory(py::handle argument, const PlacedPair& pair) {
  if (argument.is_none()) return;
  if (!py::isinstance<SharedMemory>(argument))
    throw py::type_error("memory: is no graze.PairMemory");
  if (!pair.are_meshes()) throw py::type_error("memory: is for two meshes");
  shared_ = argument.cast<SharedMemory*>();
}

std::unique_lock<std::mutex> LockedMemory::lock_for_batch() const {
  const py::gil_scoped_release released;
  return lock();
}

Batch LockedMemory::batch(py::handle threads, py::handle progress) const {
  Batch batch(threads, progress);
  if (shared_ != nullptr) batch.threads = 1;
  return batch;
}

void add_pair_memories(py::module_& module) {
  py::class_<SharedMemory>(module, "PairMemory",
                           R"(What the last queries of one pair of meshes learned.

It saves time along a motion and changes no answer. One query at a time uses it; others wait.

>>> memory = graze.PairMemory()
>>> for step in np.stack([pose, pose]):
...     hit = graze.intersects(bolt, (nut, step), memory=memory)
>>> memory.still_touching > 0
True
)")
      .def(py::init([] { return std::make_unique<SharedMemory>(); }),
           "__init__(self)\n--\n\nIt knows nothing.")
      .def_property_readonly(
          "still_apart", [](const SharedMemory& shared) { return shared.memory.still_apart(); },
          "How many queries ended without a look at the trees, because the meshes had not come "
          "near enough.")
      .def_property_readonly(
          "still_touching",
          [](const SharedMemory& shared) { return shared.memory.still_touching(); },
          "How many did because triangles that had touched, or had been within the clearance, "
          "still do.");
}

}  // namespace graze::python
