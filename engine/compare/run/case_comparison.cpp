#include <graze/bvh/error.h>
#include <graze/engine/cases/case.h>
#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/compare/run/record/time_code.h>
#include <graze/engine/compare/run/shared_loads.h>
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

std::vector<Testimony> try_named_case(const NamedCase& named,
                                      std::span<const EngineEntry> engines) {
  try {
    return try_case(named.query, engines);
  } catch (const EngineMissingError&) {
    throw;
  } catch (const Error& error) {  // graze refuses the question
    throw Error(named.name + ": " + error.what(), error.place());
  }
}

void compare_cases(const CaseJob& job, std::span<const EngineEntry> engines,
                   const PlaceRange& range,
                   const std::function<bool(std::vector<PlaceRecord>)>& on_records) {
  const SharedLoads shared(engines);
  run_in_order<PlaceRecord>(
      range, [](std::size_t) { return 0; },
      [&](std::size_t place, int) {
        const NamedCase& named = job.cases[place];
        PlaceRecord record{place, {}};
        for (const Testimony& testimony : try_named_case(named, shared.engines()))
          record.answers.push_back(record_of(testimony, named.query));
        return record;
      },
      on_records);
}

}  // namespace graze::compare
