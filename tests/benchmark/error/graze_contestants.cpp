#include "tests/benchmark/error/graze_contestants.h"

#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box_batch.h>
#include <graze/narrowphase/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <graze/narrowphase/volumes/sphere_batch.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>

#include <tests/benchmark/triangles/block_answers.h>
#include <tests/benchmark/triangles/triangle_columns.h>

#include <array>

#include "tests/benchmark/error/contest.h"

namespace graze::benchmark {
namespace {

Label exact(const char* name) {
  return {name, Origin::Graze, "exact", std::nullopt};
}

Label rounded(const char* name) {
  return {name, Origin::Graze, "double", std::nullopt};
}

/// The batch functions answer with bytes, which an Answer is; 1 is Touching.
std::span<std::uint8_t> as_hits(std::span<Answer> answers) {
  static_assert(static_cast<std::uint8_t>(Answer::Touching) == 1);
  return {reinterpret_cast<std::uint8_t*>(answers.data()), answers.size()};
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

/// Arrays of numbers, one for each of the `count` columns.
template <std::size_t count>
class NumberColumns {
 public:
  void clear() {
    for (std::vector<double>& column : columns_)
      column = {};
  }
  void push_back(const std::array<double, count>& row) {
    for (std::size_t i = 0; i < count; ++i)
      columns_[i].push_back(row[i]);
  }
  std::span<const double> part(std::size_t column, std::size_t first, std::size_t size) const {
    return std::span(columns_[column]).subspan(first, size);
  }
  void warm(std::size_t first, std::size_t size) const {
    for (std::size_t i = 0; i < count; ++i)
      touch(part(i, first, size));
  }

 private:
  std::array<std::vector<double>, count> columns_;
};

using SphereColumns = NumberColumns<4>;

std::array<double, 4> row_of(const Sphere& sphere) {
  return {sphere.centre.x(), sphere.centre.y(), sphere.centre.z(), sphere.radius};
}

SphereArray part_of(const SphereColumns& columns, std::size_t first, std::size_t size) {
  return {columns.part(0, first, size), columns.part(1, first, size), columns.part(2, first, size),
          columns.part(3, first, size)};
}

class SpheresInArrays final : public Contestant<SpherePair> {
 public:
  SpheresInArrays() : Contestant(exact("graze, arrays")) {}

  void prepare(std::span<const SpherePair> pairs) override {
    release();
    for (const SpherePair& pair : pairs) {
      a_.push_back(row_of(pair.a));
      b_.push_back(row_of(pair.b));
    }
  }
  void release() override {
    a_.clear();
    b_.clear();
  }
  void warm(std::size_t first, std::size_t count) const override {
    a_.warm(first, count);
    b_.warm(first, count);
  }
  void answer(std::size_t first, std::span<Answer> answers) override {
    overlaps(part_of(a_, first, answers.size()), part_of(b_, first, answers.size()),
             as_hits(answers));
  }

 private:
  SphereColumns a_;
  SphereColumns b_;
};

class SpheresAndBoxesInArrays final : public Contestant<SphereAndBox> {
 public:
  SpheresAndBoxesInArrays() : Contestant(exact("graze, arrays")) {}

  void prepare(std::span<const SphereAndBox> pairs) override {
    release();
    for (const SphereAndBox& pair : pairs) {
      const double* low = pair.box.min.data();
      const double* high = pair.box.max.data();
      spheres_.push_back(row_of(pair.sphere));
      boxes_.push_back({low[0], low[1], low[2], high[0], high[1], high[2]});
    }
  }
  void release() override {
    spheres_.clear();
    boxes_.clear();
  }
  void warm(std::size_t first, std::size_t count) const override {
    spheres_.warm(first, count);
    boxes_.warm(first, count);
  }
  void answer(std::size_t first, std::span<Answer> answers) override {
    const std::size_t size = answers.size();
    const auto part = [&](std::size_t column) { return boxes_.part(column, first, size); };
    const AabbArray boxes{{part(0), part(1), part(2)}, {part(3), part(4), part(5)}};
    overlaps(part_of(spheres_, first, size), boxes, as_hits(answers));
  }

 private:
  SphereColumns spheres_;
  NumberColumns<6> boxes_;
};

constexpr auto kAsItIs = [](const auto& element) { return element; };

void add_sphere_tests(Field& field) {
  add(field.sphere_boxes, exact("graze"), kAsItIs,
      [](const SphereAndBox& pair) { return overlaps(pair.sphere, pair.box); });
  add(field.sphere_boxes, exact("graze, Arvo"), kAsItIs, [](const SphereAndBox& pair) {
    return narrowphase::decide_arvo(pair.sphere, pair.box).is_hit;
  });
  add(field.sphere_boxes, exact("graze, quick rejections"), kAsItIs, [](const SphereAndBox& pair) {
    return narrowphase::decide_quick_rejections(pair.sphere, pair.box).is_hit;
  });
  add(field.sphere_boxes, exact("graze, branch-free"), kAsItIs, [](const SphereAndBox& pair) {
    return narrowphase::decide_branch_free(pair.sphere, pair.box).is_hit;
  });
  field.sphere_boxes.push_back(std::make_unique<SpheresAndBoxesInArrays>());
  add(field.sphere_pairs, exact("graze"), kAsItIs,
      [](const SpherePair& pair) { return overlaps(pair.a, pair.b); });
  field.sphere_pairs.push_back(std::make_unique<SpheresInArrays>());
}

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
  add_sphere_tests(field);
  add_graze_meshes(field.meshes);
}

}  // namespace graze::benchmark
