#include <graze/engine/mesh/parallel_pairs.h>
#include <graze/engine/mesh/sort_pairs.h>
#include <graze/engine/mesh/threads.h>

#include <algorithm>
#include <utility>

namespace graze {
namespace {

/// Parts for each thread, and subtrees for each part, that lie apart from each other: they differ
/// in cost, and what is left at the end should be short.
constexpr std::size_t kPartsPerThread = 8;
constexpr std::size_t kStartsPerPart = 2;

/// Pairs that a walk hands out before it is shared: what ends sooner takes less time than to wake
/// another thread.
constexpr std::size_t kPairsAlone = 100;

struct Part {
  std::vector<bvh::WidePairWalk::Waiting> starts;
  std::vector<TrianglePair> found;
  Work work;
};

/// Decides what a walk hands out first. Whether that was all.
template <typename OnPair>
bool begin_alone(const WideQuery& query, bvh::WidePairWalk& walk, Candidates& candidates,
                 OnPair&& on_pair) {
  bvh::PlacePair places[bvh::WidePairWalk::kMostAtOnce];
  for (std::size_t alone = 0; alone < kPairsAlone;) {
    const std::size_t count = walk.next(places);
    query.decide({places, count}, candidates, on_pair);
    if (count == 0) return true;
    alone += count;
  }
  return walk.is_over();
}

/// Opens pairs of boxes level by level until so many wait. What leaves meet on the way is decided.
template <typename OnPair>
std::vector<bvh::WidePairWalk::Waiting> split(const WideQuery& query, bvh::WidePairWalk& walk,
                                              std::size_t count, Candidates& candidates,
                                              OnPair&& on_pair) {
  bvh::PlacePair places[bvh::WidePairWalk::kMostAtOnce];
  std::vector<bvh::WidePairWalk::Waiting> level;
  std::vector<bvh::WidePairWalk::Waiting> next;
  const auto open_one = [&] {
    const std::size_t found = walk.open_one(places, next);
    query.decide({places, found}, candidates, on_pair);
  };
  open_one();
  while (!next.empty() && next.size() < count) {
    std::swap(level, next);
    next.clear();
    for (const bvh::WidePairWalk::Waiting& waiting : level) {
      walk.start_at(waiting);
      open_one();
    }
  }
  candidates.decide(on_pair);
  return next;
}

/// All that was found, sorted: each pair is found once, so that they are the same whoever found
/// them.
std::vector<TrianglePair> gathered(std::vector<TrianglePair> found,
                                   const std::vector<Part>& parts) {
  std::size_t total = found.size();
  for (const Part& part : parts)
    total += part.found.size();
  found.reserve(total);
  for (const Part& part : parts)
    found.insert(found.end(), part.found.begin(), part.found.end());
  sort_pairs(found);
  return found;
}

}  // namespace

std::vector<TrianglePair> find_pairs_in_parallel(const WideQuery& query, Touch touch, int threads,
                                                 Work& work) {
  const auto into = [](std::vector<TrianglePair>& found) {
    return [&found](TrianglePair pair) {
      found.push_back(pair);
      return bvh::Walk::Continue;
    };
  };
  std::vector<TrianglePair> found;
  bvh::WidePairWalk walk = query.walk();
  Candidates candidates(touch, work);
  const std::size_t most = thread_count(threads) * kPartsPerThread;
  std::vector<bvh::WidePairWalk::Waiting> waiting;
  if (begin_alone(query, walk, candidates, into(found))) {
    candidates.decide(into(found));
  } else {
    waiting = split(query, walk, kStartsPerPart * most, candidates, into(found));
  }
  add_counts(walk.counts(), work);
  // Neighbours lie in different parts, so that where much meets is shared out.
  std::vector<Part> parts(std::min(most, waiting.size()));
  for (std::size_t i = 0; i < waiting.size(); ++i)
    parts[i % parts.size()].starts.push_back(waiting[i]);
  for_each_part(parts.size(), threads, [&](std::size_t i) {
    Part& part = parts[i];
    part.found.reserve(kPairsAlone);
    bvh::WidePairWalk own = walk.another();
    for (const bvh::WidePairWalk::Waiting& start : part.starts)
      own.start_at(start);
    Candidates own_candidates(touch, part.work);
    query.decide_all(own, own_candidates, into(part.found));
    add_counts(own.counts(), part.work);
  });
  for (const Part& part : parts)
    work += part.work;
  return gathered(std::move(found), parts);
}

}  // namespace graze
