#pragma once

#include <map>
#include <string>
#include <vector>

#include <graze/engine/record/recording.h>

namespace graze::cli {

/// True if a file begins as a recording does. A file that cannot be read is no recording.
bool is_recording(const std::string& file);

/// Says how bodies are called: by the names that the recording has for them, else by their indices.
class RecordedNames {
 public:
  /// Takes note of names, and of bodies that are gone.
  void note(const std::vector<RecordedChange>& changes);
  std::string of(BodyId id) const;

 private:
  std::map<BodyId, std::string> names_;
};

}  // namespace graze::cli
