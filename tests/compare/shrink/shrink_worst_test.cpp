// Shrinking large meshes within its time: where it starts, what is kept meanwhile, when it ends.

#include <graze/engine/compare/judge/shrink/shrink.h>
#include <graze/engine/compare/run/shrink_worst.h>
#include <graze/engine/mesh/pair.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

using Seconds = std::chrono::duration<double>;

/// What an engine was asked, one number a question: the triangles of both meshes.
using Sizes = std::vector<std::size_t>;

/// Misses every hit of two meshes that each have so many triangles; of smaller ones it knows all.
class BlindToLarge : public Engine {
 public:
  BlindToLarge(std::size_t least, Seconds delay, Sizes& asked)
      : least_(least), delay_(delay), asked_(asked) {}

  CaseWitness name() const override { return {"blind", "1"}; }

  std::unique_ptr<LoadedPair> load(const Mesh& a, const Mesh& b) const override {
    class Loaded : public LoadedPair {
     public:
      Loaded(const BlindToLarge& engine, Mesh a, Mesh b)
          : engine_(engine), a_(std::move(a)), b_(std::move(b)) {}
      std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                       const Pose& pose_b) const override {
        if (question.ask != Ask::Any) return std::nullopt;
        std::this_thread::sleep_for(engine_.delay_);
        engine_.asked_.push_back(a_.triangles().size() + b_.triangles().size());
        const std::size_t least = std::min(a_.triangles().size(), b_.triangles().size());
        CaseAnswer answer;
        answer.says = least < engine_.least_ && intersects({a_, pose_a}, {b_, pose_b});
        return answer;
      }

     private:
      const BlindToLarge& engine_;
      Mesh a_;
      Mesh b_;
    };
    return std::make_unique<Loaded>(*this, a, b);
  }

 private:
  std::size_t least_;
  Seconds delay_;
  Sizes& asked_;
};

/// Two tori of 12,800 triangles each that go through each other, and two wrong answers about them.
class ShrinkWorst : public testing::Test {
 protected:
  ShrinkWorst() {
    pose_.translation() << 1, 0.125, 0.0625;
    answer_.engine = "blind";
    answer_.brief = "no";
    answer_.judgement.verdict = Verdict::Wrong;
    answer_.judgement.error_class = ErrorClass::Real;
    answer_.judgement.error = 1;  // metres: what would undo the hit is less
    const TrianglePairs hits = find_triangle_pairs({torus_}, {torus_, pose_}, {.limit = 1});
    answer_.judgement.culprit = hits.pairs.front();
  }

  std::size_t whole() const { return 2 * torus_.triangles().size(); }

  void shrink(std::size_t blind_from, Seconds delay, Seconds time) {
    std::vector<EngineEntry> engines;
    engines.push_back({"blind", std::make_unique<BlindToLarge>(blind_from, delay, asked_)});
    const WrongAnswer wrong{.place = 0,
                            .where = "0",
                            .name = "x",
                            .answer = std::make_shared<const AnswerRecord>(answer_),
                            .query = [&] { return to_case(); }};
    const auto start = std::chrono::steady_clock::now();
    shrink_worst(std::vector<WrongAnswer>{wrong, wrong}, engines,
                 {.time = time,
                  .on_case =
                      [&](const ShrunkCase& each) {
                        told_.push_back({asked_.size(), size_of(each)});
                        EXPECT_TRUE(each.query.answer.has_value());
                        EXPECT_EQ(each.query.answered_by.engine, "blind");
                      },
                  .on_done = [&](ShrunkCase each) { done_.push_back(std::move(each)); }});
    took_ = std::chrono::steady_clock::now() - start;
  }

  Case to_case() const {
    return {.note = "",
            .ask = Ask::Any,
            .settings = {},
            .a = CaseMesh(torus_, Pose::Identity()),
            .b = CaseMesh(torus_, pose_),
            .answer = std::nullopt,
            .answered_by = {}};
  }

  static std::size_t size_of(const ShrunkCase& each) {
    const MeshCase meshes = *as_meshes(each.query);
    return meshes.a.mesh.triangles().size() + meshes.b.mesh.triangles().size();
  }

  struct Told {
    std::size_t questions;  ///< before it
    std::size_t size;
  };

  Mesh torus_ = tests::make_torus(1, 0.25, 80, 80);
  Pose pose_ = Pose::Identity();
  AnswerRecord answer_;
  Sizes asked_;
  std::vector<Told> told_;
  std::vector<ShrunkCase> done_;
  Seconds took_{};
};

/// The two triangles are asked about first, and nothing else.
TEST_F(ShrinkWorst, AGuiltyPairIsFoundWithoutTheMeshes) {
  shrink(1, Seconds(0), Seconds(60));
  ASSERT_EQ(done_.size(), 2u);
  for (const ShrunkCase& each : done_) {
    EXPECT_EQ(size_of(each), 2u);
    EXPECT_TRUE(each.is_smaller);
    EXPECT_FALSE(each.is_stopped);
    EXPECT_EQ(each.judgement.verdict, Verdict::Wrong);
  }
  EXPECT_EQ(*std::max_element(asked_.begin(), asked_.end()), 2u);
  EXPECT_LE(told_.front().questions, 2u) << "kept as soon as it is known";
}

/// Where the engine is right about the pair, the few about it show what thousands show.
TEST_F(ShrinkWorst, WhatIsNearTheGuiltyPairIsTriedBeforeTheWhole) {
  shrink(3, Seconds(0), Seconds(60));
  ASSERT_EQ(done_.size(), 2u);
  for (const ShrunkCase& each : done_) {
    EXPECT_EQ(size_of(each), 6u);
    EXPECT_FALSE(each.is_stopped);
    EXPECT_NE(least_size(each), "");
  }
  EXPECT_EQ(std::count(asked_.begin(), asked_.end(), whole()), 2)
      << "each once, to be kept before the search";
  EXPECT_EQ(std::count_if(asked_.begin(), asked_.end(), [](auto n) { return n > 128; }), 2);
  EXPECT_EQ(told_.front().size, whole());
}

/// However long a question takes: no more than one goes beyond the time of each case.
TEST_F(ShrinkWorst, TheTimeIsKeptAndWhatIsFoundUntilThen) {
  shrink(2000, Seconds(0.02), Seconds(0.4));
  ASSERT_EQ(done_.size(), 2u);
  for (const ShrunkCase& each : done_) {
    EXPECT_TRUE(each.is_stopped);
    EXPECT_EQ(least_size(each), "") << "that is not known";
    EXPECT_LE(size_of(each), whole());
    EXPECT_GE(size_of(each), 4000u);
  }
  EXPECT_LT(took_.count(), 30) << "on a busy machine; without an end it would be minutes";
  EXPECT_LT(asked_.size(), 60u);
  EXPECT_EQ(told_.front().size, whole());
  EXPECT_LE(told_.front().questions, 3u) << "the pair, with and without poses, and the whole";
  EXPECT_EQ(told_.back().size, size_of(done_.back())) << "the last word is the smallest";
}

TEST_F(ShrinkWorst, WithoutTimeNothingIsShrunk) {
  shrink(1, Seconds(0), Seconds(0));
  ASSERT_EQ(done_.size(), 2u);
  EXPECT_EQ(asked_, (Sizes{whole(), whole()})) << "for the answer that is kept";
  for (const ShrunkCase& each : done_) {
    EXPECT_EQ(size_of(each), whole());
    EXPECT_FALSE(each.is_smaller);
    EXPECT_TRUE(each.is_stopped);
  }
}

TEST(ShrinkStopped, WhatIsFoundUntilThenIsTheResult) {
  const Mesh torus = tests::make_torus(1, 0.25, 20, 20);
  const Case query{.note = "",
                   .ask = Ask::Any,
                   .settings = {},
                   .a = CaseMesh(torus, Pose::Identity()),
                   .b = CaseMesh(torus, Pose::Identity()),
                   .answer = std::nullopt,
                   .answered_by = {}};
  for (const int most : {0, 1, 5, 20}) {
    int questions = 0;
    std::size_t smallest = 1600;
    const Case small = shrink(query, std::nullopt, [&](const Case& smaller) {
      if (questions++ == most) throw ShrinkingStopped();
      const MeshCase meshes = *as_meshes(smaller);
      smallest = meshes.a.mesh.triangles().size() + meshes.b.mesh.triangles().size();
      return true;
    });
    const MeshCase meshes = *as_meshes(small);
    EXPECT_EQ(meshes.a.mesh.triangles().size() + meshes.b.mesh.triangles().size(), smallest);
  }
}

/// Of the largest doubles a rounding of fewer digits is infinite: that is no number to offer.
TEST(ShrinkStopped, TheLargestNumbersStayFinite) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  const auto mesh = [](double x) {
    return CaseMesh(Mesh(std::vector<Eigen::Vector3d>{{x, 0, 0}, {0, 1, 0}, {-x, 0, 1}},
                         std::vector<TriangleIndices>{{0, 1, 2}}),
                    Pose::Identity());
  };
  const Case query{.note = "",
                   .ask = Ask::Any,
                   .settings = {},
                   .a = mesh(kLargest),
                   .b = mesh(1),
                   .answer = std::nullopt,
                   .answered_by = {}};
  const auto reaches = [](const Case& smaller, double x) {
    return as_meshes(smaller)->a.mesh.bounds().max.x() >= x;
  };
  const Case small = shrink(query, TrianglePair{0, 0},
                            [&](const Case& smaller) { return reaches(smaller, kLargest / 2); });
  EXPECT_TRUE(reaches(small, kLargest / 2));
}

}  // namespace
}  // namespace graze::compare
