#include <graze/bvh/error.h>
#include <graze/engine/cases/sha256.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/judge/answer_fault.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/run/comparison.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/compare/run/trial_threads.h>

#include <algorithm>
#include <chrono>

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

  PlaceRecord run(std::size_t pose) const {
    PlaceRecord record{pose, {}};
    std::vector<CaseAnswer> answers;
    std::vector<const LoadedEngine*> owners;
    for (const LoadedEngine& engine : engines_) {
      const auto start = std::chrono::steady_clock::now();
      Utterance said =
          hear([&] { return engine.pair->answer(job_.question, job_.a.pose, job_.poses_b[pose]); },
               engine.entry->name);
      const std::chrono::duration<double, std::micro> time =
          std::chrono::steady_clock::now() - start;
      if (!said.answer && said.thrown.empty()) continue;
      record.answers.push_back(
          {.engine = engine.entry->name,
           .digest = said.answer ? cases::sha256_of(to_json(*said.answer)) : "",
           .brief = said.answer ? brief(*said.answer) : "nothing",
           .time = time.count(),
           .is_agreed = said.answer.has_value(),
           .judgement = {}});
      if (!said.answer) record.answers.back().judgement = engine_error("throws " + said.thrown);
      owners.push_back(said.answer ? &engine : nullptr);
      answers.push_back(std::move(said.answer).value_or(CaseAnswer()));
    }
    bool is_disputed = false;
    for (std::size_t i = 0; i < answers.size(); ++i)
      is_disputed |= owners[i] != nullptr && contradicts(answers[i], answers.front());
    if (is_disputed) settle(record, answers, owners);
    return record;
  }

 private:
  /// Of an engine that threw there is no owner: it is wrong already.
  void settle(PlaceRecord& record, const std::vector<CaseAnswer>& answers,
              const std::vector<const LoadedEngine*>& owners) const {
    const Case query = case_of(job_, record.place);
    const Judge judge(query);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (owners[i] == nullptr) continue;
      const Engine& engine = *owners[i]->entry->engine;
      record.answers[i].is_agreed = false;
      record.answers[i].judgement =
          judge.judge(answers[i], {owners[i]->entry->name, engine.name().version}, asking(engine));
    }
  }

  const ComparisonJob& job_;
  std::span<const LoadedEngine> engines_;
};

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
                    const std::function<void(PlaceRecord)>& on_record) {
  const std::vector<LoadedEngine> loaded = load_all(job, engines);
  const PoseTrial trial(job, loaded);
  run_on_places<PlaceRecord>(
      job.threads, job.poses_b.size(), is_done, [&](std::size_t pose) { return trial.run(pose); },
      on_record);
}

}  // namespace graze::compare
