#include <graze/bvh/error.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/judge/answer_fault.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/shrink.h>
#include <graze/engine/compare/run/shrink_worst.h>
#include <graze/engine/compare/run/trial.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace graze::compare {
namespace {

auto rank_of(const WrongAnswer& wrong) {
  const AnswerRecord& answer = *wrong.answer;
  return std::tuple(answer.engine != "graze", -static_cast<int>(answer.judgement.error_class),
                    wrong.place, answer.engine);
}

/// Errors of rounding are of one kind: without its poses one of placing becomes one of touching.
bool is_same_kind(ErrorClass a, ErrorClass b) {
  return a == b || (a <= ErrorClass::PoseRounding && b <= ErrorClass::PoseRounding);
}

/// A record from a file may name triangles that the meshes do not have.
std::optional<TrianglePair> culprit_of(const Case& query, const AnswerRecord& answer) {
  const std::optional<TrianglePair>& culprit = answer.judgement.culprit;
  const std::optional<MeshCase> meshes = as_meshes(query);
  const bool is_there = culprit && meshes && culprit->a < meshes->a.mesh.triangles().size() &&
                        culprit->b < meshes->b.mesh.triangles().size();
  return is_there ? culprit : std::nullopt;
}

bool is_same_query(const Case& a, const Case& b) {
  const auto question_of = [](Case query) {
    query.note.clear();
    query.answer.reset();
    return to_json(query);
  };
  return question_of(a) == question_of(b);
}

/// Wrong for the same reason: rounding coordinates could make a real error of one of touching.
ShrunkCase shrink_one(const WrongAnswer& wrong, const Engine& engine) {
  const AnswerRecord& answer = *wrong.answer;
  const CaseWitness witness = {answer.engine, engine.name().version};
  const auto judged = [&](const Case& query) {
    const Utterance said = hear([&] { return ask(engine, query); }, "");
    if (!said.fault.empty()) return engine_error(said.fault);
    return said.answer ? Judge(query).judge(*said.answer, witness, asking(engine)) : Judgement();
  };
  const StillWrong is_still_wrong = [&](const Case& smaller) {
    try {
      const Judgement judgement = judged(smaller);
      return judgement.verdict == Verdict::Wrong &&
             is_same_kind(judgement.error_class, answer.judgement.error_class);
    } catch (const Error&) {  // of graze's meshes: no such query
      return false;
    }
  };
  const Case query = wrong.query();
  Case small = shrink(query, culprit_of(query, answer), is_still_wrong);
  const bool is_smaller = !is_same_query(small, query);
  small.answer = hear([&] { return ask(engine, small); }, "").answer;
  small.answered_by = witness;
  const Judgement judgement = judged(small);
  return {answer.engine, 0, std::move(small), judgement, is_smaller};
}

}  // namespace

std::string least_size(const ShrunkCase& shrunk) {
  const std::optional<MeshCase> meshes = as_meshes(shrunk.query);
  if (!meshes) return "";
  const std::size_t count_a = meshes->a.mesh.triangles().size();
  const std::size_t count_b = meshes->b.mesh.triangles().size();
  if (count_a + count_b <= 2) return "";
  return std::string("cannot be shrunk further: ") + std::to_string(count_a) + " and " +
         std::to_string(count_b) + " triangles, and without any one of them " + shrunk.engine +
         " is not wrong like this";
}

std::vector<ShrunkCase> shrink_worst(std::span<const WrongAnswer> wrong,
                                     std::span<const EngineEntry> engines, std::size_t limit) {
  std::vector<std::size_t> order(wrong.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(rank_of(wrong[a]), a) < std::pair(rank_of(wrong[b]), b);
  });
  std::vector<ShrunkCase> shrunk;
  for (const std::size_t i : order) {
    if (shrunk.size() == limit) break;
    const auto entry = std::find_if(
        engines.begin(), engines.end(),
        [&](const EngineEntry& candidate) { return candidate.name == wrong[i].answer->engine; });
    if (entry == engines.end() || entry->engine == nullptr) continue;
    shrunk.push_back(shrink_one(wrong[i], *entry->engine));
    shrunk.back().wrong = i;
  }
  return shrunk;
}

}  // namespace graze::compare
