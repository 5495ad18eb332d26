#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/comparison.h>

namespace graze::compare {

/// Says what the answers of a file must be about.
struct AnswersWanted {
  std::filesystem::path mesh_a;  ///< A's file, a mesh or a shape: answers may have its bytes' sum
  std::filesystem::path mesh_b;  ///< B's file, a mesh or a shape
  const ComparisonJob& job;
};

/// Holds answers that an engine gave elsewhere, a line a pose behind one that says what they are
/// about: JSON, or CSV where the name ends so (README.md). Each is read again when it is heard, so
/// that memory does not grow with them; the file must not change meanwhile.
struct AnswerFile {
  CaseWitness witness;  ///< who gave them, as the first line says
  std::shared_ptr<const RecordedAnswers> answers;
  std::optional<double> tolerance = {};  ///< as Engine::tolerance()
};

/// Looks at every line. Throws CaseError `file:line: why` for a first line of other meshes, another
/// question, other settings, for lines that cannot be read, and for more or fewer lines than the
/// job has poses. A line that is no answer to the question counts as one, and as the engine's
/// error.
AnswerFile read_answer_file(const std::filesystem::path& path, const AnswersWanted& wanted);

}  // namespace graze::compare
