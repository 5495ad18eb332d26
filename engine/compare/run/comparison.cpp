#include <graze/bvh/error.h>
#include <graze/engine/cases/sha256.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/shrink.h>
#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/compare/run/trial_threads.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <tuple>

namespace graze::compare {
namespace {

struct LoadedEngine {
  const EngineEntry* entry;
  std::unique_ptr<LoadedPair> pair;
};

/// Every engine that is here and takes the meshes. That graze refuses them is an error.
std::vector<LoadedEngine> load_all(const ComparisonJob& job, std::span<const EngineEntry> engines) {
  std::vector<LoadedEngine> loaded;
  for (const EngineEntry& entry : engines) {
    if (entry.engine == nullptr) continue;
    try {
      loaded.push_back({&entry, entry.engine->load(job.a.mesh, job.b.mesh)});
    } catch (const Error&) {
      if (entry.name == "graze") throw;
    }
  }
  return loaded;
}

bool contradicts(const CaseAnswer& a, const CaseAnswer& b) {
  if (a.distance || b.distance) return true;
  if (a.contacts && b.contacts) return a.contacts->empty() != b.contacts->empty();
  return a.says != b.says || a.pairs != b.pairs;
}

class PoseTrial {
 public:
  PoseTrial(const ComparisonJob& job, std::span<const LoadedEngine> engines)
      : job_(job), engines_(engines) {}

  PoseRecord run(std::size_t pose) const {
    PoseRecord record{pose, {}};
    std::vector<CaseAnswer> answers;
    std::vector<const LoadedEngine*> owners;
    for (const LoadedEngine& engine : engines_) {
      const auto start = std::chrono::steady_clock::now();
      std::optional<CaseAnswer> answer =
          engine.pair->answer(job_.question, job_.a.pose, job_.poses_b[pose]);
      const std::chrono::duration<double, std::micro> time =
          std::chrono::steady_clock::now() - start;
      if (!answer) continue;
      record.answers.push_back({.engine = engine.entry->name,
                                .digest = cases::sha256_of(to_json(*answer)),
                                .brief = brief(*answer),
                                .time = time.count(),
                                .is_agreed = true,
                                .judgement = {}});
      answers.push_back(*std::move(answer));
      owners.push_back(&engine);
    }
    const bool is_disputed =
        std::any_of(answers.begin(), answers.end(),
                    [&](const CaseAnswer& answer) { return contradicts(answer, answers.front()); });
    if (is_disputed) settle(record, answers, owners);
    return record;
  }

 private:
  void settle(PoseRecord& record, const std::vector<CaseAnswer>& answers,
              const std::vector<const LoadedEngine*>& owners) const {
    const Case query = case_of(job_, record.pose);
    const Judge judge(query);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const Engine& engine = *owners[i]->entry->engine;
      record.answers[i].is_agreed = false;
      record.answers[i].judgement =
          judge.judge(answers[i], {owners[i]->entry->name, engine.name().version}, asking(engine));
    }
  }

  const ComparisonJob& job_;
  std::span<const LoadedEngine> engines_;
};

/// What is wrong in which record, the worst first.
struct WrongAnswer {
  const PoseRecord* record;
  const AnswerRecord* answer;

  auto rank() const {
    return std::tuple(answer->engine != "graze", -static_cast<int>(answer->judgement.error_class),
                      record->pose, answer->engine);
  }
};

/// Errors of rounding are of one kind: without its poses one of placing becomes one of touching.
bool is_same_kind(ErrorClass a, ErrorClass b) {
  return a == b || (a <= ErrorClass::PoseRounding && b <= ErrorClass::PoseRounding);
}

/// A record from a file may name triangles that the meshes do not have.
std::optional<TrianglePair> culprit_of(const ComparisonJob& job, const AnswerRecord& answer) {
  const std::optional<TrianglePair>& culprit = answer.judgement.culprit;
  const bool is_there = culprit && culprit->a < job.a.mesh.triangles().size() &&
                        culprit->b < job.b.mesh.triangles().size();
  return is_there ? culprit : std::nullopt;
}

/// Wrong for the same reason: rounding coordinates could make a real error of one of touching.
ShrunkCase shrink_one(const ComparisonJob& job, const Engine& engine, const WrongAnswer& wrong) {
  const CaseWitness witness = {wrong.answer->engine, engine.name().version};
  const StillWrong is_still_wrong = [&](const Case& smaller) {
    try {
      const std::optional<CaseAnswer> answer = ask(engine, smaller);
      if (!answer) return false;
      const Judgement judgement = Judge(smaller).judge(*answer, witness, asking(engine));
      return judgement.verdict == Verdict::Wrong &&
             is_same_kind(judgement.error_class, wrong.answer->judgement.error_class);
    } catch (const Error&) {
      return false;
    }
  };
  const Case query = case_of(job, wrong.record->pose);
  Case small = shrink(query, culprit_of(job, *wrong.answer), is_still_wrong);
  small.answer = ask(engine, small);
  small.answered_by = witness;
  const Judgement judgement =
      small.answer ? Judge(small).judge(*small.answer, witness, asking(engine)) : Judgement();
  return {wrong.answer->engine, wrong.record->pose, std::move(small), judgement};
}

}  // namespace

Case case_of(const ComparisonJob& job, std::size_t pose) {
  CaseMesh b = job.b;
  b.pose = job.poses_b[pose];
  return {.note = "",
          .ask = job.question.ask,
          .settings = job.question.settings,
          .a = job.a,
          .b = std::move(b),
          .answer = std::nullopt,
          .answered_by = {}};
}

void run_comparison(const ComparisonJob& job, std::span<const EngineEntry> engines,
                    const std::function<bool(std::size_t)>& is_done,
                    const std::function<void(PoseRecord)>& on_record) {
  const std::vector<LoadedEngine> loaded = load_all(job, engines);
  const PoseTrial trial(job, loaded);
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  run_on_threads(
      job.threads, job.poses_b.size(),
      [&] {
        for (std::size_t pose = next++; pose < job.poses_b.size(); pose = next++) {
          if (is_done(pose)) continue;
          PoseRecord record = trial.run(pose);
          const std::lock_guard lock(mutex);
          on_record(std::move(record));
        }
      },
      [&] { next = job.poses_b.size(); });
}

std::vector<ShrunkCase> shrink_worst(const ComparisonJob& job, std::span<const EngineEntry> engines,
                                     std::span<const PoseRecord> records, std::size_t limit) {
  std::vector<WrongAnswer> wrong;
  for (const PoseRecord& record : records) {
    for (const AnswerRecord& answer : record.answers) {
      if (answer.is_wrong()) wrong.push_back({&record, &answer});
    }
  }
  std::sort(wrong.begin(), wrong.end(),
            [](const WrongAnswer& a, const WrongAnswer& b) { return a.rank() < b.rank(); });
  std::vector<ShrunkCase> shrunk;
  for (const WrongAnswer& each : wrong) {
    if (shrunk.size() == limit) break;
    const auto entry = std::find_if(
        engines.begin(), engines.end(),
        [&](const EngineEntry& candidate) { return candidate.name == each.answer->engine; });
    if (entry == engines.end() || entry->engine == nullptr) continue;
    shrunk.push_back(shrink_one(job, *entry->engine, each));
  }
  return shrunk;
}

}  // namespace graze::compare
