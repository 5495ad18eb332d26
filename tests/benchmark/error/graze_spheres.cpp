#include <graze/narrowphase/volumes/sphere_batch.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/spheres/sphere_stages.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "tests/benchmark/error/graze_parts.h"

namespace graze::benchmark {
namespace {

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
    intersects(part_of(a_, first, answers.size()), part_of(b_, first, answers.size()),
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
    intersects(part_of(spheres_, first, size), boxes, as_hits(answers));
  }

 private:
  SphereColumns spheres_;
  NumberColumns<6> boxes_;
};

constexpr auto kAsItIs = [](const auto& element) { return element; };

}  // namespace

void add_graze_spheres(Field& field) {
  add(field.sphere_boxes, exact("graze"), kAsItIs,
      [](const SphereAndBox& pair) { return intersects(pair.sphere, pair.box); });
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
      [](const SpherePair& pair) { return intersects(pair.a, pair.b); });
  field.sphere_pairs.push_back(std::make_unique<SpheresInArrays>());
}

}  // namespace graze::benchmark
