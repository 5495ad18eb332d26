// What the judge says of answers beyond yes, no and complete lists: lists that a limit cuts,
// translations that separate, and intersections.

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <gtest/gtest.h>

#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

/// Two cubes half a metre deep in each other along x.
class JudgeAnswers : public testing::Test {
 protected:
  JudgeAnswers() { pose_.translation().x() = 1.5; }

  Case asking(Ask ask, const CaseSettings& settings = {}) const {
    Case query = to_case({cube_}, {cube_, pose_}, true);
    query.ask = ask;
    query.settings = settings;
    query.answer.reset();
    return query;
  }
  static Judgement judged(const Case& query, const CaseAnswer& answer) {
    return Judge(query).judge(answer, {"somebody", ""});
  }

  Mesh cube_ = tests::make_box({1, 1, 1});
  Pose pose_ = Pose::Identity();
};

TEST_F(JudgeAnswers, AnyTruePairsFillALimit) {
  const std::vector<TrianglePair> all = find_triangle_pairs({cube_}, {cube_, pose_}).pairs;
  ASSERT_GT(all.size(), 4u);
  const Case two = asking(Ask::Pairs, {.limit = 2});
  const auto verdict = [](const Case& query, const std::vector<TrianglePair>& pairs) {
    CaseAnswer answer;
    answer.pairs = pairs;
    return judged(query, answer);
  };
  EXPECT_EQ(verdict(two, {all[0], all[1]}).verdict, Verdict::Right);
  EXPECT_EQ(verdict(two, {all[2], all.back()}).verdict, Verdict::Right);
  EXPECT_EQ(verdict(two, {all[2], all.back()}).truth,
            "2 of " + std::to_string(all.size()) + " pairs");
  EXPECT_EQ(verdict(two, {all[0]}).verdict, Verdict::Wrong) << "there are more";
  EXPECT_EQ(verdict(two, {all[0], all[1], all[2]}).verdict, Verdict::Wrong) << "beyond the limit";
  TrianglePair apart{0, 0};
  while (std::binary_search(all.begin(), all.end(), apart))
    ++apart.b;
  std::vector<TrianglePair> with_false_one = {all.back(), apart};
  std::sort(with_false_one.begin(), with_false_one.end());
  const Judgement wrong = verdict(two, with_false_one);
  EXPECT_EQ(wrong.verdict, Verdict::Wrong);
  EXPECT_EQ(wrong.wrong_pairs, 1u);
  EXPECT_EQ(wrong.culprit, apart);
  EXPECT_GT(wrong.error, 0);
  const Case many = asking(Ask::Pairs, {.limit = 100000});
  EXPECT_EQ(verdict(many, all).verdict, Verdict::Right);
  EXPECT_EQ(judged(two, answer_case(two)).verdict, Verdict::Right);
}

TEST_F(JudgeAnswers, ATranslationMustSeparate) {
  const Case query = asking(Ask::Separation);
  const auto verdict = [&](const Eigen::Vector3d& translation) {
    CaseAnswer answer;
    answer.distance = translation.stableNorm();
    answer.translation = translation;
    return judged(query, answer);
  };
  EXPECT_EQ(verdict({0.5 + 0x1p-50, 0, 0}).verdict, Verdict::Right);
  EXPECT_EQ(verdict({0.75, 0, 0}).verdict, Verdict::NotJudged) << "more than is needed";
  EXPECT_EQ(verdict({0.75, 0, 0}).truth, "apart after it; not judged: its length");
  EXPECT_EQ(verdict({0.5, 0, 0}).verdict, Verdict::Wrong) << "they touch";
  EXPECT_EQ(verdict({0.5, 0, 0}).error_class, ErrorClass::Coplanar) << "face on face";
  const Judgement deep = verdict({0.25, 0, 0});
  EXPECT_EQ(deep.verdict, Verdict::Wrong);
  EXPECT_EQ(deep.error_class, ErrorClass::Real);
  EXPECT_EQ(deep.error, 0.25);
  EXPECT_EQ(verdict({1.7e308, 0, 0}).truth, verdict({0.75, 0, 0}).truth) << "still within range";
  const Case graze = asking(Ask::Separation, {.direction = Eigen::Vector3d(0, 0, 3)});
  EXPECT_EQ(judged(graze, answer_case(graze)).verdict, Verdict::Right);
}

TEST_F(JudgeAnswers, ATranslationOutOfRangeIsNotJudged) {
  Case query = asking(Ask::Separation);
  std::get<CaseMesh>(*query.b).pose.translation().x() = 1e308;
  CaseAnswer answer;
  answer.distance = 1.7e308;
  answer.translation = Eigen::Vector3d(1.7e308, 0, 0);
  EXPECT_EQ(judged(query, answer).verdict, Verdict::NotJudged);
}

TEST_F(JudgeAnswers, AnIntersectionIsEmptyOrNot) {
  const Case query = asking(Ask::Intersection);
  const CaseAnswer found = answer_case(query);
  EXPECT_EQ(judged(query, found).verdict, Verdict::NotJudged);
  EXPECT_EQ(judged(query, found).truth, "hit; not judged: features, and how its parts are joined");
  CaseAnswer none;
  none.intersection.emplace();
  EXPECT_EQ(judged(query, none).verdict, Verdict::Wrong);
  EXPECT_EQ(judged(query, none).error, 0.5);
  Case apart = query;
  std::get<CaseMesh>(*apart.b).pose.translation().x() = 3;
  EXPECT_EQ(judged(apart, none).verdict, Verdict::Right);
  EXPECT_EQ(judged(apart, found).verdict, Verdict::Wrong);
}

TEST_F(JudgeAnswers, ADistanceBeyondTheLargestDoubleIsInfinite) {
  const Triangle low{{-1.7e308, -1.7e308, 0}, {-1.6e308, -1.7e308, 0}, {-1.7e308, -1.6e308, 0}};
  const Triangle high{{1.7e308, 1.7e308, 0}, {1.6e308, 1.7e308, 0}, {1.7e308, 1.6e308, 0}};
  const Case far = to_case(low, high, distance(low, high));
  EXPECT_EQ(Judge(far).judge(*far.answer, this_library()).verdict, Verdict::Right);
  CaseAnswer near = *far.answer;
  near.distance = 1;
  EXPECT_EQ(Judge(far).judge(near, this_library()).verdict, Verdict::Wrong);
}

}  // namespace
}  // namespace graze::compare
