#pragma once

#include <chrono>
#include <span>
#include <vector>

#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// What one engine answered to a case, and what the referee says of that.
struct Testimony {
  CaseWitness witness;
  bool is_recorded = false;  ///< the answer stands in the case; no engine was asked
  CaseAnswer answer;
  std::chrono::duration<double, std::micro> time{0};  ///< of the query, with its trees built
  Judgement judgement;
  /// Of graze, where the case holds an answer that graze or the referee gave: whether the two are
  /// not the same, bit for bit. That is no error: a bug that was fixed is kept as a case too.
  bool differs_from_record = false;

  bool is_wrong() const { return judgement.verdict == Verdict::Wrong; }
  bool is_graze() const { return witness.engine == "graze" && !is_recorded; }
};

/// Puts a case to every engine that is here and knows such questions, and judges their answers and
/// the recorded one, which comes first. Throws what graze throws; other engines that refuse a mesh
/// are left out, and one that throws anything else is wrong.
std::vector<Testimony> try_case(const Case& query, std::span<const EngineEntry> engines);

/// What an engine answers, or that it throws what is no refusal.
struct Utterance {
  std::optional<CaseAnswer> answer = {};
  std::string thrown = {};
};

/// Asks. A refusal, an Error of the adaptor's, is no answer; whatever else an engine other than
/// graze throws is told. What graze throws is thrown on.
Utterance hear(const LoadedQuestion& question, const std::string& engine);

/// The engine, asked about two triangles by the judge who wants to know why it was wrong. It must
/// outlive the result.
JudgeSettings asking(const Engine& engine);

/// The answer in a few characters: "yes", "1 pair", "12 pairs", "0.25 m".
std::string brief(const CaseAnswer& answer);

}  // namespace graze::compare
