#pragma once

// These functions do work at once on several threads; it is done when the call returns. oneTBB does
// it. ThreadSanitizer cannot follow oneTBB, which is not compiled for it, and would call every
// result of a worker a race. Code that it watches forks threads that it can see, one for each part:
// where TBB may let parts run at once they do, and nothing else orders them.

#if defined(__SANITIZE_THREAD__)
#define GRAZE_FORKS_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define GRAZE_FORKS_THREADS
#endif
#endif

#ifdef GRAZE_FORKS_THREADS
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#endif

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <cstddef>

namespace graze::bvh {

/// Calls work(i) for each i below `count`.
template <typename Work>
void fork_each(std::size_t count, const Work& work);

/// Calls both functions.
template <typename First, typename Second>
void fork_both(const First& first, const Second& second);

#ifdef GRAZE_FORKS_THREADS

template <typename Work>
void fork_each(std::size_t count, const Work& work) {
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < count; ++i)
    threads.emplace_back([&work, i] { in_standard_arithmetic([&] { work(i); }); });
  for (std::thread& thread : threads)
    thread.join();
}

template <typename First, typename Second>
void fork_both(const First& first, const Second& second) {
  std::thread thread([&first] { in_standard_arithmetic([&] { first(); }); });
  second();
  thread.join();
}

#else

template <typename Work>
void fork_each(std::size_t count, const Work& work) {
  tbb::parallel_for(std::size_t{0}, count,
                    [&work](std::size_t i) { in_standard_arithmetic([&] { work(i); }); });
}

template <typename First, typename Second>
void fork_both(const First& first, const Second& second) {
  tbb::parallel_invoke([&first] { in_standard_arithmetic([&] { first(); }); },
                       [&second] { in_standard_arithmetic([&] { second(); }); });
}

#endif

}  // namespace graze::bvh
