#pragma once

#include <tbb/task_arena.h>

#include <cstddef>
#include <memory>

namespace graze::bvh {

/// The threads among which a box set shares its work, in chunks that do not depend on their number.
class Workers {
 public:
  explicit Workers(int threads);

  /// Returns false if the work had better be done in one go: for one thread, or for too little work
  /// to share.
  bool share(std::size_t boxes) const { return arena_ != nullptr && boxes >= kFewBoxes; }

  /// Calls work(chunk) for each chunk below `chunks`.
  template <typename Work>
  void for_each(std::size_t chunks, const Work& work) const {
    if (arena_ == nullptr || chunks < 2) {
      for (std::size_t chunk = 0; chunk < chunks; ++chunk)
        work(chunk);
    } else {
      share_out(chunks, {[](const void* context, std::size_t chunk) {
                           (*static_cast<const Work*>(context))(chunk);
                         },
                         &work});
    }
  }

  /// Runs work that forks.
  template <typename Work>
  void run(const Work& work) const {
    run_forking(
        {[](const void* context, std::size_t /*chunk*/) { (*static_cast<const Work*>(context))(); },
         &work});
  }

 private:
  /// Work that is called by its address: oneTBB's templates are compiled once, not for each kind of
  /// work.
  struct OpaqueWork {
    void (*call)(const void* context, std::size_t chunk);
    const void* context;

    void operator()(std::size_t chunk) const { call(context, chunk); }
  };

  static constexpr std::size_t kFewBoxes = 4096;

  void share_out(std::size_t chunks, const OpaqueWork& work) const;
  void run_forking(const OpaqueWork& work) const;

  std::unique_ptr<tbb::task_arena> arena_;
};

}  // namespace graze::bvh
