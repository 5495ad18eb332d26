#include <gtest/gtest.h>

#include <graze/narrowphase/triangle_pair/placed_triangle.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include "tests/engine/floating_point/environments.h"
#include "tests/engine/floating_point/questions.h"

namespace graze::tests {
namespace {

std::vector<std::uint64_t> answer_in(const Environment& environment, const Question& question,
                                     const Inputs& inputs, std::uint32_t& control_afterwards) {
  const InEnvironment in(environment);
  std::vector<std::uint64_t> words = answer(question, inputs);
  control_afterwards = current_control();
  return words;
}

/// Every question, in every environment, says what it says in the first one, and leaves the
/// environment as it was.
void expect_same_everywhere(const std::vector<Question>& questions, const Inputs& inputs) {
  const auto environments = all_environments();
  for (const Question& question : questions) {
    const std::vector<std::uint64_t> expected = answer(question, inputs);
    for (const Environment& environment : environments) {
      std::uint32_t control = 0;
      const auto words = answer_in(environment, question, inputs, control);
      EXPECT_EQ(words == expected, true) << question.name << ", " << environment.name;
      EXPECT_EQ(control, environment.control) << question.name << ", " << environment.name;
    }
  }
}

void expect_same_for_seeds(std::uint64_t first, std::uint64_t last) {
  const std::vector<Question> questions = all_questions(1);
  for (const Scale scale : kScales) {
    for (std::uint64_t seed = first; seed < last; ++seed)
      expect_same_everywhere(questions, inputs_of(scale, seed, 3));
  }
}

TEST(UsersArithmetic, ChangesNoAnswerOfOneThread) {
  expect_same_for_seeds(0, 1);
}

TEST(UsersArithmeticSlow, ChangesNoAnswerOfOneThread) {
  expect_same_for_seeds(1, 100);
}

TEST(UsersArithmetic, ChangesNoAnswerOfManyThreads) {
  expect_same_everywhere(parallel_questions(4), large_inputs(Scale::Denormal, 2));
  expect_same_everywhere({tree_question()}, large_inputs(Scale::Smallest, 20));
}

TEST(UsersArithmeticSlow, ChangesNoAnswerOfManyThreads) {
  for (const Scale scale : kScales) {
    expect_same_everywhere(parallel_questions(4), large_inputs(scale, 4));
    expect_same_everywhere({tree_question()}, large_inputs(scale, 60));
  }
}

/// Lists of pairs of small meshes, as many as it takes for rounding to show.
TEST(UsersArithmetic, ChangesNoneOfManyLists) {
  const Question question{"pairs", [](const Inputs& in, Words& words) {
                            const Mesh a(in.vertices_a, in.triangles_a);
                            const Mesh b(in.vertices_b, in.triangles_b);
                            words.add(find_triangle_pairs({a, in.pose_a}, {b, in.pose_b}));
                          }};
  for (int n = 0; n < 375; ++n) {
    for (const Scale scale : kScales)
      expect_same_everywhere({question}, inputs_of(scale, 1000 + static_cast<std::uint64_t>(n), 2));
  }
}

/// The same tests without the door, as the floors above call them, do answer otherwise: so the
/// inputs are such that it matters.
TEST(UsersArithmetic, WouldChangeAnswersWithoutTheDoor) {
  const auto answers = [](const Inputs& in) {
    Words words;
    for (const Triangle& a : in.triangles) {
      words.add(narrowphase::place(in.pose_b, a).a);
      for (const Triangle& b : in.triangles)
        words.add(narrowphase::decide(a, b).is_hit);
    }
    return words.list();
  };
  for (const Environment& environment : all_environments()) {
    const std::string name = environment.name;
    if (name == "as programs begin" || name.find("trap") != std::string::npos) continue;
    bool is_any_other = false;
    for (int seed = 0; seed < 200 && !is_any_other; ++seed) {
      for (const Scale scale : kScales) {
        const Inputs in = inputs_of(scale, static_cast<std::uint64_t>(seed), 1);
        const std::vector<std::uint64_t> expected = answers(in);
        const InEnvironment wrong(environment);
        is_any_other |= answers(in) != expected;
      }
    }
    EXPECT_TRUE(is_any_other) << name;
  }
}

}  // namespace
}  // namespace graze::tests
