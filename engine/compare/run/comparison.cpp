#include <graze/bvh/error.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/compare/run/record/time_code.h>
#include <graze/engine/compare/run/shape_pair.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/compare/run/trial_threads.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace graze::compare {
namespace {

Question question_of(const ComparisonJob& job, std::size_t pose) {
  Question question = job.question;
  question.course_b = job.course_b(pose);
  return question;
}

/// Loads the two; null for an engine that knows no shapes.
std::unique_ptr<LoadedPair> load_pair(const Engine& engine, const ComparisonJob& job) {
  const auto* mesh_a = std::get_if<CaseMesh>(&job.a);
  const auto* mesh_b = std::get_if<CaseMesh>(&job.b);
  if (mesh_a != nullptr && mesh_b != nullptr) return engine.load(mesh_a->mesh, mesh_b->mesh);
  return load_shape_pair(engine, std::get<CaseBody>(job.a).shape, std::get<CaseBody>(job.b).shape);
}

/// Holds the two meshes in an engine, once for all questions and once for those that confirm; or
/// what an engine once said.
class LoadedEngine {
 public:
  LoadedEngine(const EngineEntry& entry, const ComparisonJob& job)
      : entry_(&entry),
        job_(&job),
        pair_(entry.recorded ? nullptr : load_pair(*entry.engine, job)) {}

  const std::string& name() const { return entry_->name; }
  const Engine& engine() const { return *entry_->engine; }

  bool is_recorded() const { return entry_->recorded != nullptr; }
  bool knows_shapes() const { return is_recorded() || pair_ != nullptr; }

  Utterance hear(std::size_t pose) const {
    if (!is_recorded()) return hear(*pair_, pose);
    return compare::hear([&] { return entry_->recorded->at(pose); }, kRecorded);
  }
  /// Asks where nothing else was asked; what was recorded stays as it is.
  Utterance hear_alone(std::size_t pose) const {
    if (is_recorded()) return hear(pose);
    std::call_once(alone_->is_loaded, [&] {
      const std::unique_ptr<Engine> alone = engine().alone();
      if (alone) alone_->pair = load_pair(*alone, *job_);
    });
    return hear(alone_->pair ? *alone_->pair : *pair_, pose);
  }

 private:
  struct Alone {
    std::once_flag is_loaded;
    std::unique_ptr<LoadedPair> pair;  ///< null if the engine needs none
  };

  Utterance hear(const LoadedPair& pair, std::size_t pose) const {
    return compare::hear(
        [&] {
          return pair.timed_answer(question_of(*job_, pose), pose_a(*job_),
                                   job_->poses_b->at(pose));
        },
        name());
  }

  const EngineEntry* entry_;
  const ComparisonJob* job_;
  std::unique_ptr<LoadedPair> pair_;
  std::unique_ptr<Alone> alone_ = std::make_unique<Alone>();
};

/// Returns every engine that is here and takes the meshes. That graze refuses them is an error.
std::vector<LoadedEngine> load_all(const ComparisonJob& job, std::span<const EngineEntry> engines) {
  std::vector<LoadedEngine> loaded;
  for (const EngineEntry& entry : engines) {
    if (entry.engine == nullptr) continue;
    try {
      loaded.emplace_back(entry, job);
      if (!loaded.back().knows_shapes()) loaded.pop_back();
    } catch (const EngineMissingError&) {
      throw;
    } catch (const Error&) {
      if (entry.name == "graze") throw;
    }
  }
  return loaded;
}

/// True if one contradicts the other; numbers and contacts differ as a rule.
bool contradicts(const CaseAnswer& a, const CaseAnswer& b) {
  if (a.distance || b.distance || a.status || b.status) return true;
  const auto has_contacts = [](const CaseAnswer& each) {
    return (each.contacts && !each.contacts->empty()) || (each.manifold && !each.manifold->empty());
  };
  if (has_contacts(a) || has_contacts(b)) return true;
  return a.says != b.says || a.pairs != b.pairs;
}

class PoseTrial {
 public:
  PoseTrial(const ComparisonJob& job, std::span<const LoadedEngine> engines)
      : job_(job), engines_(engines) {}

  PlaceRecord run(std::size_t pose) const {
    PlaceRecord record{pose, {}};
    std::vector<Utterance> said;
    std::vector<const LoadedEngine*> owners;
    for (const LoadedEngine& engine : engines_) {
      Utterance utterance = engine.hear(pose);
      if (!utterance.answer && utterance.fault.empty()) continue;
      owners.push_back(&engine);
      said.push_back(std::move(utterance));
    }
    const auto first = std::find_if(said.begin(), said.end(),
                                    [](const Utterance& each) { return each.answer.has_value(); });
    bool is_disputed = false;
    for (const Utterance& each : said)
      is_disputed |= each.answer && contradicts(*each.answer, *first->answer);
    std::optional<Case> query;
    std::optional<Judge> judge;
    for (std::size_t i = 0; i < said.size(); ++i) {
      const bool is_judged = is_disputed || !said[i].answer;
      if (is_judged && !judge) judge.emplace(query.emplace(case_of(job_, pose)));
      Heard heard = is_judged ? judged_by(*judge, *owners[i], std::move(said[i]), pose)
                              : Heard{std::move(said[i]), {}};
      record.answers.push_back(record_of(*owners[i], heard));
      record.answers.back().is_agreed = !is_judged;
    }
    return record;
  }

 private:
  static Heard judged_by(const Judge& judge, const LoadedEngine& owner, Utterance said,
                         std::size_t pose) {
    return judged(
        owner.name(), std::move(said),
        [&](const CaseAnswer& answer) {
          return judge.judge(answer, {owner.name(), owner.engine().name().version});
        },
        [&] { return owner.hear_alone(pose); });
  }

  static AnswerRecord record_of(const LoadedEngine& owner, const Heard& heard) {
    const std::optional<CaseAnswer>& answer = heard.said.answer;
    return {.engine = owner.name(),
            .digest = answer ? answer_digest(*answer) : "",
            .brief = answer ? brief(*answer) : "nothing",
            .time = recorded_time(heard.said.time.count()),
            .is_agreed = false,
            .judgement = heard.judgement,
            .value = answer ? answer_value(*answer) : std::nullopt};
  }

  const ComparisonJob& job_;
  std::span<const LoadedEngine> engines_;
};

}  // namespace

std::size_t ComparisonJob::places() const {
  return poses_b->size() - (cases::is_about_motion(question.ask) ? 1 : 0);
}

std::optional<RigidCourse> ComparisonJob::course_b(std::size_t pose) const {
  if (!cases::is_about_motion(question.ask)) return std::nullopt;
  const RigidMotion motion = RigidMotion::between(poses_b->at(pose), poses_b->at(pose + 1));
  return RigidCourse{.centre = motion.centre(),
                     .shift = motion.shift(),
                     .axis = motion.axis(),
                     .angle = motion.angle()};
}

const Pose& pose_a(const ComparisonJob& job) {
  const auto* mesh = std::get_if<CaseMesh>(&job.a);
  return mesh != nullptr ? mesh->pose : std::get<CaseBody>(job.a).pose;
}

Case case_of(const ComparisonJob& job, std::size_t pose) {
  CaseShape b = job.b;
  const auto place = [&](auto& each) {
    each.pose = job.poses_b->at(pose);
    each.course = job.course_b(pose);
  };
  if (auto* mesh = std::get_if<CaseMesh>(&b)) {
    place(*mesh);
  } else {
    place(std::get<CaseBody>(b));
  }
  return {.note = "",
          .ask = job.question.ask,
          .settings = job.question.settings,
          .a = job.a,
          .b = std::move(b),
          .answer = std::nullopt,
          .answered_by = {}};
}

void run_comparison(const ComparisonJob& job, std::span<const EngineEntry> engines,
                    const PlaceRange& range,
                    const std::function<bool(std::vector<PlaceRecord>)>& on_records) {
  const std::vector<LoadedEngine> loaded = load_all(job, engines);
  const PoseTrial trial(job, loaded);
  run_in_order<PlaceRecord>(
      range, [](std::size_t) { return 0; }, [&](std::size_t pose, int) { return trial.run(pose); },
      on_records);
}

}  // namespace graze::compare
