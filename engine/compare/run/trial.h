#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// Holds what one engine answered to a case, and what the referee says of that.
struct Testimony {
  CaseWitness witness;
  bool is_recorded = false;  ///< true if the answer stands in the case and no engine was asked
  CaseAnswer answer;
  std::chrono::duration<double, std::micro> time{0};  ///< the time of the query, with its trees
                                                      ///< built
  Judgement judgement;
  /// For graze, where the case holds an answer that graze or the referee gave, this is true if the
  /// two are not the same, bit for bit. That is no error: a bug that was fixed is kept as a case,
  /// too.
  bool differs_from_record = false;

  bool is_wrong() const { return judgement.verdict == Verdict::Wrong; }
  bool is_graze() const { return witness.engine == "graze" && !is_recorded; }
};

/// Puts a case to every engine that is here and knows such questions, and judges their answers and
/// the recorded one, which comes first. Throws what graze throws, and EngineMissingError; other
/// engines that refuse a mesh are left out. Their errors are confirmed: see judged().
std::vector<Testimony> try_case(const Case& query, std::span<const EngineEntry> engines);

/// Holds what an engine answers, or what it did instead.
struct Utterance {
  std::optional<CaseAnswer> answer = {};
  TimedAnswer::Time time{0};
  std::string fault = {};  ///< "throws out of its depth", "died of SIGSEGV"; empty if none
};

/// Asks an engine. A refusal, an Error of the adaptor's, is no answer; whatever else an engine
/// other than graze throws is told. What graze throws is passed on, and so is EngineMissingError.
Utterance hear(const LoadedQuestion& question, const std::string& engine);

/// Asks about a case in the same way, where nothing else was asked before (Engine::alone).
Utterance hear_alone(const EngineEntry& entry, const Case& query);

/// Holds what an engine said, and what the referee says of that.
struct Heard {
  Utterance said;
  Judgement judgement;
};

/// Has what an engine said judged, if it said anything. If another engine than graze is wrong, or
/// gives no answer, `ask_alone` asks it again, and only if it is wrong then, too, is that held
/// against it: if that is another answer, it takes the place of the first. Else the verdict is
/// NotConfirmed.
Heard judged(const std::string& engine, Utterance said,
             const std::function<Judgement(const CaseAnswer&)>& judge,
             const std::function<Utterance()>& ask_alone);

/// Returns the answer in a few characters: "yes", "1 pair", "12 pairs", "0.25 m".
std::string brief(const CaseAnswer& answer);

}  // namespace graze::compare
