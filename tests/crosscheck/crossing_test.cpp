#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <tests/crosscheck/corpus_run.h>
#include <tests/crosscheck/permutations.h>
#include <tests/crosscheck/rational_crossing.h>
#include <tests/oracle/case_text.h>

// crosses() against rationals on the corpora of hard pairs: lattices, shared vertices and edges,
// coplanar and degenerate pairs, extremes.

namespace graze::crosscheck {
namespace {

using oracle::TrianglePair;

bool all_orders_say(const TrianglePair& pair, bool truth) {
  for (const Triangle& a : permutations(pair.a)) {
    for (const Triangle& b : permutations(pair.b)) {
      if (crosses(a, b) != truth || crosses(b, a) != truth) return false;
    }
  }
  return true;
}

std::string fault_of(const TrianglePair& pair) {
  const bool truth = oracle::crosses_by_elimination(pair.a, pair.b);
  const char* fault = nullptr;
  if (crosses(pair.a, pair.b) != truth) {
    fault = "wrong";
  } else if (is_sure_and_wrong(narrowphase::crossing_triage(pair.a, pair.b), truth)) {
    fault = "law 6: the triage is sure and wrong";
  } else if (narrowphase::crosses_exactly(pair.a, pair.b) != truth) {
    fault = "the exact stage is wrong";
  } else if (narrowphase::decide_unsure(pair.a, pair.b, Touch::Exclude).is_hit != truth) {
    fault = "left unsure by a batch it would be wrong";
  } else if (truth && !intersects(pair.a, pair.b)) {
    fault = "they cross and do not intersect";
  } else if (!all_orders_say(pair, truth)) {
    fault = "law 4: another order of the arguments or vertices is wrong";
  }
  return fault == nullptr ? ""
                          : std::string(fault) + "; whether they cross:\n" + to_text(pair, truth);
}

class TouchPolicyPairs : public testing::TestWithParam<oracle::Corpus<TrianglePair>> {};
class TouchPolicyPairsSlow : public TouchPolicyPairs {};

TEST_P(TouchPolicyPairs, AgreeWithRationals) {
  run_corpus(GetParam(), 100, fault_of);
}
TEST_P(TouchPolicyPairsSlow, AgreeWithRationals) {
  run_corpus(GetParam(), 10000, fault_of);
}

INSTANTIATE_TEST_SUITE_P(Crosscheck, TouchPolicyPairs, testing::ValuesIn(oracle::pair_corpora()),
                         CorpusName());
INSTANTIATE_TEST_SUITE_P(Crosscheck, TouchPolicyPairsSlow,
                         testing::ValuesIn(oracle::pair_corpora()), CorpusName());

}  // namespace
}  // namespace graze::crosscheck
