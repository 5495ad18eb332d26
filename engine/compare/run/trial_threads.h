#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace graze::compare {

/// Returns as many threads as are asked for; 0 asks for as many as there are processors.
std::size_t thread_count(std::size_t threads);

/// Calls `work` on as many threads (0: as there are processors) as there is work for, this one
/// among them, and then throws what the first that failed threw. Each calls it once; `stop` is to
/// end the others' loops.
void run_on_threads(std::size_t threads, std::size_t most, const std::function<void()>& work,
                    const std::function<void()>& stop);

/// Holds the places that a run goes through: [first, end).
struct PlaceRange {
  std::size_t first = 0;
  std::size_t end = 0;
  std::size_t threads = 0;          ///< 0 for as many as there are processors
  std::size_t most_at_once = 1024;  ///< the number of places that a thread may take at a time
};

/// Makes the record of each place, on all threads, and hands them on in the order of places, some
/// at a time, by one thread at a time. Records that are done early wait, and a thread that is far
/// ahead waits for the others, so that memory does not grow with the places. `begin` is called in
/// the order of places, too, and what it returns is handed to `make`. Once `on_records` returns
/// false nothing new is begun; what was begun is finished, and handed on as far as nothing is
/// missing before it.
template <typename Record, typename Begin, typename Make, typename OnRecords>
void run_in_order(const PlaceRange& range, const Begin& begin, const Make& make,
                  const OnRecords& on_records) {
  using Token = decltype(begin(std::size_t{}));
  const std::size_t threads = thread_count(range.threads);
  const std::size_t places = range.end > range.first ? range.end - range.first : 0;
  // It takes as many at a time as take some hundredths of a second, so that nobody waits long for a
  // stop, and few enough that all threads end together.
  const std::size_t most_at_once =
      std::clamp<std::size_t>(places / (threads * 16), 1, range.most_at_once);
  std::atomic<std::size_t> at_once = 1;
  const std::size_t most_ahead = 4 * threads;  // the number of pieces that may be done before their
                                               // turn
  std::mutex beginning;
  std::size_t next = range.first;
  std::size_t pieces = 0;
  std::atomic<bool> is_stopped = false;
  std::mutex ordering;
  std::condition_variable is_handed_on;
  struct Piece {
    std::vector<Record> records;
    bool is_whole;  ///< nothing can follow a piece that is not
  };
  std::map<std::size_t, Piece> done;  // these wait for their turn
  std::size_t handed_on = 0;

  const auto stop = [&] {
    const std::lock_guard lock(ordering);
    is_stopped = true;
    is_handed_on.notify_all();
  };
  const auto hand_on = [&](std::size_t number, Piece piece) {
    const std::lock_guard lock(ordering);
    done.emplace(number, std::move(piece));
    for (auto at = done.find(handed_on); at != done.end(); at = done.find(handed_on)) {
      Piece ready = std::move(at->second);
      done.erase(at);
      handed_on += ready.is_whole;
      if (!ready.records.empty() && !on_records(std::move(ready.records))) is_stopped = true;
    }
    is_handed_on.notify_all();
  };
  run_on_threads(
      threads, places,
      [&] {
        while (!is_stopped) {
          std::vector<std::pair<std::size_t, Token>> mine;
          std::size_t piece = 0;
          {
            const std::lock_guard lock(beginning);
            const std::size_t end = std::min(range.end, (next / at_once + 1) * at_once);
            for (; next < end; ++next)
              mine.emplace_back(next, begin(next));
            if (mine.empty()) return;
            piece = pieces++;
          }
          {
            std::unique_lock lock(ordering);
            is_handed_on.wait(lock, [&] { return is_stopped || piece < handed_on + most_ahead; });
          }
          std::vector<Record> records;
          const auto start = std::chrono::steady_clock::now();
          for (auto& [place, token] : mine) {
            if (is_stopped && mine.size() > 1) break;
            records.push_back(make(place, std::move(token)));
          }
          const auto took = std::chrono::steady_clock::now() - start;
          if (took < std::chrono::milliseconds(20))
            at_once = std::min(2 * mine.size(), most_at_once);
          else if (took > std::chrono::milliseconds(100))
            at_once = std::max<std::size_t>(mine.size() / 2, 1);
          const bool is_whole = records.size() == mine.size();
          hand_on(piece, {std::move(records), is_whole});
        }
      },
      stop);
}

}  // namespace graze::compare
