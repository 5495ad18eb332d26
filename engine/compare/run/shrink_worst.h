#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/answer_record.h>

namespace graze::compare {

/// A wrong answer, and how to ask again.
struct WrongAnswer {
  std::size_t place = 0;                 ///< the pose, the step or the case
  std::string where;                     ///< the same for people: "7", "3: gear, pinion"
  std::string name;                      ///< the same in the name of a file: "any-7", "step3-0-2"
  const AnswerRecord* answer = nullptr;  ///< refers to a record
  std::function<Case()> query = {};
  std::string origin = {};  ///< the file that the query came from, if it came from one
};

/// A wrong answer as small as it could be made, with what the referee says of that.
struct ShrunkCase {
  std::string engine;
  std::size_t wrong = 0;  ///< index into the list that it was made from
  Case query;             ///< with the engine's wrong answer
  Judgement judgement;
  bool is_smaller = true;  ///< than the query, or shorter; if not, it is the query
};

/// Of two meshes that are more than a triangle each: that each triangle is needed, in words. Some
/// engines are wrong only about surfaces of several.
std::string least_size(const ShrunkCase& shrunk);

/// Shrinks the `limit` worst: those of graze first, then by their class, then in the order of
/// places. Of engines that are not in the list ("world", recorded answers) nothing can be asked.
/// What cannot be shown again is left as it is.
std::vector<ShrunkCase> shrink_worst(std::span<const WrongAnswer> wrong,
                                     std::span<const EngineEntry> engines, std::size_t limit);

}  // namespace graze::compare
