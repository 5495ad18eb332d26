#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/compare/run/record/time_code.h>
#include <graze/engine/compare/run/shared_loads.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/compare/run/trial_threads.h>

namespace graze::compare {
namespace {

AnswerRecord record_of(const Testimony& testimony, const Case& query) {
  AnswerRecord record{.engine = testimony.is_recorded ? kRecorded : testimony.witness.engine,
                      .digest = answer_digest(testimony.answer),
                      .brief = brief(testimony.answer),
                      .time = recorded_time(testimony.time.count()),
                      .is_agreed = false,
                      .judgement = testimony.judgement,
                      .value = answer_value(testimony.answer)};
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
                   const PlaceRange& range,
                   const std::function<bool(std::vector<PlaceRecord>)>& on_records) {
  const SharedLoads shared(engines);
  run_in_order<PlaceRecord>(
      range, [](std::size_t) { return 0; },
      [&](std::size_t place, int) {
        const Case& query = job.cases[place].query;
        PlaceRecord record{place, {}};
        for (const Testimony& testimony : try_case(query, shared.engines()))
          record.answers.push_back(record_of(testimony, query));
        return record;
      },
      on_records);
}

}  // namespace graze::compare
