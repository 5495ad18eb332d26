#include "tests/benchmark/error/categories.h"

#include <graze/bvh/error.h>
#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <tests/oracle/case_text.h>
#include <tests/oracle/category.h>

#include <algorithm>

namespace graze::benchmark {
namespace {

bool exactly(const TrianglePair& pair) {
  return narrowphase::intersects_exactly(pair.a, pair.b);
}
bool exactly(const TriangleAndBox& pair) {
  return narrowphase::intersects_exactly(pair.triangle, pair.box);
}
bool by_referee(const TrianglePair& pair) {
  return compare::referee_intersects(pair.a, pair.b);
}
bool by_referee(const TriangleAndBox& pair) {
  return compare::referee_intersects(pair.triangle, pair.box);
}

template <typename Element>
Category<Element> drawn(const oracle::Corpus<Element>& corpus, const Sizes& sizes) {
  Category<Element> category{corpus.name(),
                             corpus.name().starts_with("random"),
                             corpus.grid == oracle::Grid::Float,
                             {},
                             {},
                             0};
  const std::size_t step =
      std::max<std::size_t>(1, sizes.elements / std::max<std::size_t>(1, sizes.refereed));
  for (std::size_t i = 0; i < sizes.elements; ++i) {
    const Element element = corpus.element(i);
    const bool truth = exactly(element);
    if (i % step == 0) {
      ++category.refereed;
      if (by_referee(element) != truth)
        throw Error("the exact stage is wrong: " + oracle::to_text(element, !truth));
    }
    category.elements.push_back(element);
    category.truth.push_back(truth);
  }
  return category;
}

}  // namespace

std::size_t pair_category_count() {
  return oracle::pair_corpora().size();
}

std::size_t box_category_count() {
  return oracle::box_corpora().size();
}

Category<TrianglePair> pair_category(std::size_t index, const Sizes& sizes) {
  return drawn(oracle::pair_corpora()[index], sizes);
}

Category<TriangleAndBox> box_category(std::size_t index, const Sizes& sizes) {
  return drawn(oracle::box_corpora()[index], sizes);
}

}  // namespace graze::benchmark
