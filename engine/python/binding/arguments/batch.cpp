#include <graze/engine/python/binding/arguments/batch.h>

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/query/threads.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <string>

namespace graze::python {
namespace {

using Clock = std::chrono::steady_clock;

/// Seconds after which Python is looked at again: a signal is then answered well within a second.
constexpr double kChunkSeconds = 0.05;
/// So much longer than the last one a chunk is at most.
constexpr std::size_t kGrowth = 8;
/// Elements of a part: as many as the library's own batches take.
constexpr std::size_t kMostInAPart = 64;
constexpr std::size_t kPartsPerThread = 16;

void answer_chunk(std::size_t begin, std::size_t end, int threads, Work& total, std::mutex& mutex,
                  const std::function<void(std::size_t, std::size_t, Work&)>& part) {
  const std::size_t parts = thread_count(threads) * kPartsPerThread;
  const std::size_t size = std::clamp((end - begin) / parts, std::size_t{1}, kMostInAPart);
  for_each_part((end - begin + size - 1) / size, threads, [&](std::size_t index) {
    Work work;
    const std::size_t first = begin + index * size;
    part(first, std::min(first + size, end), work);
    const std::scoped_lock lock(mutex);
    total += work;
  });
}

/// Signals, and progress for whoever wants to hear of it.
void look_at_python(const Batch& batch, std::size_t before, std::size_t done, std::size_t count) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (batch.progress.is_none()) return;
  if (py::hasattr(batch.progress, "update")) {
    batch.progress.attr("update")(done - before);
  } else {
    batch.progress(done, count);
  }
}

}  // namespace

Batch::Batch(py::handle threads_argument, py::handle progress_argument)
    : progress(progress_argument) {
  const std::size_t count = count_from(threads_argument, "threads");
  if (count > 0x7fffffff) throw InputError("threads: " + std::to_string(count) + " is too many");
  threads = static_cast<int>(count);
  if (!progress.is_none() && !py::hasattr(progress, "update") &&
      PyCallable_Check(progress.ptr()) == 0) {
    throw py::type_error("progress: is neither callable nor has a method update()");
  }
}

Work* work_from(py::handle argument) {
  if (argument.is_none()) return nullptr;
  if (!py::isinstance<Work>(argument)) throw py::type_error("work: is no graze.Work");
  return argument.cast<Work*>();
}

void run_batch(std::size_t count, const Batch& batch, Work* total,
               const std::function<void(std::size_t, std::size_t, Work&)>& part,
               const std::function<void()>& blame) {
  Work sum;
  std::mutex mutex;
  std::size_t chunk = 4 * thread_count(batch.threads);
  const py::gil_scoped_release released;
  for (std::size_t done = 0; done < count;) {
    const std::size_t end = done + std::min(chunk, count - done);
    const auto began = Clock::now();
    ask_and_blame(
        [&] {
          bvh::in_standard_arithmetic(
              [&] { answer_chunk(done, end, batch.threads, sum, mutex, part); });
        },
        blame);
    const double took = std::chrono::duration<double>(Clock::now() - began).count();
    const double wanted = static_cast<double>(end - done) * kChunkSeconds / std::max(took, 1e-9);
    chunk = std::clamp(wanted < 1e18 ? static_cast<std::size_t>(wanted) : count, std::size_t{1},
                       kGrowth * chunk);
    {
      const py::gil_scoped_acquire acquired;
      look_at_python(batch, done, end, count);
    }
    done = end;
  }
  if (total != nullptr) *total += sum;
}

}  // namespace graze::python
