#pragma once

// Shares questions about pairs among threads. Private to engine/world.

#include <graze/bvh/box_set/store/workers.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/world/bodies/body_motion.h>
#include <graze/engine/world/bodies/pair_news.h>
#include <graze/engine/world/shapes/shape_work.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace graze {

/// The answer about a pair, before the world takes note of it.
struct PairAnswer {
  enum class Kind : std::uint8_t {
    Asleep,     ///< the pair was not tested, as neither body is awake
    Apart,      ///< tested
    Near,       ///< the bodies are within their margin, and do not touch
    Touching,   ///< tested
    ForCaller,  ///< only the caller's thread may test the pair
  };

  KnownGap known_gap = {};
  Kind kind = Kind::Asleep;
  bool has_measured = false;  ///< whether the gap was measured to know `known_gap`

  bool is_near() const { return kind == Kind::Near || kind == Kind::Touching; }
};

/// Pairs that one thread asks, one after the other, and the news of them.
struct alignas(64) PairBatch {
  std::uint32_t first = 0;  ///< the first pair of the batch
  std::uint32_t end = 0;
  bool has_mark = false;  ///< whether some body has Bodies::Changes::has_unbuilt_tree
  NewsPlace place = {};
  std::size_t place_of_contacts = 0;
  PairNews news;
};

/// Pairs in batches, which threads take in turn. The batches do not depend on how many threads
/// there are. Questions change nothing: answers wait until all are there, so that the world can
/// take note of them in the order of the pairs. All memory is kept from update to update.
class PairBatches {
 public:
  void clear() {
    count_ = 0;
    pairs_ = 0;
    cost_ = 0;
    open_cost_ = kBatchCost;
    has_pairs_for_caller_ = false;
  }

  /// Adds a pair, whose test takes about as long as `cost` tests of two boxes; if that is 0, only
  /// the caller's thread may test it.
  void add(std::uint32_t cost) {
    if (open_cost_ >= kBatchCost) begin_batch();
    ++pairs_;
    open_cost_ += cost;
    cost_ += cost;
    has_pairs_for_caller_ |= cost == 0;
  }

  /// True if the pairs added take long enough for more than one thread.
  bool are_worth_sharing() const { return cost_ >= kWorthSharing; }

  /// Sets the answers of all pairs to `ask(i, batch)`, which several threads call at once, and
  /// which adds to the batch's news. If a call throws, the pairs before that one have their
  /// answers, as they have with one thread; check() throws what it threw.
  template <typename Ask>
  void ask_all(const bvh::Workers& workers, std::size_t threads, const Ask& ask) {
    begin_asking();
    // Pool threads ask as the user of the caller's thread computes.
    const std::uint64_t users_word = bvh::users_control_word();
    workers.for_each(std::min(threads, count_), [&](std::size_t) {
      bvh::in_users_arithmetic(users_word,
                               [&] { bvh::in_standard_arithmetic([&] { ask_in_turn(ask); }); });
    });
  }

  std::span<PairBatch> batches() { return {batches_.data(), count_}; }
  const PairAnswer& answer(std::uint32_t pair) const { return answers_[pair]; }

  /// True if all pairs have been asked.
  bool are_all_answered() const {
    return !has_pairs_for_caller_ && failed_.load(std::memory_order_relaxed) == kNone;
  }

  /// Throws the exception of the question about the pair, if that is the first that threw.
  void check(std::uint32_t pair) {
    if (pair != failed_.load(std::memory_order_relaxed)) return;
    std::rethrow_exception(std::exchange(failure_, nullptr));
  }

  /// Makes room in `all` for the news of all batches, behind the news that are there. If this
  /// throws, the pairs listed as begun and ended are still the same.
  void make_room_in(PairNews& all);
  /// Makes room in `all` for the contacts of all batches.
  void make_room_in(ContactList& all);

 private:
  static constexpr std::uint32_t kBatchCost = 32, kWorthSharing = 64;
  static constexpr std::uint32_t kNone = 0xffffffff;

  void begin_batch();
  void begin_asking();
  void note_failure(std::uint32_t pair);

  /// Takes batches until none is left, or only batches after a pair that threw. Batches are taken
  /// in ascending order, so that those before that pair are asked to their end.
  template <typename Ask>
  void ask_in_turn(const Ask& ask) {
    for (;;) {
      const std::size_t index = next_.fetch_add(1, std::memory_order_relaxed);
      if (index >= count_) return;
      PairBatch& batch = batches_[index];
      if (batch.first > failed_.load(std::memory_order_relaxed)) return;
      ask_batch(ask, batch);
    }
  }

  template <typename Ask>
  void ask_batch(const Ask& ask, PairBatch& batch) {
    batch.news.clear();
    batch.has_mark = false;
    const ShapeWorkScope counting(batch.news.work.shapes);
    std::uint32_t pair = batch.first;
    try {
      for (; pair < batch.end; ++pair)
        answers_[pair] = ask(pair, batch);
    } catch (...) {
      note_failure(pair);
    }
  }

  std::vector<PairBatch> batches_;  ///< the first `count_` are in use
  std::size_t count_ = 0;
  std::uint32_t pairs_ = 0;
  std::uint32_t open_cost_ = kBatchCost;  ///< the cost of the last batch
  std::uint64_t cost_ = 0;                ///< the cost of all pairs
  bool has_pairs_for_caller_ = false;
  std::vector<PairAnswer> answers_;
  std::atomic<std::size_t> next_ = 0;          ///< the next batch that no thread has taken yet
  std::atomic<std::uint32_t> failed_ = kNone;  ///< the first pair whose question threw
  std::mutex failing_;
  std::exception_ptr failure_;
};

/// Writes the pairs of a batch's news to their place in all news, in which there is room.
void put_pairs(const PairBatch& batch, PairNews& all) noexcept;
/// Writes the contacts of a batch to their place in the list of all, where some may need memory of
/// their own.
void put_contacts(const PairBatch& batch, ContactList& all);

}  // namespace graze
