#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/record/answer_record.h>

namespace graze::compare {

/// Holds a wrong answer, and how to ask again.
struct WrongAnswer {
  std::size_t place = 0;  ///< the pose, the step or the case
  std::string where;      ///< the place for people: "7", "3: gear, pinion"
  std::string name;       ///< a part of a file's name: "bolt-nut-fcl-any-pose7"
  std::shared_ptr<const AnswerRecord> answer = nullptr;
  std::function<Case()> query = {};
  std::string origin = {};  ///< the file that the query came from, if it came from one
};

/// True if the first is worse: graze's are, then the class decides, then what comes before.
bool is_worse(const WrongAnswer& a, const WrongAnswer& b);

/// Holds a wrong answer as small as it could be made, with what the referee says of that.
struct ShrunkCase {
  std::string engine;
  std::size_t wrong = 0;  ///< index into the list that it was made from
  Case query;             ///< the query with the engine's wrong answer
  Judgement judgement;
  bool is_smaller = true;   ///< than the query, or shorter; if not, it is the query
  bool is_stopped = false;  ///< true if the time was over before it was known to be the least
};

struct ShrinkWorstSettings {
  std::size_t limit = 16;                  ///< the number of cases at most
  std::chrono::duration<double> time{10};  ///< seconds for all of them; with 0 they are left as
                                           ///< they are

  /// Called with each case as soon as there is anything to keep: its guilty pair of triangles,
  /// or all of it before what may take long; then as it gets smaller, now and then, and at its end.
  std::function<void(const ShrunkCase&)> on_case = {};

  /// Called with each case at its end, after on_case.
  std::function<void(ShrunkCase)> on_done = {};

  /// Called before each question with how many cases are done.
  std::function<void(std::size_t done)> on_progress = {};
};

/// Says in words that each triangle of two meshes is needed, if they are more than a triangle each:
/// some engines are wrong only about surfaces of several. Empty if the time was over before.
std::string least_size(const ShrunkCase& shrunk);

/// Shrinks the worst: those of graze first, then by their class, then in the order of places.
/// Engines that are not in the list ("world") cannot be asked, and no case is made for them; a
/// recorded answer is kept as a case of the whole query. A query that does not show the error again
/// is left as it is. Each case may take a quarter of the time that is left, and the last ones an
/// equal share of it. The two triangles alone are always tried, and a question that is asked is
/// waited for, so that a case may take one question longer.
void shrink_worst(std::span<const WrongAnswer> wrong, std::span<const EngineEntry> engines,
                  const ShrinkWorstSettings& settings = {});

}  // namespace graze::compare
