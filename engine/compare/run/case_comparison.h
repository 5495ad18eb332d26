#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/record/answer_record.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/compare/run/trial_threads.h>

namespace graze::compare {

struct NamedCase {
  std::string name;  ///< the name of its file
  Case query;
};

/// Runs try_case() for one of many: what graze throws names it.
std::vector<Testimony> try_named_case(const NamedCase& named, std::span<const EngineEntry> engines);

/// Holds cases, each of which says itself what is asked.
struct CaseJob {
  std::vector<NamedCase> cases;
};

/// Puts the cases of the range to all engines that are here and has every answer judged, also the
/// recorded one, which comes first, as try_case() does. graze is wrong if it says other than what
/// graze or the referee once said. For `on_records` see run_comparison(). Throws what graze throws,
/// with the name of the case.
void compare_cases(const CaseJob& job, std::span<const EngineEntry> engines,
                   const PlaceRange& range,
                   const std::function<bool(std::vector<PlaceRecord>)>& on_records);

}  // namespace graze::compare
