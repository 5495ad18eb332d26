#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>
#include <utility>

namespace graze::compare {

/// Calls `work` on as many threads (0: as there are processors) as there is work for, this one
/// among them, and then throws what the first that failed threw. Each calls it once; `stop` is to
/// end the others' loops.
void run_on_threads(std::size_t threads, std::size_t most, const std::function<void()>& work,
                    const std::function<void()>& stop);

/// Makes the record of each place that is not done, and hands it on, one thread at a time.
template <typename Record>
void run_on_places(std::size_t threads, std::size_t places,
                   const std::function<bool(std::size_t)>& is_done,
                   const std::function<Record(std::size_t)>& record_of,
                   const std::function<void(Record)>& on_record) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  run_on_threads(
      threads, places,
      [&] {
        for (std::size_t place = next++; place < places; place = next++) {
          if (is_done(place)) continue;
          Record record = record_of(place);
          const std::lock_guard lock(mutex);
          on_record(std::move(record));
        }
      },
      [&] { next = places; });
}

}  // namespace graze::compare
