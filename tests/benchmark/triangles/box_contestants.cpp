#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_batch.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>

#include <algorithm>

#include <tests/benchmark/error/baselines/akenine_moeller.h>
#include <tests/benchmark/triangles/block_answers.h>
#include <tests/benchmark/triangles/box_contestants.h>
#include <tests/benchmark/triangles/columns.h>
#include <tests/benchmark/triangles/one_by_one.h>
#include <tests/benchmark/triangles/pair_sets.h>
#include <tests/benchmark/triangles/triangle_columns.h>

namespace graze::benchmark {
namespace {

using oracle::TriangleAndBox;
using BoxContestant = Contestant<TriangleAndBox>;

template <typename Answer>
std::unique_ptr<BoxContestant> one_by_one(const char* name, Answer answer) {
  return std::make_unique<OneByOne<TriangleAndBox, Answer>>(name, answer);
}

bool is_hit(const TriangleAndBox& element) {
  return intersects(element.triangle, element.box);
}

/// All elements in one call, or runs that have the triangle or the box in common in one call each,
/// from rows of coordinates.
class Rows final : public BoxContestant {
 public:
  enum class Common { Nothing, Triangle, Box };

  explicit Rows(Common common) : common_(common) {}

  std::string name() const override {
    if (common_ == Common::Nothing) return "graze, from rows";
    return common_ == Common::Box ? "graze, one box" : "graze, one triangle";
  }
  void prepare(const std::vector<TriangleAndBox>& elements) override {
    elements_ = &elements;
    triangles_.assign(elements, [](const TriangleAndBox& element) { return element.triangle; });
    boxes_.assign(elements, 6, [](const TriangleAndBox& element, double* numbers) {
      for (int k = 0; k < 3; ++k) {
        numbers[k] = element.box.min.data()[k];
        numbers[k + 3] = element.box.max.data()[k];
      }
    });
    blocks_.resize((elements.size() + kBlock - 1) / kBlock);
  }
  void answer(std::vector<std::uint8_t>& hits) override {
    const std::size_t run = common_ == Common::Nothing ? elements_->size() : kGroup;
    for (std::size_t first = 0; first < elements_->size(); first += run)
      triage(first, std::min(run, elements_->size() - first));
    finish(blocks_.data(), elements_->data(), elements_->size(), hits.data(), is_hit);
  }

 private:
  void triage(std::size_t first, std::size_t count) {
    const TriangleAndBox& element = (*elements_)[first];
    narrowphase::AabbRows boxes{{}, count};
    for (std::size_t i = 0; i < 6; ++i)
      boxes.row[i] = boxes_.row(i) + first;
    narrowphase::Verdicts* blocks = &blocks_[first / kBlock];
    switch (common_) {
      case Common::Nothing:
        return narrowphase::triage(triangles_.rows(first, count), boxes, blocks);
      case Common::Triangle:
        return narrowphase::triage(element.triangle, boxes, blocks);
      case Common::Box:
        return narrowphase::triage(element.box, triangles_.rows(first, count), blocks);
    }
  }

  Common common_;
  const std::vector<TriangleAndBox>* elements_ = nullptr;
  TriangleColumns triangles_;
  Columns boxes_;
  std::vector<narrowphase::Verdicts> blocks_;
};

}  // namespace

std::vector<std::unique_ptr<BoxContestant>> box_contestants(const std::string& set) {
  std::vector<std::unique_ptr<BoxContestant>> all;
  all.push_back(one_by_one("Akenine-Möller, plain double", [](const TriangleAndBox& element) {
    return akenine_moeller(corners_of(element.triangle), element.box.min.data(),
                           element.box.max.data(), NoSnap{});
  }));
  all.push_back(one_by_one("graze", [](const TriangleAndBox& element) {
    return intersects(element.triangle, element.box);
  }));
  all.push_back(one_by_one("graze, exact stage alone", [](const TriangleAndBox& element) {
    return narrowphase::intersects_exactly(element.triangle, element.box);
  }));
  all.push_back(std::make_unique<Rows>(Rows::Common::Nothing));
  if (set.find("one triangle") != std::string::npos) {
    all.push_back(std::make_unique<Rows>(Rows::Common::Triangle));
  }
  if (set.find("one box") != std::string::npos) {
    all.push_back(std::make_unique<Rows>(Rows::Common::Box));
  }
  return all;
}

Truth truth_of(const std::vector<TriangleAndBox>& elements) {
  Truth truth;
  for (const TriangleAndBox& element : elements) {
    truth.hits.push_back(narrowphase::intersects_exactly(element.triangle, element.box));
    truth.exact +=
        narrowphase::decide(element.triangle, element.box).stage == narrowphase::Stage::Exact;
  }
  return truth;
}

}  // namespace graze::benchmark
