#include <graze/engine/cases/case_error.h>
#include <graze/engine/cases/json_text.h>
#include <graze/engine/cases/sha256.h>
#include <graze/engine/compare/run/answer_json.h>
#include <graze/engine/compare/run/scene_journal.h>
#include <graze/engine/mesh/io/source.h>
#include <graze/engine/scenes/scene_error.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

namespace graze::compare {
namespace {

using cases::json_number;
using cases::json_string;
using cases::JsonCursor;

constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kMaxIndex = std::numeric_limits<std::uint32_t>::max();

std::string line_of(const StepRecord& record) {
  std::string line = "{\"step\":" + std::to_string(record.step);
  line += ",\"time\":" + json_number(record.time);
  line += ",\"questions\":" + std::to_string(record.questions) + ",\"engines\":[";
  const char* separator = "";
  for (const StepAnswers& each : record.engines) {
    line += separator;
    line += "{\"engine\":" + json_string(each.engine);
    line += ",\"answers\":" + std::to_string(each.answers);
    line += ",\"digest\":" + json_string(each.digest) + ",\"us\":" + json_number(each.time) + "}";
    separator = ",";
  }
  line += "],\"differences\":[";
  separator = "";
  for (const SceneDifference& difference : record.differences) {
    line += separator;
    line += "{\"a\":" + std::to_string(difference.pair.a);
    line += ",\"b\":" + std::to_string(difference.pair.b) + ",\"answers\":[";
    separator = "";
    for (const AnswerRecord& answer : difference.answers) {
      line += separator;
      line += to_json(answer);
      separator = ",";
    }
    line += "]}";
    separator = ",";
  }
  return line + "]}";
}

std::vector<std::string> lines_of(const SceneJob& job, std::span<const EngineEntry> engines,
                                  const std::vector<StepRecord>& records) {
  std::vector<std::string> lines = {"{\"graze_scene_comparison\":" + std::to_string(kVersion) +
                                    ",\"key\":" + json_string(job.key) +
                                    ",\"engines\":" + engine_names_json(engines) +
                                    ",\"steps\":" + std::to_string(job.steps) + "}"};
  for (const StepRecord& record : records)
    lines.push_back(line_of(record));
  return lines;
}

std::size_t index_below(const JsonCursor& at, std::size_t end) {
  const std::size_t index = at.index(kMaxIndex);
  if (index >= end) at.fail("there are " + std::to_string(end));
  return index;
}

SceneDifference read_difference(const JsonCursor& at, std::size_t bodies) {
  at.require_keys({"a", "b", "answers"});
  SceneDifference difference{
      {index_below(at.member("a"), bodies), index_below(at.member("b"), bodies)}, {}};
  const JsonCursor answers = at.member("answers");
  for (std::size_t i = 0; i < answers.size(); ++i)
    difference.answers.push_back(read_answer(answers.item(i)));
  if (difference.answers.empty()) answers.fail("is empty");
  return difference;
}

StepRecord read_step(const JsonCursor& at, std::size_t steps, std::size_t bodies) {
  at.require_keys({"step", "time", "questions", "engines", "differences"});
  StepRecord record;
  record.step = index_below(at.member("step"), steps);
  record.time = at.member("time").number();
  record.questions = at.member("questions").index(kMaxIndex);
  const JsonCursor engines = at.member("engines");
  for (std::size_t i = 0; i < engines.size(); ++i) {
    const JsonCursor engine = engines.item(i);
    engine.require_keys({"engine", "answers", "digest", "us"});
    record.engines.push_back({engine.member("engine").text(),
                              engine.member("answers").index(kMaxIndex),
                              engine.member("digest").text(), engine.member("us").number()});
  }
  const JsonCursor differences = at.member("differences");
  for (std::size_t i = 0; i < differences.size(); ++i)
    record.differences.push_back(read_difference(differences.item(i), bodies));
  return record;
}

/// What graze itself said at a step: as a world, and of each pair alone.
std::string graze_digest(const StepRecord& record) {
  std::string digest;
  for (const StepAnswers& each : record.engines)
    if (each.engine == "world" || each.engine == "graze") digest += each.digest;
  return digest;
}

double graze_time(const StepRecord& record) {
  double time = 0;
  for (const StepAnswers& each : record.engines)
    if (each.engine == "world" || each.engine == "graze") time += each.time;
  return time;
}

}  // namespace

SceneJob scene_job(const std::filesystem::path& path, const Scene& scene,
                   const SceneComparisonSettings& settings) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw SceneError(mesh_io::printable(path.string()) + ": cannot be read");
  text = cases::sha256_of(text);
  for (const SceneShape& shape : scene.shapes)
    if (const Mesh* mesh = shape.shape.as<Mesh>()) text = digest_of(*mesh, text);
  text += json_number(settings.step > 0 ? settings.step : scene.step);
  return {cases::sha256_of(text), settings.steps + 1};
}

SceneJournal read_scene_journal(const std::filesystem::path& path, const Scene& scene) {
  SceneJournal journal;
  read_lines(path, [&](const JsonCursor& root, std::size_t number) {
    if (number > 1) {
      journal.records.push_back(read_step(root, journal.job.steps, scene.bodies.size()));
      return;
    }
    root.require_keys({"graze_scene_comparison", "key", "engines", "steps"});
    if (root.member("graze_scene_comparison").index(kMaxIndex) != kVersion) {
      root.member("graze_scene_comparison").fail("is another version");
    }
    journal.job = {root.member("key").text(), root.member("steps").index(kMaxIndex)};
    const JsonCursor engines = root.member("engines");
    for (std::size_t i = 0; i < engines.size(); ++i)
      journal.engines.push_back(engines.item(i).text());
  });
  if (journal.job.key.empty()) {
    throw CaseError(mesh_io::printable(path.string()) + ": is no record of a comparison");
  }
  return journal;
}

SceneJournalWriter::SceneJournalWriter(const std::filesystem::path& path, const SceneJob& job,
                                       std::span<const EngineEntry> engines,
                                       const std::vector<StepRecord>& known)
    : file_(path, lines_of(job, engines, known)) {}

void SceneJournalWriter::add(const StepRecord& record) {
  file_.add(line_of(record));
}

BaselineDifference compare_to_baseline(const SceneJournal& baseline,
                                       const std::vector<StepRecord>& records) {
  std::map<std::size_t, const StepRecord*> old;
  for (const StepRecord& record : baseline.records)
    old[record.step] = &record;
  BaselineDifference difference;
  for (const StepRecord& record : records) {
    const auto at = old.find(record.step);
    if (at == old.end()) {
      difference.missing.push_back(record.step);
      continue;
    }
    if (graze_digest(record) != graze_digest(*at->second)) {
      difference.changed.push_back(record.step);
    }
    difference.old_time += graze_time(*at->second);
    difference.new_time += graze_time(record);
    old.erase(at);
  }
  for (const auto& [step, ignored] : old)
    difference.missing.push_back(step);
  return difference;
}

}  // namespace graze::compare
