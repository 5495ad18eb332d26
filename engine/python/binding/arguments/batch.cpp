#include <graze/engine/python/binding/arguments/batch.h>

#include <string>

namespace graze::python {

std::function<void(std::size_t, std::size_t)> watcher(py::handle progress) {
  const bool is_bar = py::hasattr(progress, "update");
  if (!progress.is_none() && !is_bar && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress: is neither callable nor has a method update()");
  return [progress, is_bar, before = std::size_t{0}](std::size_t done, std::size_t total) mutable {
    const py::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress.is_none()) return;
    if (is_bar) {
      progress.attr("update")(done - before);
      before = done;
    } else {
      progress(done, total);
    }
  };
}

Batch::Batch(py::handle threads_argument, py::handle progress_argument)
    : progress(progress_argument) {
  const std::size_t count = count_from(threads_argument, "threads");
  if (count > 0x7fffffff) throw InputError("threads: " + std::to_string(count) + " is too many");
  threads = static_cast<int>(count);
  if (!progress.is_none()) static_cast<void>(watcher(progress));
}

Work* work_from(py::handle argument) {
  if (argument.is_none()) return nullptr;
  if (!py::isinstance<Work>(argument)) throw py::type_error("work: is no graze.Work");
  return argument.cast<Work*>();
}

}  // namespace graze::python
