#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/pairs/parallel_pairs.h>
#include <graze/engine/mesh/pairs/shared_walk.h>
#include <graze/engine/mesh/query/sort_pairs.h>
#include <graze/engine/mesh/query/threads.h>
#include <tbb/task_group.h>

namespace graze {
namespace {

/// The number of pairs that a walk hands out before it is shared: what ends sooner takes less time
/// than to wake another thread.
constexpr std::size_t kPairsAlone = 64;

auto into(std::vector<TrianglePair>& found) {
  return [&found](TrianglePair pair) {
    found.push_back(pair);
    return bvh::Walk::Continue;
  };
}

/// Answers one query with many threads.
class ParallelPairs {
 public:
  ParallelPairs(const WideQuery& query, Touch touch, int threads)
      : query_(query),
        touch_(touch),
        threads_(threads),
        first_(query.walk(bvh::WidePairWalk::Goal::AllPairs)) {}

  std::vector<TrianglePair> run(Work& work) {
    std::vector<TrianglePair> found;
    Candidates candidates(touch_, work);
    if (!begin_alone(candidates, found)) {
      shares_.resize(thread_count(threads_) - 1);
      run_in_arena(threads_, [&] {
        group_.run_and_wait([&] {
          bvh::in_standard_arithmetic([&] {
            wake(0);
            walk_in_turns(first_, shared_.begin(), candidates, found);
          });
        });
      });
    }
    candidates.decide(into(found));
    add_counts(first_.counts(), work);
    for (const Share& share : shares_) {
      work += share.work;
      found.insert(found.end(), share.found.begin(), share.found.end());
    }
    // Each pair is found once: sorted, they are the same whoever found them.
    sort_pairs(found);
    return found;
  }

 private:
  /// Begins the walk alone. Returns whether that was all.
  bool begin_alone(Candidates& candidates, std::vector<TrianglePair>& found) {
    bvh::FoundPair places[bvh::WidePairWalk::kMany];
    for (std::size_t alone = 0; alone < kPairsAlone;) {
      const std::size_t count = first_.next(places);
      query_.decide_found({places, count}, candidates, into(found));
      if (count == 0) return true;
      alone += count;
    }
    return first_.is_over();
  }

  /// Wakes another thread, if there may be one more.
  void wake(std::size_t index) {
    if (index < shares_.size()) group_.run([this, index] { help(index); });
  }

  void help(std::size_t index) {
    bvh::in_standard_arithmetic([&] {
      bvh::WidePairWalk walk = first_.another();
      SharedWalk::Turn turn = shared_.take(walk);
      if (!turn) return;
      // If there is work for one thread there may be for more.
      wake(2 * index + 1);
      wake(2 * index + 2);
      Share& share = shares_[index];
      Candidates candidates(touch_, share.work);
      walk_in_turns(walk, std::move(turn), candidates, share.found);
      candidates.decide(into(share.found));
      add_counts(walk.counts(), share.work);
    });
  }

  void walk_in_turns(bvh::WidePairWalk& walk, SharedWalk::Turn turn, Candidates& candidates,
                     std::vector<TrianglePair>& found) {
    bvh::FoundPair places[bvh::WidePairWalk::kMany];
    for (; turn; turn = shared_.take(walk)) {
      while (const std::size_t count = walk.next(places)) {
        query_.decide_found({places, count}, candidates, into(found));
        if (shared_.is_wanted()) shared_.give(walk);
      }
      turn.reset();
    }
  }

  struct Share {
    std::vector<TrianglePair> found;
    Work work;
  };

  const WideQuery& query_;
  Touch touch_;
  int threads_;
  bvh::WidePairWalk first_;
  SharedWalk shared_;
  std::vector<Share> shares_;
  tbb::task_group_context alone_{
      tbb::task_group_context::isolated};  // isolated as bvh/value/parallel.h says
  tbb::task_group group_{alone_};
};

}  // namespace

std::vector<TrianglePair> find_pairs_in_parallel(const WideQuery& query, Touch touch, int threads,
                                                 Work& work) {
  return ParallelPairs(query, touch, threads).run(work);
}

}  // namespace graze
