#pragma once

#include <memory>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>

namespace graze::compare {

/// This is the referee for one query, and can judge many answers to it: by linear programs in
/// integers, rational numbers and proofs. README.md says which few formulas of the library it uses.
/// An answer is right only if every part of it was judged; README.md says for each question what is
/// judged, and with what tolerance. ShapeJudge judges two bodies, and what else is said of them is
/// looked at in the same way. A distance is right within law 7's four ulp if graze says so, and for
/// other engines, which promise nothing, within kTouchUlps of the largest coordinate. A negative
/// distance of theirs claims a touch, and is judged as that alone: NotJudged, unless it is -1 or,
/// for two convex shapes, the least depth.
class Judge {
 public:
  /// The case must outlive the judge.
  explicit Judge(const Case& query);
  ~Judge();
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;

  Judgement judge(const CaseAnswer& answer, const CaseWitness& witness) const;

 private:
  struct Truth;
  std::unique_ptr<Truth> truth_;
};

}  // namespace graze::compare
