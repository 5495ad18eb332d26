#pragma once

// Many answers in one call, on many threads, which Python can watch and end.

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/bvh/error.h>
#include <graze/engine/work.h>

#include <functional>

namespace graze::python {

/// How a batch is asked.
struct Batch {
  Batch(py::handle threads_argument, py::handle progress_argument);

  int threads;          ///< 0: all that there are
  py::handle progress;  ///< called with (done, total), or has a method update(more); None: neither
};

/// Counters that a caller may have asked for, or nothing.
Work* work_from(py::handle argument);

/// Calls `ask`; if it throws an error of graze, `blame` first, to throw what names the argument as
/// Python does.
template <typename Ask>
void ask_and_blame(const Ask& ask, const std::function<void()>& blame) {
  try {
    ask();
  } catch (const Error&) {
    if (blame) blame();
    throw;
  }
}

/// Calls `part` for parts [begin, end) of [0, count) until all are done, on threads that hold no
/// lock of Python, and between chunks of about a twentieth of a second looks for signals and tells
/// of progress. What `part` throws ends it and is thrown here; if that is of graze, `blame` is
/// called first, to throw what names the first element that is at fault.
void run_batch(std::size_t count, const Batch& batch, Work* total,
               const std::function<void(std::size_t begin, std::size_t end, Work& work)>& part,
               const std::function<void()>& blame = {});

}  // namespace graze::python
