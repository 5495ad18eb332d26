#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/run/trial.h>

#include <array>
#include <cstdio>
#include <exception>
#include <utility>

namespace graze::compare {
namespace {

/// Asks twice: the first query builds what it needs.
Utterance hear_twice(const EngineEntry& entry, const Case& query) {
  LoadedQuestion question;
  Utterance first = hear(
      [&] {
        question = load_question(*entry.engine, query);
        return question();
      },
      entry.name);
  if (!first.answer) return first;
  Utterance second = hear(question, entry.name);
  return second.answer || !second.fault.empty() ? second : first;
}

bool is_of_record(const CaseWitness& witness) {
  return witness.engine == "graze" || witness.engine == "referee";
}

/// Returns an answer without the details that a record leaves out: one made by hand names no
/// points.
CaseAnswer as_far_as(const CaseAnswer& record, CaseAnswer answer) {
  if (!record.lower_bound) answer.lower_bound.reset();
  if (!record.is_converged) answer.is_converged.reset();
  if (!record.normal) answer.normal.reset();
  if (!record.point_a) answer.point_a.reset();
  if (!record.point_b) answer.point_b.reset();
  if (!record.pair) answer.pair.reset();
  return answer;
}

/// True if an answer differs from the recorded one. The referee records no points. Where law 11
/// lets shapes touch a little sooner than they do, both answers are right, and neither is a change.
bool differs(const Testimony& said, const Testimony& recorded) {
  const CaseAnswer &answer = said.answer, &record = recorded.answer;
  if (recorded.witness.engine == "graze") return !is_same(as_far_as(record, answer), record);
  const auto is_right = [](const Testimony& t) { return t.judgement.verdict == Verdict::Right; };
  if (is_right(said) && is_right(recorded)) return false;
  return answer.says != record.says || answer.pairs != record.pairs ||
         answer.triangles != record.triangles;
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Returns "free", "hit at 0.25", "close from 0.5 on".
std::string brief_contact(const CaseAnswer& answer) {
  const bool is_hit = *answer.status == RigidStatus::Hit;
  const std::optional<double>& time = is_hit ? answer.high : answer.low;
  if (*answer.status == RigidStatus::Free || !time) return name_of(*answer.status);
  std::array<char, 48> text;
  std::snprintf(text.data(), text.size(), is_hit ? "hit at %.6g" : "close from %.6g on", *time);
  return text.data();
}

}  // namespace

Utterance hear(const LoadedQuestion& question, const std::string& engine) {
  const auto heard = [&] {
    TimedAnswer timed = question();
    return Utterance{.answer = std::move(timed.answer), .time = timed.time};
  };
  if (engine == "graze") return heard();
  try {
    return heard();
  } catch (const EngineMissingError&) {
    throw;
  } catch (const Error&) {
    return {};
  } catch (const EngineFailure& failure) {
    return {.fault = failure.what()};
  } catch (const std::exception& error) {
    const std::string what = error.what();
    return {.fault = "throws " + (what.empty() ? "without a word" : what)};
  }
}

Utterance hear_alone(const EngineEntry& entry, const Case& query) {
  return hear(
      [&] {
        const std::unique_ptr<Engine> alone = entry.engine->alone();
        return load_question(alone ? *alone : *entry.engine, query)();
      },
      entry.name);
}

Heard judged(const std::string& engine, Utterance said,
             const std::function<Judgement(const CaseAnswer&)>& judge,
             const std::function<Utterance()>& ask_alone) {
  const auto judgement_of = [&](const Utterance& what) {
    if (!what.fault.empty()) return engine_error(what.fault);
    return what.answer ? judge(*what.answer) : Judgement();
  };
  Heard first{std::move(said), {}};
  first.judgement = judgement_of(first.said);
  if (first.judgement.verdict != Verdict::Wrong || engine == "graze") return first;
  Heard again{ask_alone(), {}};
  if (first.said.answer && again.said.answer && is_same(*first.said.answer, *again.said.answer)) {
    return first;
  }
  again.judgement = judgement_of(again.said);
  if (again.judgement.verdict == Verdict::Wrong) {
    again.said.time = first.said.time;
    return again;
  }
  const std::string alone = again.said.answer ? brief(*again.said.answer) : "nothing";
  first.judgement.verdict = Verdict::NotConfirmed;
  first.judgement.truth += "; alone it says: " + alone;
  return first;
}

std::vector<Testimony> try_case(const Case& query, std::span<const EngineEntry> engines) {
  std::vector<Testimony> all;
  const Judge judge(query);
  if (query.answer) {
    Testimony recorded;
    recorded.witness = query.answered_by;
    recorded.is_recorded = true;
    recorded.answer = *query.answer;
    recorded.judgement = judge.judge(recorded.answer, recorded.witness);
    all.push_back(std::move(recorded));
  }
  for (const EngineEntry& entry : engines) {
    if (entry.engine == nullptr) continue;
    Utterance said = hear_twice(entry, query);
    if (!said.answer && said.fault.empty()) continue;
    Testimony testimony;
    testimony.witness = entry.engine->name();
    Heard heard = judged(
        entry.name, std::move(said),
        [&](const CaseAnswer& answer) { return judge.judge(answer, testimony.witness); },
        [&] { return hear_alone(entry, query); });
    testimony.answer = std::move(heard.said.answer).value_or(CaseAnswer());
    testimony.time = heard.said.time;
    testimony.judgement = heard.judgement;
    if (testimony.is_graze() && query.answer && is_of_record(query.answered_by)) {
      testimony.differs_from_record = differs(testimony, all.front());
    }
    all.push_back(std::move(testimony));
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
  if (answer.status) return brief_contact(answer);
  if (answer.intersection) return counted(answer.intersection->points.size(), "point");
  if (!answer.distance) return "nothing";
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.6g m", *answer.distance);
  return text.data();
}

}  // namespace graze::compare
