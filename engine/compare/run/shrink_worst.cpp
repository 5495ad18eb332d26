#include <graze/bvh/error.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/judge/shrink/shrink.h>
#include <graze/engine/compare/run/shrink_worst.h>
#include <graze/engine/compare/run/trial.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

namespace graze::compare {
namespace {

using Clock = std::chrono::steady_clock;

/// Most cases take next to no time, so one that takes long may have a quarter of what is left.
constexpr std::size_t kMostSharers = 4;

/// A time beyond what a clock can count is for ever.
constexpr double kMostSeconds = 1e8;

auto rank_of(const WrongAnswer& wrong) {
  const AnswerRecord& answer = *wrong.answer;
  return std::tuple(answer.engine != "graze", -static_cast<int>(answer.judgement.error_class),
                    wrong.place, answer.engine);
}

/// True if a smaller query shows the same error: of the same class, and no larger. A gap that grows
/// while coordinates get shorter would be another error.
bool is_same_error(const Judgement& smaller, const Judgement& before) {
  return smaller.verdict == Verdict::Wrong && smaller.error_class == before.error_class &&
         !(smaller.error > before.error);
}

/// Returns the triangles that show the error. A record from a file may name some that the meshes do
/// not have.
std::optional<TrianglePair> culprit_of(const Case& query, const AnswerRecord& answer) {
  const std::optional<TrianglePair>& culprit = answer.judgement.culprit;
  const std::optional<MeshCase> meshes = as_meshes(query);
  const bool is_there = culprit && meshes && culprit->a < meshes->a.mesh.triangles().size() &&
                        culprit->b < meshes->b.mesh.triangles().size();
  return is_there ? culprit : std::nullopt;
}

std::size_t triangle_count(const Case& query) {
  const std::optional<MeshCase> meshes = as_meshes(query);
  return meshes ? meshes->a.mesh.triangles().size() + meshes->b.mesh.triangles().size() : 0;
}

bool is_same_query(const Case& a, const Case& b) {
  if (triangle_count(a) != triangle_count(b)) return false;  // without writing thousands of them
  const auto question_of = [](Case query) {
    query.note.clear();
    query.answer.reset();
    return to_json(query);
  };
  return question_of(a) == question_of(b);
}

/// Shrinks one wrong answer to a case, which may be looked at all the time.
class OneShrinking {
 public:
  OneShrinking(const WrongAnswer& wrong, std::size_t index, const Engine& engine,
               Clock::time_point deadline, const ShrinkWorstSettings& settings)
      : answer_(*wrong.answer),
        engine_(engine),
        deadline_(deadline),
        settings_(settings),
        whole_(wrong.query()),
        best_{answer_.engine, index, whole_, answer_.judgement, false} {
    best_.query.answer.reset();
    best_.query.answered_by = {answer_.engine, engine.name().version};
  }

  ShrunkCase run(const std::function<void()>& on_question) {
    if (settings_.time.count() <= 0) {
      keep_whole();
      best_.is_stopped = true;
    } else {
      shrink(whole_, culprit_of(whole_, answer_),
             [&](const Case& smaller) {
               on_question();
               return is_still_wrong(smaller);
             },
             {.before_search = [&] { keep_whole(); }});
      if (is_shown_) {
        confirm_alone();
      } else if (!best_.is_stopped) {
        look_again();
      }
    }
    tell();
    return std::move(best_);
  }

 private:
  static constexpr std::chrono::milliseconds kTellInterval{500};

  Judgement judged(const Case& query, const Engine& asked) {
    const Utterance said = hear([&] { return ask(asked, query); }, "");
    said_ = said.answer;
    if (!said.fault.empty()) return engine_error(said.fault);
    return said.answer ? Judge(query).judge(*said.answer, best_.query.answered_by) : Judgement();
  }

  /// True if a query is wrong for the same reason: rounding coordinates could make a real error one
  /// of touching.
  bool is_still_wrong(const Case& smaller) {
    const bool is_bound = is_shown_ || is_searching_;
    if (is_bound && Clock::now() >= deadline_) {
      best_.is_stopped = true;
      throw ShrinkingStopped();
    }
    try {
      const Judgement judgement = judged(smaller, engine_);
      if (!is_same_error(judgement, answer_.judgement)) return false;
      best_.judgement = judgement;
    } catch (const Error&) {  // graze's meshes have no such query
      return false;
    }
    const CaseWitness witness = best_.query.answered_by;
    best_.query = smaller;
    best_.query.answer = said_;
    best_.query.answered_by = witness;
    is_shown_ = true;
    if (Clock::now() >= next_told_) tell();
    return true;
  }

  /// Keeps the whole query, before anything that may take long.
  void keep_whole() {
    is_searching_ = true;
    best_.query.answer = hear([&] { return ask(alone(), whole_); }, "").answer;
    tell();
  }

  /// Confirms what is left alone, as hundreds of smaller queries were asked one after the other. If
  /// the engine is right there, the whole query is the case.
  void confirm_alone() {
    const Judgement judgement = judged(best_.query, alone());
    if (judgement.verdict == Verdict::Wrong) {
      best_.judgement = judgement;
      best_.query.answer = said_;
      return;
    }
    is_shown_ = false;
    const CaseWitness witness = best_.query.answered_by;
    best_.query = whole_;
    best_.query.answered_by = witness;
    look_again();
  }

  /// Asks again about the whole query, as nothing smaller shows it: perhaps the whole does no
  /// longer either.
  void look_again() {
    best_.judgement = judged(whole_, alone());
    best_.query.answer = said_;
  }

  void tell() {
    best_.is_smaller = is_shown_ && !is_same_query(best_.query, whole_);
    if (settings_.on_case) settings_.on_case(best_);
    next_told_ = Clock::now() + kTellInterval;
  }

  const Engine& alone() const { return alone_ ? *alone_ : engine_; }

  const AnswerRecord& answer_;
  const Engine& engine_;
  std::unique_ptr<Engine> alone_ = engine_.alone();  ///< null if the engine is like that itself
  Clock::time_point deadline_;
  const ShrinkWorstSettings& settings_;
  Case whole_;
  ShrunkCase best_;
  std::optional<CaseAnswer> said_;  ///< the answer to the last question
  bool is_shown_ = false;           ///< true if something smaller, or shorter, shows it
  bool is_searching_ = false;
  Clock::time_point next_told_ = {};
};

}  // namespace

namespace {

/// Returns a recorded answer as it is: nobody can be asked about less.
ShrunkCase recorded_case(const WrongAnswer& wrong, std::size_t index, const EngineEntry& entry) {
  ShrunkCase whole{entry.name, index, wrong.query(), wrong.answer->judgement, false};
  const Utterance said = hear([&] { return entry.recorded->at(wrong.place); }, kRecorded);
  whole.query.answer = said.answer;
  whole.query.answered_by = entry.engine->name();
  return whole;
}

}  // namespace

bool is_worse(const WrongAnswer& a, const WrongAnswer& b) {
  return rank_of(a) < rank_of(b);
}

std::string least_size(const ShrunkCase& shrunk) {
  const std::optional<MeshCase> meshes = as_meshes(shrunk.query);
  if (!meshes) return "";
  const std::size_t count_a = meshes->a.mesh.triangles().size();
  const std::size_t count_b = meshes->b.mesh.triangles().size();
  if (count_a + count_b <= 2 || shrunk.is_stopped) return "";
  return std::string("cannot be shrunk further: ") + std::to_string(count_a) + " and " +
         std::to_string(count_b) + " triangles, and without any one of them " + shrunk.engine +
         " is not wrong like this";
}

void shrink_worst(std::span<const WrongAnswer> wrong, std::span<const EngineEntry> engines,
                  const ShrinkWorstSettings& settings) {
  const auto entry_of = [&](std::size_t i) -> const EngineEntry* {
    const auto entry = std::find_if(
        engines.begin(), engines.end(),
        [&](const EngineEntry& candidate) { return candidate.name == wrong[i].answer->engine; });
    return entry == engines.end() || entry->engine == nullptr ? nullptr : &*entry;
  };
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < wrong.size(); ++i)
    if (entry_of(i) != nullptr) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(rank_of(wrong[a]), a) < std::pair(rank_of(wrong[b]), b);
  });
  order.resize(std::min(order.size(), settings.limit));

  using Seconds = std::chrono::duration<double>;
  const Clock::time_point start = Clock::now();
  for (std::size_t n = 0; n < order.size(); ++n) {
    const Clock::time_point now = Clock::now();
    const Seconds left = settings.time - Seconds(now - start);
    const std::size_t sharers = std::min(order.size() - n, kMostSharers);
    const Seconds share = std::min(left / sharers, Seconds(kMostSeconds));
    const EngineEntry& entry = *entry_of(order[n]);
    if (entry.recorded) {
      ShrunkCase whole = recorded_case(wrong[order[n]], order[n], entry);
      if (settings.on_case) settings.on_case(whole);
      if (settings.on_done) settings.on_done(std::move(whole));
      continue;
    }
    OneShrinking one(wrong[order[n]], order[n], *entry.engine,
                     now + std::chrono::duration_cast<Clock::duration>(share), settings);
    ShrunkCase shrunk = one.run([&] {
      if (settings.on_progress) settings.on_progress(n);
    });
    if (settings.on_done) settings.on_done(std::move(shrunk));
  }
}

}  // namespace graze::compare
