#include <graze/engine/compare/run/trial_threads.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace graze::compare {

std::size_t thread_count(std::size_t threads) {
  return std::max<std::size_t>(threads != 0 ? threads : std::thread::hardware_concurrency(), 1);
}

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
  const std::size_t count =
      std::clamp<std::size_t>(thread_count(threads), 1, std::max<std::size_t>(most, 1));
  std::vector<std::thread> others;
  for (std::size_t i = 1; i < count; ++i)
    others.emplace_back(guarded);
  guarded();
  for (std::thread& other : others)
    other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace graze::compare
