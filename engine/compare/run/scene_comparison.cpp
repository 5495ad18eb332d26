#include <graze/engine/cases/sha256.h>
#include <graze/engine/compare/judge/shape_judge.h>
#include <graze/engine/compare/run/scene_comparison.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/compare/run/trial_threads.h>
#include <graze/engine/scenes/simulation.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <mutex>
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

/// What the world says at a step.
struct WorldStep {
  std::size_t step = 0;
  double time = 0;  // seconds
  double took = 0;  // microseconds
  std::set<ScenePair> touching;
};

/// All pairs at one step, one after the other.
class StepTrial {
 public:
  StepTrial(const Scene& scene, std::span<const SceneEngine> engines, WorldStep world)
      : scene_(scene), engines_(engines), world_(std::move(world)), said_(engines.size() + 1) {
    record_.place = world_.step;
    record_.time = world_.time;
    record_.engines.push_back({"world", 0, "", world_.took});
    for (const SceneEngine& engine : engines)
      record_.engines.push_back({engine.entry->name, 0, "", 0});
    for (const SceneBody& body : scene.bodies)
      poses_.push_back(pose_at(body, world_.time));
  }

  /// What the world should not even look at is asked about too, so that it is seen.
  StepRecord run(const std::vector<ScenePair>& meeting) {
    for (const ScenePair& pair : meeting)
      ask(pair);
    std::vector<ScenePair> filtered;
    std::set_difference(world_.touching.begin(), world_.touching.end(), meeting.begin(),
                        meeting.end(), std::back_inserter(filtered));
    for (const ScenePair& pair : filtered) {
      ask(pair);
      if (record_.differences.empty() || record_.differences.back().pair != pair) keep(pair);
      blame_world("filtered");
    }
    for (std::size_t i = 0; i < said_.size(); ++i)
      record_.engines[i].digest = cases::sha256_of(said_[i]);
    return std::move(record_);
  }

 private:
  void ask(const ScenePair& pair) {
    answers_.clear();
    says_.clear();
    owners_.clear();
    ++record_.questions;
    add(nullptr, 0, world_.touching.contains(pair));
    for (std::size_t i = 0; i < engines_.size(); ++i) {
      const auto start = Clock::now();
      const std::optional<bool> says = engines_[i].shapes->intersects(
          scene_.bodies[pair.a].shape, poses_[pair.a], scene_.bodies[pair.b].shape, poses_[pair.b]);
      const std::chrono::duration<double, std::micro> took = Clock::now() - start;
      said_[i + 1] += says ? "" : "-";
      if (!says) continue;
      record_.engines[i + 1].time += took.count();
      add(engines_[i].entry, i + 1, *says);
    }
    if (std::find(says_.begin(), says_.end(), !says_.front()) == says_.end()) return;
    keep(pair);
    settle(pair);
  }

  void add(const EngineEntry* owner, std::size_t place, bool says) {
    answers_.push_back({.engine = owner == nullptr ? "world" : owner->name,
                        .digest = "",
                        .brief = brief_of(says),
                        .time = 0,
                        .is_agreed = true,
                        .judgement = {}});
    said_[place] += says ? '1' : '0';
    ++record_.engines[place].answers;
    says_.push_back(says);
    owners_.push_back(owner);
  }

  void keep(const ScenePair& pair) { record_.differences.push_back({pair, answers_}); }

  PlacedBody body(std::size_t index) const {
    return {scene_.shapes[scene_.bodies[index].shape].shape, poses_[index]};
  }

  void settle(const ScenePair& pair) {
    const ShapeJudge judge(body(pair.a), body(pair.b));
    const EngineEntry* graze = nullptr;
    std::optional<bool> graze_says;
    std::vector<AnswerRecord>& answers = record_.differences.back().answers;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (owners_[i] == nullptr || owners_[i]->name != "graze") continue;
      graze = owners_[i];
      graze_says = says_[i];
    }
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const EngineEntry* asked = owners_[i] == nullptr ? graze : owners_[i];
      const CaseWitness witness = {asked == nullptr ? "graze" : asked->name, ""};
      AnswerRecord& answer = answers[i];
      answer.is_agreed = false;
      answer.judgement = judge.judge(says_[i], witness,
                                     asked == nullptr ? JudgeSettings() : asking(*asked->engine));
    }
    if (!graze_says || *graze_says == says_.front()) return;
    if (answers.front().is_wrong()) return;
    blame_world(std::string("graze alone says ") + brief_of(*graze_says));
  }

  void blame_world(const std::string& why) {
    AnswerRecord& answer = record_.differences.back().answers.front();
    answer.is_agreed = false;
    answer.judgement.verdict = Verdict::Wrong;
    answer.judgement.error_class = ErrorClass::Real;
    answer.judgement.truth += (answer.judgement.truth.empty() ? "" : "; ") + why;
  }

  const Scene& scene_;
  std::span<const SceneEngine> engines_;
  WorldStep world_;
  std::vector<Pose> poses_;
  std::vector<std::string> said_;  // a character a question, of the world and of each engine
  StepRecord record_;
  // Of the last question:
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

/// The world, which must see every step once and in order, for all threads.
class SharedWorld {
 public:
  SharedWorld(const Scene& scene, const SceneComparisonSettings& settings,
              const std::function<bool(std::size_t)>& is_done)
      : simulation_(scene, {.step = settings.step, .world = {.contacts = false}}),
        steps_(settings.steps),
        is_done_(is_done) {}

  /// The next step that is not done; nothing after the last.
  std::optional<WorldStep> next() {
    const std::lock_guard lock(mutex_);
    while (next_ <= steps_) {
      const auto start = Clock::now();
      simulation_.advance();
      const std::chrono::duration<double, std::micro> took = Clock::now() - start;
      if (is_done_(next_++)) continue;
      return WorldStep{simulation_.steps(), simulation_.time(), took.count(),
                       touching_in(simulation_.world())};
    }
    return std::nullopt;
  }

  void stop() {
    const std::lock_guard lock(mutex_);
    next_ = steps_ + 1;
  }

 private:
  std::mutex mutex_;
  Simulation simulation_;
  std::size_t steps_;
  const std::function<bool(std::size_t)>& is_done_;
  std::size_t next_ = 0;
};

}  // namespace

void compare_scene(const Scene& scene, std::span<const EngineEntry> engines,
                   const SceneComparisonSettings& settings,
                   const std::function<bool(std::size_t)>& is_done,
                   const std::function<void(StepRecord)>& on_record) {
  const std::vector<SceneEngine> loaded = load_all(scene, engines);
  const std::vector<ScenePair> meeting = meeting_pairs(scene);
  SharedWorld world(scene, settings, is_done);
  std::mutex mutex;
  run_on_threads(
      settings.threads, settings.steps + 1,
      [&] {
        while (std::optional<WorldStep> step = world.next()) {
          StepRecord record = StepTrial(scene, loaded, *std::move(step)).run(meeting);
          const std::lock_guard lock(mutex);
          on_record(std::move(record));
        }
      },
      [&] { world.stop(); });
}

Case case_of(const Scene& scene, const ScenePair& pair, double time) {
  const auto shape_of = [&](std::size_t body) -> const Shape& {
    return scene.shapes[scene.bodies[body].shape].shape;
  };
  const bool are_meshes =
      shape_of(pair.a).kind() == ShapeKind::Mesh && shape_of(pair.b).kind() == ShapeKind::Mesh;
  const auto placed = [&](std::size_t body) -> CaseShape {
    const Pose pose = pose_at(scene.bodies[body], time);
    if (are_meshes) return CaseMesh(*shape_of(body).as<Mesh>(), pose);
    return CaseBody(shape_of(body), pose);
  };
  return {.note = "",
          .ask = Ask::Any,
          .settings = {},
          .a = placed(pair.a),
          .b = placed(pair.b),
          .answer = std::nullopt,
          .answered_by = {}};
}

}  // namespace graze::compare
