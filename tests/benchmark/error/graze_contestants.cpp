#include "tests/benchmark/error/graze_contestants.h"

#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_triangle.h>

namespace graze::benchmark {
namespace {

Label exact(const char* name) {
  return {name, Origin::Graze, "exact", std::nullopt};
}

Label rounded(const char* name) {
  return {name, Origin::Graze, "double", std::nullopt};
}

/// As queries of meshes do it: eight pairs at a time, and one by one what is left of them. Filling
/// the batch counts.
class InBatches final : public Contestant<TrianglePair> {
 public:
  InBatches() : Contestant(exact("graze, batches of 8")) {}

  void prepare(std::span<const TrianglePair> pairs) override { pairs_ = pairs; }
  void release() override { pairs_ = {}; }
  void warm(std::size_t first, std::size_t count) const override {
    touch(pairs_.subspan(first, count));
  }
  void answer(std::size_t first, std::span<Answer> answers) override {
    for (std::size_t done = 0; done < answers.size();) {
      batch_.clear();
      while (!batch_.is_full() && done + batch_.size() < answers.size()) {
        const TrianglePair& pair = pairs_[first + done + batch_.size()];
        batch_.add(pair.a, pair.b);
      }
      const std::uint32_t apart = narrowphase::find_apart(batch_);
      for (std::size_t i = 0; i < batch_.size(); ++i, ++done) {
        const TrianglePair& pair = pairs_[first + done];
        answers[done] =
            to_answer((apart >> i & 1) == 0 && narrowphase::decide(pair.a, pair.b).is_hit);
      }
    }
  }

 private:
  std::span<const TrianglePair> pairs_;
  narrowphase::TrianglePairBatch batch_;
};

constexpr auto kAsItIs = [](const auto& element) { return element; };

}  // namespace

void add_graze(Field& field) {
  add(field.triangle_pairs, exact("graze"), kAsItIs,
      [](const TrianglePair& pair) { return intersects(pair.a, pair.b); });
  add(field.triangle_pairs, rounded("graze, triage alone"), kAsItIs,
      [](const TrianglePair& pair) { return narrowphase::triage(pair.a, pair.b); });
  field.triangle_pairs.push_back(std::make_unique<InBatches>());
  add(field.triangle_boxes, exact("graze"), kAsItIs,
      [](const TriangleAndBox& pair) { return intersects(pair.triangle, pair.box); });
  add(field.triangle_boxes, rounded("graze, triage alone"), kAsItIs,
      [](const TriangleAndBox& pair) { return narrowphase::triage(pair.triangle, pair.box); });
}

}  // namespace graze::benchmark
