#include <graze/engine/compare/judge/shape_judge.h>
#include <graze/engine/compare/run/scene_comparison.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/scenes/simulation.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace graze::compare {
namespace {

using Clock = std::chrono::steady_clock;

struct SceneEngine {
  const EngineEntry* entry;
  std::unique_ptr<LoadedShapes> shapes;
};

std::vector<SceneEngine> load_all(const Scene& scene, std::span<const EngineEntry> engines) {
  std::vector<Shape> shapes;
  for (const SceneShape& shape : scene.shapes)
    shapes.push_back(shape.shape);
  std::vector<SceneEngine> loaded;
  for (const EngineEntry& entry : engines) {
    if (entry.engine == nullptr) continue;
    std::unique_ptr<LoadedShapes> its = entry.engine->load_shapes(shapes);
    if (its) loaded.push_back({&entry, std::move(its)});
  }
  return loaded;
}

const char* brief_of(bool says) {
  return says ? "yes" : "no";
}

class StepTrial {
 public:
  StepTrial(const Scene& scene, std::span<const SceneEngine> engines)
      : scene_(scene), engines_(engines) {
    for (const SceneBody& body : scene.bodies)
      poses_.push_back(body.pose);
  }

  /// The world's answers at a time, and what its update cost for each pair.
  void begin(double time, std::set<ScenePair> touching, double time_per_pair) {
    touching_ = std::move(touching);
    time_per_pair_ = time_per_pair;
    for (std::size_t i = 0; i < poses_.size(); ++i)
      poses_[i] = pose_at(scene_.bodies[i], time);
  }

  /// `may_meet`: the world looks at the pair at all.
  const std::vector<AnswerRecord>& ask(const ScenePair& pair, bool may_meet) {
    answers_.clear();
    says_.clear();
    owners_.clear();
    add(nullptr, touching_.contains(pair), time_per_pair_);
    for (const SceneEngine& engine : engines_) {
      const auto start = Clock::now();
      const std::optional<bool> says = engine.shapes->intersects(
          scene_.bodies[pair.a].shape, poses_[pair.a], scene_.bodies[pair.b].shape, poses_[pair.b]);
      const std::chrono::duration<double, std::micro> took = Clock::now() - start;
      if (says) add(engine.entry, *says, took.count());
    }
    const bool is_disputed = std::find(says_.begin(), says_.end(), !says_.front()) != says_.end();
    if (is_disputed) settle(pair);
    if (!may_meet) blame_world("filtered");
    return answers_;
  }

 private:
  void add(const EngineEntry* owner, bool says, double time) {
    answers_.push_back({.engine = owner == nullptr ? "world" : owner->name,
                        .digest = "",
                        .brief = brief_of(says),
                        .time = time,
                        .is_agreed = true,
                        .judgement = {}});
    says_.push_back(says);
    owners_.push_back(owner);
  }

  PlacedBody body(std::size_t index) const {
    return {scene_.shapes[scene_.bodies[index].shape].shape, poses_[index]};
  }

  void settle(const ScenePair& pair) {
    const ShapeJudge judge(body(pair.a), body(pair.b));
    const EngineEntry* graze = nullptr;
    std::optional<bool> graze_says;
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      if (owners_[i] == nullptr || owners_[i]->name != "graze") continue;
      graze = owners_[i];
      graze_says = says_[i];
    }
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      const EngineEntry* asked = owners_[i] == nullptr ? graze : owners_[i];
      const CaseWitness witness = {asked == nullptr ? "graze" : asked->name, ""};
      AnswerRecord& answer = answers_[i];
      answer.is_agreed = false;
      answer.judgement = judge.judge(says_[i], witness,
                                     asked == nullptr ? JudgeSettings() : asking(*asked->engine));
    }
    if (!graze_says || *graze_says == says_.front()) return;
    if (answers_.front().judgement.verdict == Verdict::Wrong) return;
    blame_world(std::string("graze alone says ") + brief_of(*graze_says));
  }

  void blame_world(const std::string& why) {
    AnswerRecord& answer = answers_.front();
    answer.is_agreed = false;
    answer.judgement.verdict = Verdict::Wrong;
    answer.judgement.error_class = ErrorClass::Real;
    answer.judgement.truth += (answer.judgement.truth.empty() ? "" : "; ") + why;
  }

  const Scene& scene_;
  std::span<const SceneEngine> engines_;
  std::vector<Pose> poses_;
  std::set<ScenePair> touching_;
  double time_per_pair_ = 0;
  std::vector<AnswerRecord> answers_;
  std::vector<bool> says_;
  std::vector<const EngineEntry*> owners_;
};

std::set<ScenePair> touching_in(const World& world) {
  std::set<ScenePair> touching;
  for (const BodyPair& pair : world.pairs())
    touching.insert({pair.a.index, pair.b.index});
  return touching;
}

}  // namespace

void compare_scene(const Scene& scene, std::span<const EngineEntry> engines,
                   const SceneComparisonSettings& settings,
                   const std::function<void(const SceneRecord&)>& on_record) {
  const std::vector<SceneEngine> loaded = load_all(scene, engines);
  const std::vector<ScenePair> meeting = meeting_pairs(scene);
  Simulation simulation(scene, {.step = settings.step, .world = {.contacts = false}});
  StepTrial trial(scene, loaded);
  for (std::size_t step = 0; step <= settings.steps; ++step) {
    const auto start = Clock::now();
    simulation.advance();
    const std::chrono::duration<double, std::micro> took = Clock::now() - start;
    std::set<ScenePair> touching = touching_in(simulation.world());
    // What the world should not even look at is asked about too, so that it is seen.
    std::vector<ScenePair> asked = meeting;
    std::set_difference(touching.begin(), touching.end(), meeting.begin(), meeting.end(),
                        std::back_inserter(asked));
    trial.begin(simulation.time(), std::move(touching),
                took.count() / static_cast<double>(std::max<std::size_t>(asked.size(), 1)));
    for (std::size_t i = 0; i < asked.size(); ++i)
      on_record({step, simulation.time(), asked[i], trial.ask(asked[i], i < meeting.size())});
  }
}

ComparisonJob mesh_job(const Scene& scene, const ScenePair& pair, double time) {
  const auto mesh_of = [&](std::size_t body) {
    return *scene.shapes[scene.bodies[body].shape].shape.as<Mesh>();
  };
  return {.a = CaseMesh(mesh_of(pair.a), pose_at(scene.bodies[pair.a], time)),
          .b = CaseMesh(mesh_of(pair.b), Pose::Identity()),
          .poses_b = {pose_at(scene.bodies[pair.b], time)},
          .question = {Ask::Any, {}},
          .threads = 1};
}

}  // namespace graze::compare
