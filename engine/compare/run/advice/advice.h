#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/run/shrink_worst.h>

namespace graze::compare {

/// Names what to do about an error.
enum class Remedy {
  Tolerance,  ///< allow for it: no input in double decides it
  Poses,      ///< mind how poses are rounded
  Precision,  ///< look for float on the way
  Triangles,  ///< mend a mesh
  Question,   ///< ask for what is meant: surfaces or solids
  Guard,      ///< be ready for no answer
  Threads,    ///< ask each instance from one thread
  Report,     ///< tell those who make the engine
};

const char* name_of(Remedy remedy);

/// Holds the wrong answers of one engine that have one class, as far as a run has kept them.
struct WrongKind {
  std::string engine;
  std::string version;
  ErrorClass error_class = ErrorClass::Real;
  std::size_t count = 0;
  double largest_error = 0;  ///< metres
  double largest_ulps = 0;
  std::optional<double> tolerance = {};  ///< metres, the tolerance that the engine states
  std::string name_a = "A";              ///< the names of the meshes, for people
  std::string name_b = "B";
  std::span<const WrongAnswer> examples = {};
  /// The least case of it, and the file that it is in; null if none was made.
  const ShrunkCase* least = nullptr;
  std::string file = {};
};

/// Holds a step, in a few sentences.
struct AdviceStep {
  Remedy remedy;
  std::string words;
};

/// Says what to do about one kind of wrong answer.
struct Advice {
  std::string engine;
  std::string kind;  ///< the name of the class, or "not confirmed"
  std::size_t count = 0;
  std::size_t looked_at = 0;      ///< the number of these that were looked at again
  std::vector<AdviceStep> steps;  ///< the steps, the likeliest first
  std::string issue = {};  ///< Markdown for those who make the engine; empty if there is no bug to
                           ///< tell
};

/// Looks at the examples again, at a few of them. Of answers without a query only the sizes count.
Advice advise(const WrongKind& kind);

/// Advises about answers that were right when they were asked for again alone.
Advice advise_unsteady(const std::string& engine, std::size_t count);

}  // namespace graze::compare
