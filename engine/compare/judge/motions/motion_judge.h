#pragma once

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/judge/motions/motion_proofs.h>

namespace graze::compare {

/// This much of the time from 0 to 1 is granted to engines other than graze, whose times are no
/// bounds: FCL's conservative advancement stops where it would go on by 1e-4. A millimetre of
/// Bullet's is more where a motion is short.
inline constexpr double kTimeTolerance = 0x1p-10;

/// Holds what is true of two things in motion, and judges what answers say of it: README.md of
/// judge/ says what is right and wrong. Many threads may ask it.
class MotionJudge {
 public:
  /// Keeps the case, which must outlive it.
  explicit MotionJudge(const Case& query) : query_(query), proofs_(query) {}

  Judgement judge(const CaseAnswer& answer, bool is_graze);

 private:
  Judgement judge_free();
  Judgement judge_not_free(bool is_graze);
  Judgement judge_hit(double low, double high, bool is_graze);
  Judgement judge_close(double low);
  bool is_sampled_over() const;
  Judgement overlooked(const std::string& cause, double from, double to) const;
  Judgement invented(const std::string& truth, double time) const;
  std::string known() const;

  const Case& query_;
  MotionProofs proofs_;
};

}  // namespace graze::compare
