// Cases about the same meshes load them once, and are answered as if they did not.

#include <graze/engine/cases/to_case.h>
#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/compare/run/shared_loads.h>
#include <graze/engine/compare/run/trial.h>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <vector>

#include "tests/compare/each_record.h"
#include "tests/shapes/formula_meshes.h"

namespace graze::compare {
namespace {

/// graze, which counts what it loads.
class CountingEngine : public Engine {
 public:
  explicit CountingEngine(std::size_t& loads) : loads_(loads) {}
  CaseWitness name() const override { return {"counting", ""}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    ++loads_;
    if (mesh_a.triangles().size() == 12) throw MeshError("no boxes");
    return graze_->load(mesh_a, mesh_b);
  }

 private:
  std::size_t& loads_;
  std::unique_ptr<Engine> graze_ = make_graze_engine();
};

class SharedLoadsTest : public testing::Test {
 protected:
  SharedLoadsTest() {
    engines_.push_back({"counting", std::make_unique<CountingEngine>(loads_)});
    engines_.push_back({"absent", nullptr});
  }
  std::size_t loads_ = 0;
  std::vector<EngineEntry> engines_;
};

TEST_F(SharedLoadsTest, KeepTheLastFewPairs) {
  const SharedLoads shared(engines_);
  ASSERT_EQ(shared.engines().size(), 2u);
  EXPECT_EQ(shared.engines()[1].engine, nullptr);
  const Engine& engine = *shared.engines()[0].engine;
  std::vector<Mesh> meshes;
  for (int i = 0; i < 5; ++i)
    meshes.push_back(tests::make_torus(1, 0.1 + 0.05 * i, 8, 6));
  engine.load(meshes[0], meshes[1]);
  engine.load(meshes[0], meshes[1]);
  EXPECT_EQ(loads_, 1u);
  engine.load(meshes[1], meshes[0]);
  EXPECT_EQ(loads_, 2u) << "the other way round";
  for (int i = 0; i < 3; ++i)
    engine.load(meshes[0], meshes[2 + i]);
  EXPECT_EQ(loads_, 5u);
  engine.load(meshes[1], meshes[0]);
  EXPECT_EQ(loads_, 5u) << "four are kept";
  engine.load(meshes[0], meshes[1]);
  EXPECT_EQ(loads_, 6u) << "and the oldest is not";
  const Mesh equal = tests::make_torus(1, 0.1, 8, 6);
  engine.load(equal, meshes[1]);
  EXPECT_EQ(loads_, 7u) << "an equal mesh is another one";
}

TEST_F(SharedLoadsTest, ForgetWhatWasRefused) {
  const SharedLoads shared(engines_);
  const Mesh box = tests::make_box({1, 1, 1});
  for (int i = 0; i < 2; ++i)
    EXPECT_THROW(shared.engines()[0].engine->load(box, box), MeshError);
  EXPECT_EQ(loads_, 2u);
}

TEST_F(SharedLoadsTest, ChangeNoAnswerOfManyCases) {
  CaseJob job;
  const Mesh a = tests::make_torus(1, 0.25, 10, 8), b = tests::make_torus(0.7, 0.2, 10, 8);
  for (int i = 0; i < 40; ++i) {
    Pose pose = Pose::Identity();
    pose.translation().x() = 0.05 * i;
    Case query = to_case({i % 2 == 0 ? a : b}, {b, pose}, true);
    query.ask = i % 3 == 0 ? Ask::Distance : Ask::Any;
    query.answer.reset();
    job.cases.push_back({"case" + std::to_string(i), std::move(query)});
  }
  std::size_t asked = 0;
  compare_cases(job, engines_, {.end = job.cases.size(), .threads = 2},
                each_record<PlaceRecord>([&](const PlaceRecord& record) {
                  ASSERT_EQ(record.answers.size(), 1u);
                  const AnswerRecord& answer = record.answers[0];
                  EXPECT_FALSE(answer.is_wrong()) << record.place << ": " << answer.judgement.truth;
                  const Testimony alone = try_case(job.cases[record.place].query, engines_).front();
                  EXPECT_EQ(brief(alone.answer), answer.brief);
                  ++asked;
                }));
  EXPECT_EQ(asked, 40u);
  EXPECT_EQ(loads_, 2u + 40u) << "two pairs, and once each for those that were asked alone";
}

}  // namespace
}  // namespace graze::compare
