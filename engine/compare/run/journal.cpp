#include <graze/engine/cases/case_error.h>
#include <graze/engine/cases/json_text.h>
#include <graze/engine/compare/run/journal.h>
#include <graze/engine/mesh/io/source.h>

#include <limits>

namespace graze::compare {
namespace {

using cases::json_string;
using cases::JsonCursor;

constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kMaxPlaces = std::numeric_limits<std::uint32_t>::max();

std::string names_of(std::span<const EngineEntry> engines) {
  std::string out = "[";
  const char* separator = "";
  for (const EngineEntry& entry : engines) {
    if (entry.engine == nullptr) continue;
    out += separator;
    out += json_string(entry.name);
    separator = ",";
  }
  return out + "]";
}

JournalStart read_start(const JsonCursor& at, const JournalHead& head) {
  at.require_keys({head.kind, "key", "engines", head.unit});
  if (at.member(head.kind).index(kMaxPlaces) != kVersion) {
    at.member(head.kind).fail("is another version");
  }
  JournalStart start;
  start.is_same_job =
      at.member("key").text() == head.key && at.member(head.unit).index(kMaxPlaces) == head.places;
  const JsonCursor engines = at.member("engines");
  for (std::size_t i = 0; i < engines.size(); ++i)
    start.engines.push_back(engines.item(i).text());
  return start;
}

}  // namespace

JournalStart read_journal_lines(const std::filesystem::path& path, const JournalHead& head,
                                const std::function<void(const JsonCursor&)>& on_record) {
  std::optional<JournalStart> start;
  read_lines(path, [&](const JsonCursor& line, std::size_t) {
    if (!start) {
      start = read_start(line, head);
    } else if (start->is_same_job) {
      on_record(line);
    }
  });
  if (start) return *std::move(start);
  throw CaseError(mesh_io::printable(path.string()) + ": is no record of a comparison");
}

LineFile start_journal(const std::filesystem::path& path, const JournalHead& head,
                       std::span<const EngineEntry> engines, std::span<const std::string> records) {
  std::vector<std::string> lines = {
      std::string("{") + json_string(head.kind) + ":" + std::to_string(kVersion) +
      ",\"key\":" + json_string(head.key) + ",\"engines\":" + names_of(engines) + "," +
      json_string(head.unit) + ":" + std::to_string(head.places) + "}"};
  lines.insert(lines.end(), records.begin(), records.end());
  return {path, lines};
}

}  // namespace graze::compare
