#include <graze/narrowphase/triangle_box.h>

#include <tests/benchmark/triangles/box_contestants.h>
#include <tests/benchmark/triangles/one_by_one.h>
#include <tests/benchmark/triangles/plain_box_test.h>

namespace graze::benchmark {
namespace {

using oracle::TriangleAndBox;
using BoxContestant = Contestant<TriangleAndBox>;

template <typename Answer>
std::unique_ptr<BoxContestant> one_by_one(const char* name, Answer answer) {
  return std::make_unique<OneByOne<TriangleAndBox, Answer>>(name, answer);
}

}  // namespace

std::vector<std::unique_ptr<BoxContestant>> box_contestants() {
  std::vector<std::unique_ptr<BoxContestant>> all;
  all.push_back(one_by_one("Akenine-Möller, plain double", [](const TriangleAndBox& element) {
    return plain_box_test(element.triangle, element.box);
  }));
  all.push_back(one_by_one("graze", [](const TriangleAndBox& element) {
    return intersects(element.triangle, element.box);
  }));
  all.push_back(one_by_one("graze, exact stage alone", [](const TriangleAndBox& element) {
    return narrowphase::intersects_exactly(element.triangle, element.box);
  }));
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
