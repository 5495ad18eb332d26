#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <tests/crosscheck/corpus_run.h>
#include <tests/crosscheck/permutations.h>
#include <tests/oracle/case_text.h>

// Law 2 and law 4 for triangle pairs: the library against the referee, no wrong answer allowed.

namespace graze::crosscheck {
namespace {

using oracle::TrianglePair;

// Law 4: 6 orders of A, 6 of B, and both orders of the two.
bool all_orders_say(const TrianglePair& pair, bool truth) {
  for (const Triangle& a : permutations(pair.a)) {
    for (const Triangle& b : permutations(pair.b)) {
      if (intersects(a, b) != truth || intersects(b, a) != truth) return false;
    }
  }
  return true;
}

std::string fault_of(const TrianglePair& pair) {
  const bool truth = compare::referee_intersects(pair.a, pair.b);
  const char* fault = nullptr;
  if (intersects(pair.a, pair.b) != truth) {
    fault = "law 2: wrong";
  } else if (is_sure_and_wrong(narrowphase::triage(pair.a, pair.b), truth)) {
    fault = "law 6: the triage is sure and wrong";
  } else if (narrowphase::intersects_exactly(pair.a, pair.b) != truth) {
    fault = "law 2: the exact stage is wrong";
  } else if (narrowphase::decide_unsure(pair.a, pair.b, Touch::Include).is_hit != truth) {
    fault = "law 2: left unsure by a batch it would be wrong";
  } else if (!all_orders_say(pair, truth)) {
    fault = "law 4: another order of the arguments or vertices is wrong";
  }
  return fault == nullptr ? "" : std::string(fault) + "; the truth is:\n" + to_text(pair, truth);
}

class Law2TrianglePairs : public testing::TestWithParam<oracle::Corpus<TrianglePair>> {};
class Law2TrianglePairsSlow : public Law2TrianglePairs {};

TEST_P(Law2TrianglePairs, AgreeWithReferee) {
  run_corpus(GetParam(), kElements, fault_of);
}
TEST_P(Law2TrianglePairsSlow, AgreeWithReferee) {
  run_corpus(GetParam(), kElementsSlow, fault_of);
}

INSTANTIATE_TEST_SUITE_P(Crosscheck, Law2TrianglePairs, testing::ValuesIn(oracle::pair_corpora()),
                         CorpusName());
INSTANTIATE_TEST_SUITE_P(Crosscheck, Law2TrianglePairsSlow,
                         testing::ValuesIn(oracle::pair_corpora()), CorpusName());

}  // namespace
}  // namespace graze::crosscheck
