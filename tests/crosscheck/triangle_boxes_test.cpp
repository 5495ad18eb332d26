#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <tests/crosscheck/corpus_run.h>
#include <tests/crosscheck/permutations.h>
#include <tests/oracle/case_text.h>

// Law 3 and law 4 for a triangle and an axis-aligned box: the library against the referee.

namespace graze::crosscheck {
namespace {

using oracle::TriangleAndBox;

bool all_orders_say(const TriangleAndBox& pair, bool truth) {
  for (const Triangle& triangle : permutations(pair.triangle)) {
    if (intersects(triangle, pair.box) != truth) return false;
  }
  return true;
}

// The pair mirrored at the origin has the same answer.
TriangleAndBox mirrored(const TriangleAndBox& pair) {
  const Triangle& t = pair.triangle;
  return {{-t.a, -t.b, -t.c}, {-pair.box.max, -pair.box.min}};
}

std::string fault_of(const TriangleAndBox& pair) {
  const bool truth = compare::referee_intersects(pair.triangle, pair.box);
  const char* fault = nullptr;
  if (intersects(pair.triangle, pair.box) != truth) {
    fault = "law 3: wrong";
  } else if (is_sure_and_wrong(narrowphase::triage(pair.triangle, pair.box), truth)) {
    fault = "law 6: the triage is sure and wrong";
  } else if (narrowphase::intersects_exactly(pair.triangle, pair.box) != truth) {
    fault = "law 3: the exact stage is wrong";
  } else if (!all_orders_say(pair, truth)) {
    fault = "law 4: another order of the vertices is wrong";
  } else if (!all_orders_say(mirrored(pair), truth)) {
    fault = "law 3: the mirror image is wrong";
  }
  return fault == nullptr ? "" : std::string(fault) + "; the truth is:\n" + to_text(pair, truth);
}

class Law3TriangleBoxes : public testing::TestWithParam<oracle::Corpus<TriangleAndBox>> {};
class Law3TriangleBoxesSlow : public Law3TriangleBoxes {};

TEST_P(Law3TriangleBoxes, AgreeWithReferee) {
  run_corpus(GetParam(), kElements, fault_of);
}
TEST_P(Law3TriangleBoxesSlow, AgreeWithReferee) {
  run_corpus(GetParam(), kElementsSlow, fault_of);
}

INSTANTIATE_TEST_SUITE_P(Crosscheck, Law3TriangleBoxes, testing::ValuesIn(oracle::box_corpora()),
                         CorpusName());
INSTANTIATE_TEST_SUITE_P(Crosscheck, Law3TriangleBoxesSlow,
                         testing::ValuesIn(oracle::box_corpora()), CorpusName());

}  // namespace
}  // namespace graze::crosscheck
