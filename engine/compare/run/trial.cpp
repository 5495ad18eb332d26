#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/judge/answer_fault.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/run/trial.h>

#include <array>
#include <cstdio>
#include <exception>
#include <utility>

namespace graze::compare {
namespace {

using Clock = std::chrono::steady_clock;

/// Asks twice: the first query builds what it needs.
std::optional<Testimony> testify(const EngineEntry& entry, const Case& query) {
  LoadedQuestion question;
  const Utterance first = hear(
      [&] {
        question = load_question(*entry.engine, query);
        return question();
      },
      entry.name);
  Testimony testimony;
  testimony.witness = entry.engine->name();
  if (!first.thrown.empty()) testimony.judgement = engine_error("throws " + first.thrown);
  if (!first.answer) return first.thrown.empty() ? std::nullopt : std::optional(testimony);
  const auto start = Clock::now();
  Utterance second = hear(question, entry.name);
  testimony.time = Clock::now() - start;
  testimony.answer = second.answer ? *std::move(second.answer) : *first.answer;
  return testimony;
}

bool is_of_record(const CaseWitness& witness) {
  return witness.engine == "graze" || witness.engine == "referee";
}

/// The referee records no points, only what is true.
bool differs(const CaseAnswer& answer, const Case& query) {
  if (query.answered_by.engine == "graze") return !is_same(answer, *query.answer);
  return answer.says != query.answer->says || answer.pairs != query.answer->pairs ||
         answer.triangles != query.answer->triangles;
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

Utterance hear(const LoadedQuestion& question, const std::string& engine) {
  if (engine == "graze") return {.answer = question()};
  try {
    return {.answer = question()};
  } catch (const Error&) {
    return {};
  } catch (const std::exception& error) {
    const std::string what = error.what();
    return {.thrown = what.empty() ? "without a word" : what};
  }
}

JudgeSettings asking(const Engine& engine) {
  return {.ask_again = [&engine](const Triangle& a, const Triangle& b) -> std::optional<bool> {
    const Case query{.note = "",
                     .ask = Ask::Any,
                     .settings = {},
                     .a = a,
                     .b = b,
                     .answer = std::nullopt,
                     .answered_by = {}};
    try {
      const std::optional<CaseAnswer> answer = ask(engine, query);
      return answer ? answer->says : std::nullopt;
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }};
}

std::vector<Testimony> try_case(const Case& query, std::span<const EngineEntry> engines) {
  std::vector<Testimony> all;
  const Judge judge(query);
  if (query.answer) {
    Testimony recorded;
    recorded.witness = query.answered_by;
    recorded.is_recorded = true;
    recorded.answer = *query.answer;
    // By the claim alone: the engine that is here may be another version of who made it, or only
    // bear its name.
    recorded.judgement = judge.judge(recorded.answer, recorded.witness);
    all.push_back(std::move(recorded));
  }
  for (const EngineEntry& entry : engines) {
    if (entry.engine == nullptr) continue;
    std::optional<Testimony> testimony = testify(entry, query);
    if (!testimony) continue;
    if (!testimony->is_wrong()) {
      testimony->judgement =
          judge.judge(testimony->answer, testimony->witness, asking(*entry.engine));
    }
    if (testimony->is_graze() && query.answer && is_of_record(query.answered_by)) {
      testimony->differs_from_record = differs(testimony->answer, query);
    }
    all.push_back(*std::move(testimony));
  }
  return all;
}

std::string brief(const CaseAnswer& answer) {
  if (answer.says) return *answer.says ? "yes" : "no";
  if (answer.pairs) return counted(answer.pairs->size(), "pair");
  if (answer.triangles) return counted(answer.triangles->size(), "triangle");
  if (answer.contacts) return counted(answer.contacts->size(), "contact");
  if (answer.manifold) return counted(answer.manifold->size(), "contact");
  if (answer.hits) return counted(answer.hits->size(), "hit");
  if (answer.corners) return counted(answer.corners->size(), "corner");
  if (answer.intersection) return counted(answer.intersection->points.size(), "point");
  if (!answer.distance) return "nothing";
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.6g m", *answer.distance);
  return text.data();
}

}  // namespace graze::compare
