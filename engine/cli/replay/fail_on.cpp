#include <graze/engine/cli/output/outcome.h>
#include <graze/engine/cli/replay/fail_on.h>
#include <graze/engine/compare/run/case_comparison.h>
#include <graze/engine/files/source.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

namespace graze::cli {
namespace {

using compare::EngineEntry;
using compare::ErrorClass;

std::string hyphenated(std::string_view name) {
  std::string out(name);
  std::replace(out.begin(), out.end(), ' ', '-');
  return out;
}

ErrorClass class_named(std::string_view name) {
  std::string known;
  for (const ErrorClass each : compare::kErrorClasses) {
    const std::string its = hyphenated(name_of(each));
    if (hyphenated(name) == its) return each;
    known += (known.empty() ? "" : ", ") + its;
  }
  throw UsageError("--fail-on: there is no class " + mesh_io::quoted(name) + ", but " + known);
}

/// Takes the size behind the last `>`, with that mark; nothing if there is none.
std::optional<double> take_size(std::string& word) {
  const std::size_t at = word.rfind('>');
  if (at == word.npos) return std::nullopt;
  double size = 0;
  const char* end = word.data() + word.size();
  const auto [rest, error] = std::from_chars(word.data() + at + 1, end, size);
  if (error != std::errc() || rest != end || !(size >= 0) || !std::isfinite(size)) {
    throw UsageError("--fail-on: " + mesh_io::quoted(word.substr(at + 1)) +
                     " is no size in metres");
  }
  word.resize(at);
  return size;
}

/// Returns the names that can match something, in the order in which a refusal lists them.
std::vector<std::string> known_engines(std::span<const EngineEntry> engines,
                                       const std::vector<std::string>& recorded_engines) {
  std::vector<std::string> known = {compare::kRecorded};
  for (const EngineEntry& entry : engines)
    if (entry.engine != nullptr) known.push_back(entry.name);
  const std::set<std::string> recorded(recorded_engines.begin(), recorded_engines.end());
  for (const std::string& name : recorded) {
    const bool is_new = std::find(known.begin(), known.end(), name) == known.end();
    if (is_new && !name.empty()) known.push_back(name);
  }
  return known;
}

}  // namespace

FailOn::FailOn(std::span<const std::string> words, std::span<const EngineEntry> engines,
               const std::vector<std::string>& recorded_engines) {
  const std::vector<std::string> known = known_engines(engines, recorded_engines);
  const auto is_known = [&](std::string_view name) {
    return std::find(known.begin(), known.end(), name) != known.end();
  };
  for (std::string word : words) {
    // The name of an engine in a file may hold anything; that of a class holds no colon.
    const std::optional<double> above = is_known(word) ? std::nullopt : take_size(word);
    const std::size_t colon = is_known(word) ? word.npos : word.rfind(':');
    const std::string name = word.substr(0, colon);
    if (!is_known(name)) {
      const bool is_absent = std::any_of(engines.begin(), engines.end(),
                                         [&](const EngineEntry& e) { return e.name == name; });
      if (is_absent) {
        throw UsageError("--fail-on: " + name + " was not found when this command was built");
      }
      std::string names;
      for (const std::string& each : known)
        names += (names.empty() ? "" : ", ") + mesh_io::printable(each);
      throw UsageError("--fail-on: there is no engine " + mesh_io::quoted(name) + ", but " + names);
    }
    Rule rule{name, std::nullopt, above};
    if (colon != word.npos) {
      const std::string_view kind = std::string_view(word).substr(colon + 1);
      rule.is_change = kind == "changed" && !above;
      if (!rule.is_change) rule.error_class = class_named(kind);
    }
    rules_.push_back(std::move(rule));
  }
}

bool FailOn::matches(const compare::Testimony& testimony) const {
  if (!testimony.is_wrong()) return false;
  return matches(testimony.witness.engine, testimony.judgement) ||
         (testimony.is_recorded && matches(compare::kRecorded, testimony.judgement));
}

bool FailOn::matches(const std::string& engine, const compare::Judgement& judgement) const {
  return std::any_of(rules_.begin(), rules_.end(), [&](const Rule& rule) {
    return rule.engine == engine && !rule.is_change &&
           (!rule.error_class || *rule.error_class == judgement.error_class) &&
           (!rule.above || judgement.error > *rule.above);
  });
}

bool FailOn::names_changes() const {
  return std::any_of(rules_.begin(), rules_.end(), [](const Rule& rule) { return rule.is_change; });
}

bool FailOn::matches_change(const std::string& engine) const {
  return std::any_of(rules_.begin(), rules_.end(),
                     [&](const Rule& rule) { return rule.engine == engine && rule.is_change; });
}

}  // namespace graze::cli
