#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/compare/run/record/journal.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/files/source.h>

#include <array>
#include <limits>
#include <utility>

namespace graze::compare {
namespace {

using cases::json_string;
using cases::JsonCursor;

constexpr std::uint32_t kVersion = 2;
constexpr std::int64_t kMostPlaces = std::int64_t{1} << 53;

/// Says what records of each kind are about.
struct Kind {
  const char* name;
  const char* unit;
  const char* subject;
};
constexpr std::array<Kind, 3> kKinds = {{
    {"graze_comparison", "poses", "two meshes"},
    {"graze_scene_comparison", "steps", "a scene"},
    {"graze_case_comparison", "cases", "cases"},
}};

const char* subject_of(std::string_view kind) {
  for (const Kind& each : kKinds) {
    if (kind == each.name) return each.subject;
  }
  return "something else";
}

/// Returns a part with another value, in words; a hash says nothing to people.
std::string difference_of(const JournalPart& here, const std::string& there) {
  constexpr std::size_t kHashLength = 64;
  if (here.value.size() == kHashLength) return "not the same " + here.name;
  return here.name + " " + mesh_io::printable(there) + ", not " + mesh_io::printable(here.value);
}

std::size_t read_size(const JsonCursor& at, std::int64_t least) {
  return static_cast<std::size_t>(at.whole(least, kMostPlaces));
}

JobPart read_part(const JsonCursor& at) {
  at.require_size(2);
  const JobPart part{read_size(at.item(0), 1), read_size(at.item(1), 1)};
  if (part.number > part.count) at.fail("is beyond the last part");
  return part;
}

JournalHead read_head(const JsonCursor& at) {
  JournalHead head;
  for (const Kind& kind : kKinds) {
    if (!at.has(kind.name)) continue;
    head.kind = kind.name;
    head.unit = kind.unit;
  }
  if (head.kind.empty()) at.fail("is no record of a comparison");
  const std::uint32_t version =
      at.member(head.kind).index(std::numeric_limits<std::uint32_t>::max());
  if (version != kVersion) {
    at.member(head.kind).fail("is version " + std::to_string(version) + "; this program reads " +
                              std::to_string(kVersion));
  }
  at.require_keys({head.kind, "key", "asked", "engines", head.unit, "part", "sum"});
  head.key = at.member("key").text();
  const JsonCursor asked = at.member("asked");
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const JsonCursor part = asked.item(i);
    part.require_size(2);
    head.parts.push_back({part.item(0).text(), part.item(1).text()});
  }
  head.places = read_size(at.member(head.unit), 0);
  if (at.has("part")) head.part = read_part(at.member("part"));
  const JsonCursor engines = at.member("engines");
  for (std::size_t i = 0; i < engines.size(); ++i) {
    const JsonCursor engine = engines.item(i);
    engine.require_keys({"name", "version", "answers"});
    head.engines.push_back({engine.member("name").text(), engine.member("version").text(),
                            engine.has("answers") ? engine.member("answers").text() : ""});
  }
  return head;
}

std::string name_of(const JournalEngine& engine) {
  return mesh_io::printable(engine.name + (engine.version.empty() ? "" : " ") + engine.version);
}

std::string part_name(const JobPart& part) {
  return "part " + std::to_string(part.number) + " of " + std::to_string(part.count);
}

constexpr std::string_view kSum = ",\"sum\":\"";
constexpr std::size_t kSumDigits = 16;

}  // namespace

std::vector<JournalEngine> journal_engines(std::span<const EngineEntry> engines) {
  std::vector<JournalEngine> all;
  for (const EngineEntry& entry : engines) {
    if (entry.engine == nullptr) continue;
    all.push_back({entry.name, entry.engine->name().version,
                   entry.recorded ? entry.recorded->digest() : std::string()});
  }
  return all;
}

// The product of two counts may need more than 64 bits.
std::size_t JobPart::end(std::size_t places) const {
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::size_t>(Wide{places} * number / count);
}

std::size_t JobPart::first(std::size_t places) const {
  return JobPart{number - 1, count}.end(places);
}

std::string to_json(const JournalHead& head) {
  const auto part = [](const JournalPart& each) {
    return "[" + json_string(each.name) + "," + json_string(each.value) + "]";
  };
  const auto engine = [](const JournalEngine& each) {
    return "{\"name\":" + json_string(each.name) + ",\"version\":" + json_string(each.version) +
           (each.answers.empty() ? "" : ",\"answers\":" + json_string(each.answers)) + "}";
  };
  std::string line = "{" + json_string(head.kind) + ":" + std::to_string(kVersion) +
                     ",\"key\":" + json_string(head.key) +
                     ",\"asked\":" + cases::json_list(head.parts, ",", part) +
                     ",\"engines\":" + cases::json_list(head.engines, ",", engine) + "," +
                     json_string(head.unit) + ":" + std::to_string(head.places);
  if (!head.part.is_whole()) {
    line += ",\"part\":[" + std::to_string(head.part.number) + "," +
            std::to_string(head.part.count) + "]";
  }
  return line + "}";
}

std::string job_difference(const JournalHead& head, const JournalHead& record) {
  if (record.kind != head.kind) {
    return std::string("it is of ") + subject_of(record.kind) + ", not of " + subject_of(head.kind);
  }
  std::string out;
  const auto add = [&](const std::string& what) { out += (out.empty() ? "" : "; ") + what; };
  for (const JournalPart& part : head.parts) {
    std::string there = "unknown";
    for (const JournalPart& its : record.parts)
      if (its.name == part.name) there = its.value;
    if (there != part.value) add(difference_of(part, there));
  }
  if (record.places != head.places) {
    add(std::to_string(record.places) + " " + head.unit + ", not " + std::to_string(head.places));
  }
  if (out.empty() && record.key != head.key) {
    add("its key is no sum of what it says that it is of");
  }
  if (out.empty() && !(record.part == head.part)) {
    add("it is " + part_name(record.part) + ", not " + part_name(head.part));
  }
  return out;
}

std::string engine_difference(const JournalHead& head, const JournalHead& record) {
  if (record.engines == head.engines) return "";
  std::string names;
  for (const JournalEngine& engine : record.engines)
    names += (names.empty() ? "" : ", ") + name_of(engine);
  const bool are_named_alike = [&] {
    if (record.engines.size() != head.engines.size()) return false;
    for (std::size_t i = 0; i < head.engines.size(); ++i)
      if (name_of(record.engines[i]) != name_of(head.engines[i])) return false;
    return true;
  }();
  return are_named_alike ? "it is of other recorded answers" : "it is of other engines: " + names;
}

std::string sealed(std::string_view line) {
  std::string out(line.substr(0, line.size() - 1));
  const std::string sum = files::sha256_of(out).substr(0, kSumDigits);
  out += kSum;
  out += sum;
  return out + "\"}";
}

JournalReader::JournalReader(const std::filesystem::path& path)
    : path_(path), file_(path, std::ios::binary) {
  const std::string name = mesh_io::printable(path.string());
  if (!file_) throw CaseError(name + ": cannot be read");
  std::string line;
  const auto is_sealed = [](const std::string& text) { return text.find("\"sum\"") != text.npos; };
  if (!std::getline(file_, line) || file_.eof()) {
    throw CaseError(name + ": is no record of a comparison");
  }
  place_ = name + ":" + std::to_string(++number_);
  bytes_ = line.size() + 1;
  const cases::JsonValue tree = cases::parse_json(line, place_);
  head_ = read_head(JsonCursor(tree, place_));
  if (!is_sealed(line) || sealed(to_json(head_)) != line) {
    throw CaseError(place_ + ": is damaged: its sum is another");
  }
}

bool JournalReader::next(std::string& line) {
  if (!std::getline(file_, line) || file_.eof()) {
    if (file_.bad()) {
      throw CaseError(mesh_io::printable(path_.string()) + ": cannot be read to its end");
    }
    return false;
  }
  place_ = mesh_io::printable(path_.string()) + ":" + std::to_string(++number_);
  bytes_ += line.size() + 1;
  const std::size_t tail = kSum.size() + kSumDigits + 2;
  const bool is_whole =
      line.size() > tail && sealed(line.substr(0, line.size() - tail) + "}") == line;
  if (!is_whole) throw CaseError(place_ + ": is damaged: its sum is another");
  return true;
}

}  // namespace graze::compare
