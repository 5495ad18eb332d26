#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <algorithm>

#include <tests/benchmark/error/baselines/guigue_devillers.h>
#include <tests/benchmark/triangles/block_answers.h>
#include <tests/benchmark/triangles/one_by_one.h>
#include <tests/benchmark/triangles/pair_contestants.h>
#include <tests/benchmark/triangles/pair_sets.h>
#include <tests/benchmark/triangles/triangle_columns.h>

namespace graze::benchmark {
namespace {

using oracle::TrianglePair;
using PairContestant = Contestant<TrianglePair>;

template <typename Answer>
std::unique_ptr<PairContestant> one_by_one(const char* name, Answer answer) {
  return std::make_unique<OneByOne<TrianglePair, Answer>>(name, answer);
}

bool is_hit(const TrianglePair& pair) {
  return intersects(pair.a, pair.b);
}

/// All pairs in one call, from rows of coordinates.
class Rows final : public PairContestant {
 public:
  std::string name() const override { return "graze, from rows"; }
  void prepare(const std::vector<TrianglePair>& pairs) override {
    pairs_ = &pairs;
    a_.assign(pairs, [](const TrianglePair& pair) { return pair.a; });
    b_.assign(pairs, [](const TrianglePair& pair) { return pair.b; });
    blocks_.resize((pairs.size() + kBlock - 1) / kBlock);
  }
  void answer(std::vector<std::uint8_t>& hits) override {
    narrowphase::triage(a_.rows(0, pairs_->size()), b_.rows(0, pairs_->size()), blocks_.data());
    finish(blocks_.data(), pairs_->data(), pairs_->size(), hits.data(), is_hit);
  }

 private:
  const std::vector<TrianglePair>* pairs_ = nullptr;
  TriangleColumns a_;
  TriangleColumns b_;
  std::vector<narrowphase::Verdicts> blocks_;
};

/// Eight pairs at a time, whose rows lie together.
class FilledBatches final : public PairContestant {
 public:
  std::string name() const override { return "graze, in filled batches"; }
  void prepare(const std::vector<TrianglePair>& pairs) override {
    pairs_ = &pairs;
    batches_.assign((pairs.size() + kBlock - 1) / kBlock, {});
    blocks_.resize(batches_.size());
    for (std::size_t n = 0; n < pairs.size(); ++n)
      batches_[n / kBlock].add(pairs[n].a, pairs[n].b);
  }
  void answer(std::vector<std::uint8_t>& hits) override {
    for (std::size_t i = 0; i < batches_.size(); ++i)
      blocks_[i] = narrowphase::triage(batches_[i]);
    finish(blocks_.data(), pairs_->data(), pairs_->size(), hits.data(), is_hit);
  }

 private:
  const std::vector<TrianglePair>* pairs_ = nullptr;
  std::vector<narrowphase::TrianglePairBatch> batches_;
  std::vector<narrowphase::Verdicts> blocks_;
};

/// Eight pairs at a time, which are put into rows first.
class Batches final : public PairContestant {
 public:
  std::string name() const override { return "graze, in batches, filling them included"; }
  void prepare(const std::vector<TrianglePair>& pairs) override { pairs_ = &pairs; }
  void answer(std::vector<std::uint8_t>& hits) override {
    narrowphase::TrianglePairBatch batch;
    for (std::size_t first = 0; first < pairs_->size(); first += kBlock) {
      const std::size_t count = std::min(kBlock, pairs_->size() - first);
      batch.clear();
      for (std::size_t i = 0; i < count; ++i)
        batch.add((*pairs_)[first + i].a, (*pairs_)[first + i].b);
      const narrowphase::Verdicts block = narrowphase::triage(batch);
      finish(&block, &(*pairs_)[first], count, &hits[first], is_hit);
    }
  }

 private:
  const std::vector<TrianglePair>* pairs_ = nullptr;
};

/// Runs of pairs that have the first triangle in common, one call for each.
class OneAgainstMany final : public PairContestant {
 public:
  std::string name() const override { return "graze, one against many"; }
  void prepare(const std::vector<TrianglePair>& pairs) override {
    pairs_ = &pairs;
    b_.assign(pairs, [](const TrianglePair& pair) { return pair.b; });
    blocks_.resize((pairs.size() + kBlock - 1) / kBlock);
  }
  void answer(std::vector<std::uint8_t>& hits) override {
    for (std::size_t first = 0; first < pairs_->size(); first += kGroup) {
      const std::size_t count = std::min(kGroup, pairs_->size() - first);
      narrowphase::triage((*pairs_)[first].a, b_.rows(first, count), &blocks_[first / kBlock]);
    }
    finish(blocks_.data(), pairs_->data(), pairs_->size(), hits.data(), is_hit);
  }

 private:
  const std::vector<TrianglePair>* pairs_ = nullptr;
  TriangleColumns b_;
  std::vector<narrowphase::Verdicts> blocks_;
};

}  // namespace

std::vector<std::unique_ptr<PairContestant>> pair_contestants(const std::string& set) {
  std::vector<std::unique_ptr<PairContestant>> all;
  all.push_back(one_by_one("Guigue-Devillers, plain double", [](const TrianglePair& pair) {
    return guigue_devillers(corners_of(pair.a), corners_of(pair.b), NoSnap{});
  }));
  all.push_back(
      one_by_one("graze", [](const TrianglePair& pair) { return intersects(pair.a, pair.b); }));
  all.push_back(one_by_one("graze, exact stage alone", [](const TrianglePair& pair) {
    return narrowphase::intersects_exactly(pair.a, pair.b);
  }));
  all.push_back(std::make_unique<Rows>());
  all.push_back(std::make_unique<FilledBatches>());
  all.push_back(std::make_unique<Batches>());
  if (set.find("one against many") != std::string::npos) {
    all.push_back(std::make_unique<OneAgainstMany>());
  }
  return all;
}

Truth truth_of(const std::vector<TrianglePair>& pairs) {
  Truth truth;
  for (const TrianglePair& pair : pairs) {
    truth.hits.push_back(narrowphase::intersects_exactly(pair.a, pair.b));
    truth.exact += narrowphase::decide(pair.a, pair.b).stage == narrowphase::Stage::Exact;
  }
  return truth;
}

}  // namespace graze::benchmark
