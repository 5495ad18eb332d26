#pragma once

#include <graze/narrowphase/predicates/verdict.h>
#include <gtest/gtest.h>

#include <exception>
#include <ostream>
#include <string>

#include <tests/oracle/category.h>

namespace graze::oracle {

/// What GoogleTest prints for a parameter.
template <typename Element>
void PrintTo(const Corpus<Element>& corpus, std::ostream* stream) {
  *stream << corpus.name();
}

}  // namespace graze::oracle

namespace graze::crosscheck {

inline constexpr int kElements = 2000;
inline constexpr int kElementsSlow = 100000;

/// Names a parameterised test after its corpus.
struct CorpusName {
  template <typename Element>
  std::string operator()(const testing::TestParamInfo<oracle::Corpus<Element>>& info) const {
    return info.param.name();
  }
};

/// True if the verdict claims what is not so.
inline bool is_sure_and_wrong(narrowphase::Verdict verdict, bool truth) {
  return verdict == (truth ? narrowphase::Verdict::No : narrowphase::Verdict::Yes);
}

/// Calls fault_of(element), which returns the first thing that is wrong with it or an empty text,
/// for `count` elements; the first fault ends the run.
template <typename Element, typename FaultOf>
void run_corpus(const oracle::Corpus<Element>& corpus, int count, FaultOf fault_of) {
  for (int index = 0; index < count; ++index) {
    const Element element = corpus.element(static_cast<std::uint64_t>(index));
    std::string fault;
    try {
      fault = fault_of(element);
    } catch (const std::exception& error) {
      fault = std::string("threw: ") + error.what();
    }
    ASSERT_EQ(fault, "") << corpus.name() << " element " << index;
  }
}

}  // namespace graze::crosscheck
