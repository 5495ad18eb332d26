#include <graze/engine/compare/judge/motions/motion_judge.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace graze::compare {
namespace {

/// Returns a number with all digits that tell a double from its neighbours.
std::string text_of(double value) {
  std::array<char, 32> text;
  const std::to_chars_result end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

/// Returns a number with digits enough for a difference of times.
std::string brief_text(double value) {
  std::array<char, 32> text;
  const std::to_chars_result end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3);
  return {text.data(), end.ptr};
}

Judgement right(std::string truth) {
  Judgement judgement;
  judgement.verdict = Verdict::Right;
  judgement.truth = std::move(truth);
  return judgement;
}

Judgement not_judged(const std::string& known, const std::string& what) {
  Judgement judgement;
  judgement.truth = known + "; not judged: " + what;
  return judgement;
}

}  // namespace

/// Says in words what the library found, where a proof of it may be missing.
std::string MotionJudge::known() const {
  const RigidContact& found = proofs_.proposed();
  if (found.status == RigidStatus::Free) return "free";
  return std::string(found.status == RigidStatus::Hit ? "hit" : "close") + " from " +
         text_of(found.low) + " on";
}

/// Returns a wrong verdict, as large as the deepest contact that was overlooked between two times.
Judgement MotionJudge::overlooked(const std::string& cause, double from, double to) const {
  Judgement judgement = proofs_.judge_missed(from, to).value_or(proofs_.judge_at(from, false));
  judgement.verdict = Verdict::Wrong;
  judgement.truth = "hit at " + text_of(from) + ": " + cause;
  return judgement;
}

/// Returns a wrong verdict, as large as the gap at the time at which there should be a contact.
Judgement MotionJudge::invented(const std::string& truth, double time) const {
  Judgement judgement = proofs_.judge_at(time, true);
  const bool is_sized = judgement.verdict == Verdict::Wrong;
  if (!is_sized) judgement = {};
  judgement.verdict = Verdict::Wrong;
  judgement.truth = truth;
  return judgement;
}

/// True if the poses at which FCL looks by default, the ends among them, are all proved apart: an
/// engine that samples there cannot see the contact.
bool MotionJudge::is_sampled_over() const {
  constexpr int kPoses = 10;
  for (int i = 0; i < kPoses; ++i)
    if (!proofs_.is_apart(static_cast<double>(i) / (kPoses - 1))) return false;
  return true;
}

Judgement MotionJudge::judge_free() {
  if (const std::optional<double> time = proofs_.contact()) {
    return overlooked(
        is_sampled_over() ? "missed, sampled over: ten even poses are apart" : "missed", *time, 1);
  }
  if (proofs_.is_free()) return right("free");
  return not_judged(known(), "whether they stay apart");
}

Judgement MotionJudge::judge_not_free(bool is_graze) {
  if (const std::optional<double> time = proofs_.contact())
    return right("hit at " + text_of(*time));
  if (proofs_.is_free()) return invented("free: \"hit\" of a free motion", proofs_.nearest_time());
  // It promises to say no of two that come so near, too.
  if (is_graze && proofs_.is_near(proofs_.proposed().low)) return right(known());
  return not_judged(known(), "whether they meet");
}

Judgement MotionJudge::judge_hit(double low, double high, bool is_graze) {
  if (proofs_.is_free()) return invented("free: \"hit\" of a free motion", high);
  const double granted = is_graze ? 0 : kTimeTolerance;
  const double free_until = proofs_.proposed().low;
  const bool is_early = high + granted < free_until && proofs_.is_free_until(free_until);
  if (is_early) {
    return invented(
        "free until " + text_of(free_until) + ": early by " + brief_text(free_until - high), high);
  }
  const std::optional<double> contact = proofs_.contact();
  if (contact && *contact < low - granted)
    return overlooked("late by " + brief_text(low - *contact), *contact, low);
  const bool is_witness = proofs_.is_contact(high);
  if (is_graze && !is_witness && proofs_.is_apart(high))
    return invented(known() + ": no contact at " + text_of(high), high);
  if (!is_witness && (is_graze || !contact || *contact > high + granted))
    return not_judged(known(), "whether they meet so early");
  const double before = std::min(std::max(low - granted, 0.0), free_until);
  const bool is_free_before =
      low - granted <= free_until && (before == 0 || proofs_.is_free_until(before));
  if (!is_free_before) return not_judged(known(), "whether they stay apart until then");
  return right(known());
}

Judgement MotionJudge::judge_close(double low) {
  if (proofs_.is_free()) return invented("free: \"close\" of a free motion", low);
  const std::optional<double> contact = proofs_.contact();
  if (contact && *contact < low)
    return overlooked("late by " + brief_text(low - *contact), *contact, low);
  if (low > 0 && !proofs_.is_free_until(low))
    return not_judged(known(), "whether they stay apart until then");
  if (!proofs_.is_near(low)) return not_judged(known(), "how near they come");
  return right(known());
}

Judgement MotionJudge::judge(const CaseAnswer& answer, bool is_graze) {
  if (query_.ask == Ask::Free) return *answer.says ? judge_free() : judge_not_free(is_graze);
  switch (*answer.status) {
    case RigidStatus::Free:
      return judge_free();
    case RigidStatus::Hit:
      return judge_hit(*answer.low, *answer.high, is_graze);
    case RigidStatus::Close:
      return judge_close(*answer.low);
  }
  return {};
}

}  // namespace graze::compare
