#include <graze/engine/cases/text/sha256.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/compare/run/shared_loads.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/compare/run/trial_threads.h>

namespace graze::compare {
namespace {

AnswerRecord record_of(const Testimony& testimony, const Case& query) {
  AnswerRecord record{.engine = testimony.is_recorded ? kRecorded : testimony.witness.engine,
                      .digest = cases::sha256_of(to_json(testimony.answer)),
                      .brief = brief(testimony.answer),
                      .time = testimony.time.count(),
                      .is_agreed = false,
                      .judgement = testimony.judgement};
  if (testimony.differs_from_record) {
    Judgement& judgement = record.judgement;
    judgement.verdict = Verdict::Wrong;
    judgement.truth +=
        (judgement.truth.empty() ? "" : "; ") + std::string("recorded: ") + brief(*query.answer);
  }
  return record;
}

}  // namespace

void compare_cases(const CaseJob& job, std::span<const EngineEntry> engines,
                   const std::function<bool(std::size_t)>& is_done,
                   const std::function<void(PlaceRecord)>& on_record) {
  const SharedLoads shared(engines);
  run_on_places<PlaceRecord>(
      job.threads, job.cases.size(), is_done,
      [&](std::size_t place) {
        const Case& query = job.cases[place].query;
        PlaceRecord record{place, {}};
        for (const Testimony& testimony : try_case(query, shared.engines()))
          record.answers.push_back(record_of(testimony, query));
        return record;
      },
      on_record);
}

}  // namespace graze::compare
