#include "tests/benchmark/error/graze_contestants.h"

#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_batch.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <tests/benchmark/triangles/block_answers.h>
#include <tests/benchmark/triangles/triangle_columns.h>

#include "tests/benchmark/error/contest.h"
#include "tests/benchmark/error/graze_parts.h"

namespace graze::benchmark {
namespace {

Label rounded(const char* name) {
  return {name, Origin::Graze, "double", std::nullopt};
}

void touch_rows(const narrowphase::TriangleRows& rows) {
  for (const double* row : rows.row)
    touch(std::span(row, rows.size));
}

/// All pairs of a chunk in one call, from rows of coordinates; what the triage leaves unsure is
/// answered one by one.
class PairsInRows final : public Contestant<TrianglePair> {
 public:
  PairsInRows() : Contestant(exact("graze, from rows")) {}

  void prepare(std::span<const TrianglePair> pairs) override {
    pairs_ = pairs;
    a_.assign(pairs, [](const TrianglePair& pair) { return pair.a; });
    b_.assign(pairs, [](const TrianglePair& pair) { return pair.b; });
    blocks_.resize(kChunk / kBlock);
  }
  void release() override { pairs_ = {}; }
  void warm(std::size_t first, std::size_t count) const override {
    touch(pairs_.subspan(first, count));
    touch_rows(a_.rows(first, count));
    touch_rows(b_.rows(first, count));
  }
  void answer(std::size_t first, std::span<Answer> answers) override {
    const std::size_t size = answers.size();
    narrowphase::triage(a_.rows(first, size), b_.rows(first, size), blocks_.data());
    finish(blocks_.data(), &pairs_[first], size, as_hits(answers).data(),
           [](const TrianglePair& pair) { return intersects(pair.a, pair.b); });
  }

 private:
  std::span<const TrianglePair> pairs_;
  TriangleColumns a_;
  TriangleColumns b_;
  std::vector<narrowphase::Verdicts> blocks_;
};

/// Likewise for triangles and boxes.
class BoxesInRows final : public Contestant<TriangleAndBox> {
 public:
  BoxesInRows() : Contestant(exact("graze, from rows")) {}

  void prepare(std::span<const TriangleAndBox> pairs) override {
    pairs_ = pairs;
    triangles_.assign(pairs, [](const TriangleAndBox& pair) { return pair.triangle; });
    boxes_.assign(pairs, 6, [](const TriangleAndBox& pair, double* numbers) {
      for (int k = 0; k < 3; ++k) {
        numbers[k] = pair.box.min.data()[k];
        numbers[k + 3] = pair.box.max.data()[k];
      }
    });
    blocks_.resize(kChunk / kBlock);
  }
  void release() override { pairs_ = {}; }
  void warm(std::size_t first, std::size_t count) const override {
    touch(pairs_.subspan(first, count));
    touch_rows(triangles_.rows(first, count));
    for (std::size_t i = 0; i < 6; ++i)
      touch(std::span(boxes_.row(i) + first, count));
  }
  void answer(std::size_t first, std::span<Answer> answers) override {
    const std::size_t size = answers.size();
    narrowphase::AabbRows boxes{{}, size};
    for (std::size_t i = 0; i < 6; ++i)
      boxes.row[i] = boxes_.row(i) + first;
    narrowphase::triage(triangles_.rows(first, size), boxes, blocks_.data());
    finish(blocks_.data(), &pairs_[first], size, as_hits(answers).data(),
           [](const TriangleAndBox& pair) { return intersects(pair.triangle, pair.box); });
  }

 private:
  std::span<const TriangleAndBox> pairs_;
  TriangleColumns triangles_;
  Columns boxes_;
  std::vector<narrowphase::Verdicts> blocks_;
};

constexpr auto kAsItIs = [](const auto& element) { return element; };

}  // namespace

void add_graze(Field& field) {
  add(field.triangle_pairs, exact("graze"), kAsItIs,
      [](const TrianglePair& pair) { return intersects(pair.a, pair.b); });
  add(field.triangle_pairs, rounded("graze, triage alone"), kAsItIs,
      [](const TrianglePair& pair) { return narrowphase::triage(pair.a, pair.b); });
  field.triangle_pairs.push_back(std::make_unique<PairsInRows>());
  add(field.triangle_boxes, exact("graze"), kAsItIs,
      [](const TriangleAndBox& pair) { return intersects(pair.triangle, pair.box); });
  add(field.triangle_boxes, rounded("graze, triage alone"), kAsItIs,
      [](const TriangleAndBox& pair) { return narrowphase::triage(pair.triangle, pair.box); });
  field.triangle_boxes.push_back(std::make_unique<BoxesInRows>());
  add_graze_spheres(field);
  add_graze_volumes(field);
  add_graze_motions(field);
  add_graze_distances(field);
  add_graze_meshes(field.meshes);
}

}  // namespace graze::benchmark
