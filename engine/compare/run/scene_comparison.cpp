#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/compare/judge/shape_judge.h>
#include <graze/engine/compare/run/record/time_code.h>
#include <graze/engine/compare/run/scene_comparison.h>
#include <graze/engine/compare/run/scene_engine.h>
#include <graze/engine/compare/run/scene_motions.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/files/sha256.h>
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

const char* brief_of(bool says) {
  return says ? "yes" : "no";
}

/// Holds what the world says at a step.
struct WorldStep {
  std::size_t step = 0;
  double time = 0;  ///< seconds
  double took = 0;  ///< microseconds
  std::set<ScenePair> touching;
};

/// Asks about all pairs at one step.
class StepTrial {
 public:
  StepTrial(const Scene& scene, std::span<const SceneEngine> engines, WorldStep world)
      : scene_(scene), engines_(engines), world_(std::move(world)), said_(engines.size() + 1) {
    record_.place = world_.step;
    record_.time = world_.time;
    record_.engines.push_back({"world", 0, "", world_.took});
    for (const SceneEngine& engine : engines)
      record_.engines.push_back({engine.entry().name, 0, "", 0});
    for (const SceneBody& body : scene.bodies)
      bodies_.push_back({body.shape, pose_at(body, world_.time)});
  }

  /// Runs the step. Pairs at which the world should not even look are asked about, too, so that it
  /// is seen if it does.
  StepRecord run(const std::vector<ScenePair>& meeting) {
    std::vector<ScenePair> pairs = meeting;
    std::set_difference(world_.touching.begin(), world_.touching.end(), meeting.begin(),
                        meeting.end(), std::back_inserter(pairs));
    ask_all(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      judge_pair(pairs[i], i);
      if (i < meeting.size()) continue;
      if (record_.differences.empty() || record_.differences.back().pair != pairs[i]) {
        keep(pairs[i]);
      }
      blame_world("filtered");
    }
    for (std::size_t i = 0; i < said_.size(); ++i)
      record_.engines[i].digest = files::sha256_of(said_[i]);
    for (StepAnswers& each : record_.engines)
      each.time = recorded_time(each.time);
    return std::move(record_);
  }

 private:
  /// Holds what one of them said of a pair; the world has no engine.
  struct Said {
    const SceneEngine* engine;
    Utterance utterance;

    bool says() const { return utterance.answer && *utterance.answer->says; }
  };

  static Utterance utterance_of(std::optional<bool> says, std::string fault = {}) {
    Utterance utterance{.fault = std::move(fault)};
    if (says) utterance.answer.emplace().says = says;
    return utterance;
  }

  void ask_all(const std::vector<ScenePair>& pairs) {
    asked_.reserve(pairs.size());
    for (const ScenePair& pair : pairs)
      asked_.emplace_back(pair.a, pair.b);
    for (std::size_t i = 0; i < engines_.size(); ++i) {
      answers_.push_back(engines_[i].loaded().intersect_all(bodies_, asked_));
      record_.engines[i + 1].time = answers_.back().time.count();
    }
    record_.questions = pairs.size();
  }

  void judge_pair(const ScenePair& pair, std::size_t place) {
    heard_.clear();
    add(nullptr, 0, utterance_of(world_.touching.contains(pair)));
    for (std::size_t i = 0; i < engines_.size(); ++i) {
      const ShapesAnswer::Pair& answer = answers_[i].pairs[place];
      add(&engines_[i], i + 1, utterance_of(answer.says, answer.fault));
    }
    const bool is_disputed = std::any_of(heard_.begin(), heard_.end(), [&](const Said& each) {
      return each.utterance.answer && each.says() != heard_.front().says();
    });
    const bool is_fault = std::any_of(heard_.begin(), heard_.end(), [](const Said& each) {
      return !each.utterance.fault.empty();
    });
    if (!is_disputed && !is_fault) return;
    keep(pair);
    judge_answers(pair, place, is_disputed);
  }

  void add(const SceneEngine* engine, std::size_t place, Utterance utterance) {
    const bool is_fault = !utterance.fault.empty();
    said_[place] += is_fault ? '!' : !utterance.answer ? '-' : *utterance.answer->says ? '1' : '0';
    if (!utterance.answer && !is_fault) return;
    ++record_.engines[place].answers;
    heard_.push_back({engine, std::move(utterance)});
  }

  void keep(const ScenePair& pair) {
    SceneDifference difference{pair, {}};
    for (const Said& each : heard_) {
      difference.answers.push_back({.engine = each.engine ? each.engine->entry().name : "world",
                                    .digest = "",
                                    .brief = brief_of(each),
                                    .time = 0,
                                    .is_agreed = true,
                                    .judgement = {}});
    }
    record_.differences.push_back(std::move(difference));
  }

  static const char* brief_of(const Said& said) {
    return !said.utterance.answer ? "nothing" : compare::brief_of(said.says());
  }

  PlacedBody body(std::size_t index) const {
    return {scene_.shapes[bodies_[index].shape].shape, bodies_[index].pose};
  }

  /// Judges all answers, or, where none is disputed, those that are none.
  void judge_answers(const ScenePair& pair, std::size_t place, bool is_disputed) {
    const ShapeJudge referee(body(pair.a), body(pair.b));
    std::optional<bool> graze_says;
    for (const Said& each : heard_) {
      if (each.engine == nullptr || each.engine->entry().name != "graze") continue;
      if (each.utterance.answer) graze_says = each.says();
    }
    std::vector<AnswerRecord>& answers = record_.differences.back().answers;
    for (std::size_t i = 0; i < heard_.size(); ++i) {
      Said& each = heard_[i];
      if (!is_disputed && each.utterance.answer) continue;
      const std::string name = each.engine == nullptr ? "graze" : each.engine->entry().name;
      Heard heard = judged(
          name, std::move(each.utterance),
          [&](const CaseAnswer& answer) {
            return referee.judge(*answer.says, {name, ""});
          },
          [&] { return each.engine->hear_alone(bodies_, asked_, place); });
      each.utterance = std::move(heard.said);
      answers[i].brief = brief_of(each);
      answers[i].is_agreed = false;
      answers[i].judgement = heard.judgement;
    }
    if (!graze_says || *graze_says == heard_.front().says()) return;
    if (answers.front().is_wrong()) return;
    blame_world(std::string("graze alone says ") + compare::brief_of(*graze_says));
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
  std::vector<PlacedShape> bodies_;
  std::vector<std::pair<std::size_t, std::size_t>> asked_;
  std::vector<ShapesAnswer> answers_;  ///< what each engine says
  std::vector<std::string> said_;  ///< a character for each question, for the world and for each
                                   ///< engine
  StepRecord record_;
  std::vector<Said> heard_;  ///< about the last pair; the world's first
};

std::set<ScenePair> touching_in(const World& world) {
  std::set<ScenePair> touching;
  for (const BodyPair& pair : world.pairs())
    touching.insert({pair.a.index, pair.b.index});
  return touching;
}

/// Holds the world, which must see every step once and in order.
class SteppedWorld {
 public:
  SteppedWorld(const Scene& scene, const SceneComparisonSettings& settings)
      : simulation_(scene, {.step = settings.step, .world = {.contacts = false}}) {}

  /// Goes on to a step that is not behind it.
  WorldStep at(std::size_t step) {
    std::chrono::duration<double, std::micro> took{0};
    for (; next_ <= step; ++next_) {
      const auto start = Clock::now();
      simulation_.advance();
      took = Clock::now() - start;
    }
    return {simulation_.steps(), simulation_.time(), took.count(),
            touching_in(simulation_.world())};
  }

 private:
  Simulation simulation_;
  std::size_t next_ = 0;
};

}  // namespace

void compare_scene(const Scene& scene, std::span<const EngineEntry> engines,
                   const SceneComparisonSettings& settings, const PlaceRange& range,
                   const std::function<bool(std::vector<StepRecord>)>& on_records) {
  if (cases::is_about_motion(settings.ask)) {
    compare_scene_motions(scene, engines, settings, range, on_records);
    return;
  }
  const std::vector<SceneEngine> loaded = load_scene(scene, engines, settings.ask);
  const std::vector<ScenePair> meeting = meeting_pairs(scene);
  SteppedWorld world(scene, settings);
  PlaceRange one_by_one = range;
  one_by_one.most_at_once = 1;
  run_in_order<StepRecord>(
      one_by_one, [&](std::size_t step) { return world.at(step); },
      [&](std::size_t, WorldStep step) {
        return StepTrial(scene, loaded, std::move(step)).run(meeting);
      },
      on_records);
}

}  // namespace graze::compare
