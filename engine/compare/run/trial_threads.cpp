#include <graze/engine/compare/run/trial_threads.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace graze::compare {

void run_on_threads(std::size_t threads, std::size_t most, const std::function<void()>& work,
                    const std::function<void()>& stop) {
  std::mutex mutex;
  std::exception_ptr failure;
  const auto guarded = [&] {
    try {
      work();
    } catch (...) {
      stop();
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::size_t count = threads != 0 ? threads : std::thread::hardware_concurrency();
  count = std::clamp<std::size_t>(count, 1, std::max<std::size_t>(most, 1));
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < count; ++i)
    others.emplace_back(guarded);
  guarded();
  for (std::thread& other : others)
    other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace graze::compare
