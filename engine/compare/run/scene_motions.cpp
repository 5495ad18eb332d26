#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/run/record/time_code.h>
#include <graze/engine/compare/run/scene_engine.h>
#include <graze/engine/compare/run/scene_motions.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/scenes/simulation.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace graze::compare {
namespace {

/// Holds what the world says of a step: the pairs that it lists, with the contact that comes first.
struct SweptStep {
  std::size_t step = 0;
  double from = 0;  ///< seconds
  double to = 0;
  double took = 0;  ///< microseconds
  std::map<ScenePair, RigidContact> met;
};

/// Returns the scene with all that moves swept, whatever it says itself: each body is on trial.
Scene swept(Scene scene) {
  for (SceneBody& body : scene.bodies) {
    if (!std::holds_alternative<std::monostate>(body.path)) body.detection = Detection::Continuous;
  }
  return scene;
}

/// Holds the world, which must see every step once and in order.
class SweptWorld {
 public:
  SweptWorld(const Scene& scene, const SceneComparisonSettings& settings)
      : scene_(swept(scene)),
        simulation_(scene_,
                    {.step = settings.step,
                     .world = {.contacts = false, .sweeps = {.clearance = settings.clearance}}}) {}

  /// Goes on to a step that is not behind it.
  SweptStep at(std::size_t step) {
    SweptStep said;
    for (; next_ <= step; ++next_) {
      const auto start = std::chrono::steady_clock::now();
      const WorldUpdate update = simulation_.advance();
      said.took =
          std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
              .count();
      said.met.clear();
      for (const BodyFirstContact& each : update.first_contacts)  // the first of a pair counts
        said.met.try_emplace({each.pair.a.index, each.pair.b.index}, each.contact);
    }
    said.step = simulation_.steps();
    said.to = simulation_.time();
    said.from = said.step == 0 ? said.to : simulation_.time_of(said.step - 1);
    return said;
  }

 private:
  Scene scene_;
  Simulation simulation_;
  std::size_t next_ = 0;
};

/// Says where a body is at the beginning of a step, and where it goes; nowhere if it rests.
struct MovingSceneBody {
  PlacedShape placed;
  std::optional<RigidCourse> course = {};
};

MovingSceneBody moving_body(const SceneBody& body, double from, double to) {
  MovingSceneBody moved{{body.shape, pose_at(body, from)}};
  const Pose end = pose_at(body, to);
  if (are_equal(moved.placed.pose, end)) return moved;
  const RigidMotion motion = RigidMotion::between(moved.placed.pose, end);
  moved.course = RigidCourse{.centre = motion.centre(),
                             .shift = motion.shift(),
                             .axis = motion.axis(),
                             .angle = motion.angle()};
  return moved;
}

bool is_free(const CaseAnswer& answer) {
  return answer.says ? *answer.says : answer.status == RigidStatus::Free;
}

/// Asks about all pairs in their motions through one step.
class MotionTrial {
 public:
  MotionTrial(const Scene& scene, std::span<const SceneEngine> engines,
              const SceneComparisonSettings& settings, SweptStep world)
      : scene_(scene),
        engines_(engines),
        settings_(settings),
        world_(std::move(world)),
        said_(engines.size() + 1) {
    record_.place = world_.step;
    record_.time = world_.to;
    record_.engines.push_back({"world", 0, "", world_.took});
    for (const SceneEngine& engine : engines)
      record_.engines.push_back({engine.entry().name, 0, "", 0});
    for (const SceneBody& body : scene.bodies)
      moving_.push_back(moving_body(body, world_.from, world_.to));
  }

  /// Runs the step. Pairs that the world lists though it should not look at them are asked about,
  /// too.
  StepRecord run(const std::vector<ScenePair>& meeting) {
    for (const ScenePair& pair : meeting) {
      if (rests(pair)) continue;
      try_pair(pair);
      world_.met.erase(pair);
    }
    for (const auto& [pair, contact] : std::map(world_.met)) {
      try_pair(pair);
      if (record_.differences.empty() || record_.differences.back().pair != pair) keep(pair);
      blame_world(rests(pair) ? "both rest" : "filtered");
    }
    for (std::size_t i = 0; i < said_.size(); ++i) {
      record_.engines[i].digest = files::sha256_of(said_[i]);
      record_.engines[i].time = recorded_time(record_.engines[i].time);
    }
    return std::move(record_);
  }

 private:
  /// Holds what one of them said of a pair, and the verdict; the world has no engine.
  struct Said {
    const SceneEngine* engine;
    Heard heard;
  };

  bool rests(const ScenePair& pair) const {
    return !moving_[pair.a].course && !moving_[pair.b].course;
  }

  CaseAnswer world_answer(const ScenePair& pair) const {
    const auto met = world_.met.find(pair);
    if (settings_.ask == Ask::FirstContact) {
      return answer_of(met == world_.met.end()
                           ? RigidContact{RigidStatus::Free, 1, 1, /*is_out_of_budget=*/false}
                           : met->second);
    }
    CaseAnswer answer;
    answer.says = met == world_.met.end();
    return answer;
  }

  void try_pair(const ScenePair& pair) {
    ++record_.questions;
    const Question question{.ask = settings_.ask,
                            .settings = {.clearance = settings_.clearance},
                            .course_a = moving_[pair.a].course,
                            .course_b = moving_[pair.b].course};
    heard_.clear();
    add(nullptr, 0, {.answer = world_answer(pair)});
    for (std::size_t i = 0; i < engines_.size(); ++i)
      add(&engines_[i], i + 1,
          engines_[i].hear(question, moving_[pair.a].placed, moving_[pair.b].placed));
    const bool are_all_free = std::all_of(heard_.begin(), heard_.end(), [](const Said& each) {
      return each.heard.said.answer && is_free(*each.heard.said.answer);
    });
    const bool is_judged = !are_all_free || are_meshes(pair);
    if (is_judged) judge_all(pair, question);
    const bool is_plain = are_all_free && (!is_judged || are_all_right());
    const bool is_same_to_world = agrees_with_world();
    if (is_plain && is_same_to_world) return;
    keep(pair);
    if (!is_same_to_world && !record_.differences.back().answers.front().is_wrong())
      blame_world("graze alone says " + brief(*graze_answer()));
  }

  void add(const SceneEngine* engine, std::size_t place, Utterance utterance) {
    const bool is_fault = !utterance.fault.empty();
    said_[place] += is_fault ? "!" : !utterance.answer ? "-" : answer_digest(*utterance.answer);
    if (engine != nullptr) record_.engines[place].time += utterance.time.count();
    if (!utterance.answer && !is_fault) return;
    ++record_.engines[place].answers;
    heard_.push_back({engine, {std::move(utterance), {}}});
  }

  /// True for two meshes. What all call free is judged for these, too: the certificate costs
  /// little, and "free" is not proved by agreeing. For other shapes the proof may be thousands of
  /// gaps.
  bool are_meshes(const ScenePair& pair) const {
    const auto is_mesh = [&](std::size_t body) {
      return scene_.shapes[scene_.bodies[body].shape].shape.kind() == ShapeKind::Mesh;
    };
    return is_mesh(pair.a) && is_mesh(pair.b);
  }

  bool are_all_right() const {
    return std::all_of(heard_.begin(), heard_.end(), [](const Said& each) {
      return each.heard.judgement.verdict == Verdict::Right;
    });
  }

  void judge_all(const ScenePair& pair, const Question& question) {
    const Case query = case_of(scene_, pair, settings_, {world_.from, world_.to});
    std::unique_ptr<Judge> judge;
    try {
      judge = std::make_unique<Judge>(query);
    } catch (const UnsupportedPairError&) {
      // The library proposes what is proved, and knows no such pair.
    }
    for (Said& each : heard_) {
      const std::string name = each.engine == nullptr ? "graze" : each.engine->entry().name;
      each.heard = judged(
          name, std::move(each.heard.said),
          [&](const CaseAnswer& answer) {
            if (!judge) return Judgement();
            return judge->judge(answer, {name, ""});
          },
          [&] {
            return each.engine->hear_alone(question, moving_[pair.a].placed,
                                           moving_[pair.b].placed);
          });
    }
  }

  /// Returns what graze says of the pair alone; null if it takes no part or does not know.
  const CaseAnswer* graze_answer() const {
    for (const Said& each : heard_) {
      if (each.engine != nullptr && each.engine->entry().name == "graze" && each.heard.said.answer)
        return &*each.heard.said.answer;
    }
    return nullptr;
  }

  bool agrees_with_world() const {
    const CaseAnswer* graze = graze_answer();
    return graze == nullptr || is_same(*graze, *heard_.front().heard.said.answer);
  }

  void keep(const ScenePair& pair) {
    SceneDifference difference{pair, {}};
    for (const Said& each : heard_) {
      const std::optional<CaseAnswer>& answer = each.heard.said.answer;
      difference.answers.push_back({.engine = each.engine ? each.engine->entry().name : "world",
                                    .digest = "",
                                    .brief = answer ? brief(*answer) : "nothing",
                                    .time = 0,
                                    .is_agreed = false,
                                    .judgement = each.heard.judgement,
                                    .value = answer ? answer_value(*answer) : std::nullopt});
    }
    record_.differences.push_back(std::move(difference));
  }

  void blame_world(const std::string& why) {
    Judgement& judgement = record_.differences.back().answers.front().judgement;
    judgement.verdict = Verdict::Wrong;
    judgement.error_class = ErrorClass::Real;
    judgement.truth += (judgement.truth.empty() ? "" : "; ") + why;
  }

  const Scene& scene_;
  std::span<const SceneEngine> engines_;
  const SceneComparisonSettings& settings_;
  SweptStep world_;
  std::vector<MovingSceneBody> moving_;
  std::vector<std::string> said_;  ///< digests for the world and for each engine
  StepRecord record_;
  std::vector<Said> heard_;  ///< about the last pair; the world's first
};

CaseShape case_shape(const Scene& scene, const MovingSceneBody& moved, bool are_meshes) {
  const Shape& shape = scene.shapes[moved.placed.shape].shape;
  if (are_meshes) {
    CaseMesh mesh(*shape.as<Mesh>(), moved.placed.pose);
    mesh.course = moved.course;
    return mesh;
  }
  CaseBody body(shape, moved.placed.pose);
  body.course = moved.course;
  return body;
}

}  // namespace

void compare_scene_motions(const Scene& scene, std::span<const EngineEntry> engines,
                           const SceneComparisonSettings& settings, const PlaceRange& range,
                           const std::function<bool(std::vector<StepRecord>)>& on_records) {
  const std::vector<SceneEngine> loaded = load_scene(scene, engines, settings.ask);
  const std::vector<ScenePair> meeting = meeting_pairs(scene);
  SweptWorld world(scene, settings);
  PlaceRange one_by_one = range;
  one_by_one.most_at_once = 1;
  run_in_order<StepRecord>(
      one_by_one, [&](std::size_t step) { return world.at(step); },
      [&](std::size_t, SweptStep step) {
        return MotionTrial(scene, loaded, settings, std::move(step)).run(meeting);
      },
      on_records);
}

Case case_of(const Scene& scene, const ScenePair& pair, const SceneComparisonSettings& settings,
             const TimeSpan& span) {
  const SceneBody &a = scene.bodies[pair.a], &b = scene.bodies[pair.b];
  const auto is_mesh = [&](const SceneBody& body) {
    return scene.shapes[body.shape].shape.kind() == ShapeKind::Mesh;
  };
  const bool are_meshes = is_mesh(a) && is_mesh(b);
  const bool is_moving = cases::is_about_motion(settings.ask);
  const double start = is_moving ? span.from : span.to;
  return {.note = "",
          .ask = settings.ask,
          .settings = {.clearance = settings.clearance},
          .a = case_shape(scene, moving_body(a, start, span.to), are_meshes),
          .b = case_shape(scene, moving_body(b, start, span.to), are_meshes),
          .answer = std::nullopt,
          .answered_by = {}};
}

}  // namespace graze::compare
