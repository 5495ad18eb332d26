#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/compare/run/journal.h>
#include <graze/engine/files/source.h>

#include <array>
#include <limits>
#include <string_view>
#include <utility>

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

/// What records of each kind are of.
constexpr std::array<std::pair<const char*, const char*>, 3> kKinds = {{
    {"graze_comparison", "two meshes"},
    {"graze_scene_comparison", "a scene"},
    {"graze_case_comparison", "cases"},
}};

const char* subject_of(std::string_view kind) {
  for (const auto& [name, subject] : kKinds) {
    if (kind == name) return subject;
  }
  return "something else";
}

/// A part with another value, in words; a hash says nothing to people.
std::string difference_of(const JournalPart& here, const std::string& there) {
  constexpr std::size_t kHashLength = 64;
  if (here.value.size() == kHashLength) return "not the same " + here.name;
  return here.name + " " + mesh_io::printable(there) + ", not " + here.value;
}

/// What the job is about there and is not here.
std::string differences(const JsonCursor& at, const JournalHead& head) {
  std::string out;
  const auto add = [&](const std::string& what) { out += (out.empty() ? "" : "; ") + what; };
  if (!at.has("asked")) return "it is of an older graze and does not say of what";
  const JsonCursor asked = at.member("asked");
  for (const JournalPart& part : head.parts) {
    const std::string there = asked.has(part.name) ? asked.member(part.name).text() : "unknown";
    if (there != part.value) add(difference_of(part, there));
  }
  const std::uint32_t places = at.member(head.unit).index(kMaxPlaces);
  if (places != head.places) {
    add(std::to_string(places) + " " + head.unit + ", not " + std::to_string(head.places));
  }
  return out.empty() ? "its key is no sum of what it says that it is of" : out;
}

JournalStart read_start(const JsonCursor& at, const JournalHead& head) {
  JournalStart start;
  for (const auto& [kind, subject] : kKinds) {
    if (kind == head.kind || !at.has(kind)) continue;
    start.difference = std::string("it is of ") + subject + ", not of " + subject_of(head.kind);
    return start;
  }
  at.require_keys({head.kind, "key", "asked", "engines", head.unit});
  const std::uint32_t version = at.member(head.kind).index(kMaxPlaces);
  if (version != kVersion) {
    at.member(head.kind).fail("is version " + std::to_string(version) + "; this program reads " +
                              std::to_string(kVersion));
  }
  start.is_same_job =
      at.member("key").text() == head.key && at.member(head.unit).index(kMaxPlaces) == head.places;
  if (!start.is_same_job) start.difference = differences(at, head);
  const JsonCursor engines = at.member("engines");
  for (std::size_t i = 0; i < engines.size(); ++i)
    start.engines.push_back(engines.item(i).text());
  return start;
}

std::string parts_of(const JournalHead& head) {
  std::string out = "{";
  for (const JournalPart& part : head.parts) {
    if (out.size() > 1) out += ",";
    out += json_string(part.name) + ":" + json_string(part.value);
  }
  return out + "}";
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
      std::string("{") + json_string(head.kind) + ":" + std::to_string(kVersion) + ",\"key\":" +
      json_string(head.key) + ",\"asked\":" + parts_of(head) + ",\"engines\":" + names_of(engines) +
      "," + json_string(head.unit) + ":" + std::to_string(head.places) + "}"};
  lines.insert(lines.end(), records.begin(), records.end());
  return {path, lines};
}

}  // namespace graze::compare
