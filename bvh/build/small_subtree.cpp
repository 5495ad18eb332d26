#include <graze/bvh/build/sah_sweep.h>
#include <graze/bvh/build/small_subtree.h>
#include <graze/bvh/tree/node_lanes.h>

#include <algorithm>

namespace graze::bvh {
namespace {

// Returns for each lane its neighbour, going round.
Lanes next(Lanes a) {
  return __builtin_shufflevector(a, a, 1, 2, 3, 0);
}

Lanes after_next(Lanes a) {
  return __builtin_shufflevector(a, a, 2, 3, 0, 1);
}

/// Four boxes, one per lane.
struct FourBoxes {
  Lanes minus_min[3];
  Lanes max[3];
};

void transpose(Lanes a, Lanes b, Lanes c, Lanes d, Lanes (&rows)[3]) {
  const Lanes ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Lanes cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  rows[0] = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
  rows[1] = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
  rows[2] = __builtin_shufflevector(__builtin_shufflevector(a, b, 2, 6, 3, 7),
                                    __builtin_shufflevector(c, d, 2, 6, 3, 7), 0, 1, 4, 5);
}

template <typename Shuffle>
FourBoxes shuffled(const FourBoxes& boxes, Shuffle shuffle) {
  FourBoxes result;
  for (int k = 0; k < 3; ++k) {
    result.minus_min[k] = shuffle(boxes.minus_min[k]);
    result.max[k] = shuffle(boxes.max[k]);
  }
  return result;
}

FourBoxes merged(const FourBoxes& a, const FourBoxes& b) {
  FourBoxes result;
  for (int k = 0; k < 3; ++k) {
    result.minus_min[k] = larger(a.minus_min[k], b.minus_min[k]);
    result.max[k] = larger(a.max[k], b.max[k]);
  }
  return result;
}

Lanes measured(const FourBoxes& box, Measure measure) {
  return measured(box.max[0] + box.minus_min[0], box.max[1] + box.minus_min[1],
                  box.max[2] + box.minus_min[2], measure);
}

/// Returns the cost of a leaf of several primitives for each measure of its box.
float leaf_cost(float count, const BuildSettings& settings) {
  return count <= static_cast<float>(settings.max_leaf_size)
             ? count * settings.primitive_cost
             : std::numeric_limits<float>::infinity();
}

/// The cheapest ways to hold each subset of four references, by the subsets' sizes. Lane i is about
/// references that begin at i and go round.
struct Costs {
  Lanes one;         ///< those of i
  Lanes two;         ///< those of i, i + 1
  Lanes two_across;  ///< those of i, i + 2
  Lanes three;       ///< those of i, i + 1, i + 2
};

Costs costs_of(const Reference (&r)[kSmallSubtree], Measure measure,
               const BuildSettings& settings) {
  FourBoxes ones;
  transpose(r[0].box.minus_min, r[1].box.minus_min, r[2].box.minus_min, r[3].box.minus_min,
            ones.minus_min);
  transpose(r[0].box.max, r[1].box.max, r[2].box.max, r[3].box.max, ones.max);
  const FourBoxes across = shuffled(ones, after_next);
  const FourBoxes twos = merged(ones, shuffled(ones, next));
  const Lanes two = measured(twos, measure);
  const Lanes two_across = measured(merged(ones, across), measure);
  const Lanes three = measured(merged(twos, across), measure);
  const Lanes two_in_leaf = all_lanes(leaf_cost(2, settings));
  const Lanes three_in_leaf = all_lanes(leaf_cost(3, settings));
  Costs costs;
  costs.one = measured(ones, measure) * all_lanes(settings.primitive_cost);
  costs.two = smaller(two + (costs.one + next(costs.one)), two * two_in_leaf);
  costs.two_across =
      smaller(two_across + (costs.one + after_next(costs.one)), two_across * two_in_leaf);
  const Lanes split =
      smaller(smaller(costs.one + next(costs.two), next(costs.one) + costs.two_across),
              after_next(costs.one) + costs.two);
  costs.three = smaller(three + split, three * three_in_leaf);
  return costs;
}

class Builder {
 public:
  Builder(std::span<Reference> range, std::size_t position, const BuildSettings& settings,
          Measure measure, std::vector<Node>& nodes)
      : out_(range.data()),
        position_(static_cast<std::uint32_t>(position)),
        settings_(settings),
        measure_(measure),
        nodes_(nodes) {
    for (std::size_t i = 0; i < kSmallSubtree; ++i)
      references_[i] = range[i < range.size() ? i : 0];
  }

  void build(std::size_t at, std::size_t count, const Bounds& box) {
    if (count == 2) {
      two(at, 0, 1, box);
      return;
    }
    costs_ = costs_of(references_, measure_, settings_);
    if (count == 3) {
      three(at, 0, box);
    } else {
      four(at, box);
    }
  }

 private:
  Bounds box(int i, int j) const { return merged(references_[i].box, references_[j].box); }

  void one(std::size_t at, int i) { leaf(at, {i}); }

  void leaf(std::size_t at, std::initializer_list<int> members) {
    nodes_[at].first = position_;
    nodes_[at].count = static_cast<std::uint32_t>(members.size());
    position_ += nodes_[at].count;
    for (int i : members)
      *out_++ = references_[i];
  }

  std::size_t open(std::size_t at, const Bounds& first, const Bounds& second) {
    const std::size_t children = nodes_.size();
    nodes_[at].first = static_cast<std::uint32_t>(children);
    nodes_.push_back(node_over(first, 0, 0));
    nodes_.push_back(node_over(second, 0, 0));
    return children;
  }

  void two(std::size_t at, int i, int j, const Bounds& both) {
    const float in_leaf = leaf_cost(2, settings_) * measured(both, measure_);
    const float apart = measured(both, measure_) +
                        settings_.primitive_cost * (measured(references_[i].box, measure_) +
                                                    measured(references_[j].box, measure_));
    if (!(apart < in_leaf) && settings_.max_leaf_size >= 2) {
      leaf(at, {i, j});
      return;
    }
    const std::size_t children = open(at, references_[i].box, references_[j].box);
    one(children, i);
    one(children + 1, j);
  }

  void one_and_two(std::size_t at, int i, int j, int k) {
    const Bounds pair = box(j, k);
    const std::size_t children = open(at, references_[i].box, pair);
    one(children, i);
    two(children + 1, j, k, pair);
  }

  void three(std::size_t at, int i, const Bounds& all) {
    const int j = (i + 1) % 4;
    const int k = (i + 2) % 4;
    const float apart_i = costs_.one[i] + costs_.two[j];
    const float apart_j = costs_.one[j] + costs_.two_across[i];
    const float apart_k = costs_.one[k] + costs_.two[i];
    const float best = std::min(std::min(apart_i, apart_j), apart_k);
    const float measure = measured(all, measure_);
    if (settings_.max_leaf_size >= 3 && !(measure + best < leaf_cost(3, settings_) * measure)) {
      leaf(at, {i, j, k});
    } else if (best == apart_i) {
      one_and_two(at, i, j, k);
    } else if (best == apart_j) {
      one_and_two(at, j, i, k);
    } else {
      one_and_two(at, k, i, j);
    }
  }

  void two_and_two(std::size_t at, int i, int j, int k, int l) {
    const Bounds first = box(i, j);
    const Bounds second = box(k, l);
    const std::size_t children = open(at, first, second);
    two(children, i, j, first);
    two(children + 1, k, l, second);
  }

  void four(std::size_t at, const Bounds& all) {
    const Lanes by_three = costs_.three + next(after_next(costs_.one));
    const Lanes by_two = costs_.two + after_next(costs_.two);
    const float across = costs_.two_across[0] + costs_.two_across[1];
    int last = 0;
    for (int i = 1; i < 4; ++i)
      last = by_three[i] < by_three[last] ? i : last;
    const float best = std::min(std::min(by_three[last], across), std::min(by_two[0], by_two[1]));
    const float measure = measured(all, measure_);
    if (settings_.max_leaf_size >= 4 && !(measure + best < leaf_cost(4, settings_) * measure)) {
      leaf(at, {0, 1, 2, 3});
    } else if (best == by_two[0]) {
      two_and_two(at, 0, 1, 2, 3);
    } else if (best == by_two[1]) {
      two_and_two(at, 1, 2, 3, 0);
    } else if (best == across) {
      two_and_two(at, 0, 2, 1, 3);
    } else {
      const Bounds rest = merged(box(last, (last + 1) % 4), references_[(last + 2) % 4].box);
      const std::size_t children = open(at, references_[(last + 3) % 4].box, rest);
      one(children, (last + 3) % 4);
      three(children + 1, last, rest);
    }
  }

  Reference references_[kSmallSubtree];
  Reference* out_;
  std::uint32_t position_;
  const BuildSettings& settings_;
  Measure measure_;
  std::vector<Node>& nodes_;
  Costs costs_;
};

}  // namespace

void build_small_subtree(std::span<Reference> references, const Part& part,
                         const BuildSettings& settings, std::size_t at, std::vector<Node>& nodes) {
  Builder(references.subspan(part.begin, part.size()), part.begin, settings, measure_for(part.box),
          nodes)
      .build(at, part.size(), part.box);
}

}  // namespace graze::bvh
