#pragma once

// Asks many questions in one call, on many threads, which Python can watch and end.

#include <graze/engine/python/binding/arguments/arrays.h>

#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/query/batch.h>
#include <graze/engine/work.h>

#include <functional>

namespace graze::python {

/// Returns the function that long work calls now and then: it looks for signals, and tells of
/// progress. Throws TypeError for an object that cannot be told of it.
std::function<void(std::size_t done, std::size_t total)> watcher(py::handle progress);

/// Says how a batch is asked.
struct Batch {
  Batch(py::handle threads_argument, py::handle progress_argument);

  /// Returns the settings as the library takes them: it looks for signals while it runs.
  BatchSettings settings() const { return {.threads = threads, .on_progress = watcher(progress)}; }

  int threads;          ///< the number of threads; 0 for all that there are
  py::handle progress;  ///< is called with (done, total), or has a method update(more), or is None
};

/// Returns counters that a caller may have asked for, or null.
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

/// Calls `ask(settings, work)` without the lock of Python, as the library's batches are asked.
/// Passes on what it throws; before an error of graze it calls `blame`, to throw what names the
/// first element that is at fault.
template <typename Ask>
void run_batch(const Batch& batch, Work* total, const Ask& ask,
               const std::function<void()>& blame = {}) {
  Work sum;  // Python may look at the other counters meanwhile
  const BatchSettings settings = batch.settings();
  {
    const py::gil_scoped_release released;
    ask_and_blame([&] { bvh::in_standard_arithmetic([&] { ask(settings, sum); }); }, blame);
  }
  if (total != nullptr) *total += sum;
}

/// The number of elements of a part: as many as the library's own batches of poses take.
inline constexpr std::size_t kMostInAPart = 64;

/// Calls `ask(i, work)` for each element, as the library's own batches do, where the library has no
/// batch.
template <typename Ask>
void run_batch(std::size_t count, const Batch& batch, Work* total, const Ask& ask,
               const std::function<void()>& blame = {}, std::size_t most_in_a_part = kMostInAPart) {
  run_batch(
      batch, total,
      [&](const BatchSettings& settings, Work& sum) {
        for_each_in_batch(count, most_in_a_part, settings, &sum, ask);
      },
      blame);
}

}  // namespace graze::python
