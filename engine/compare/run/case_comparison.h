#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/answer_record.h>

namespace graze::compare {

struct NamedCase {
  std::string name;  ///< of its file
  Case query;
};

/// Cases, each of which says itself what is asked.
struct CaseJob {
  std::vector<NamedCase> cases;
  std::size_t threads = 0;  ///< 0: as many as there are processors
};

/// The name that recorded answers have among those of engines.
inline constexpr const char* kRecorded = "recorded";

/// Puts each case that `is_done` does not know to all engines that are here and has every answer
/// judged, also the recorded one, which comes first, as try_case() does. That graze says other than
/// what graze or the referee once said is wrong of it. `on_record` is called as cases are finished,
/// by one thread at a time and in no order. Throws what graze throws.
void compare_cases(const CaseJob& job, std::span<const EngineEntry> engines,
                   const std::function<bool(std::size_t)>& is_done,
                   const std::function<void(PlaceRecord)>& on_record);

}  // namespace graze::compare
