#include <graze/engine/cases/case_error.h>
#include <graze/engine/cases/json_cursor.h>
#include <graze/engine/cases/json_text.h>
#include <graze/engine/cases/sha256.h>
#include <graze/engine/compare/run/answer_json.h>
#include <graze/engine/compare/run/journal.h>
#include <graze/engine/mesh/io/source.h>

#include <algorithm>
#include <limits>
#include <map>

namespace graze::compare {
namespace {

using cases::json_number;
using cases::json_string;
using cases::JsonCursor;

constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kMaxPoses = std::numeric_limits<std::uint32_t>::max();

PoseRecord read_record(const JsonCursor& at, std::size_t poses) {
  at.require_keys({"pose", "answers"});
  PoseRecord record{at.member("pose").index(kMaxPoses), {}};
  if (record.pose >= poses) at.member("pose").fail("there are " + std::to_string(poses) + " poses");
  const JsonCursor list = at.member("answers");
  for (std::size_t i = 0; i < list.size(); ++i)
    record.answers.push_back(read_answer(list.item(i)));
  return record;
}

const AnswerRecord* graze_answer(const PoseRecord& record) {
  const auto at = std::find_if(record.answers.begin(), record.answers.end(),
                               [](const AnswerRecord& answer) { return answer.engine == "graze"; });
  return at == record.answers.end() ? nullptr : &*at;
}

std::vector<std::string> lines_of(const ComparisonJob& job, std::span<const EngineEntry> engines,
                                  const std::vector<PoseRecord>& records) {
  std::vector<std::string> lines = {"{\"graze_comparison\":" + std::to_string(kVersion) +
                                    ",\"key\":" + json_string(key_of(job)) +
                                    ",\"engines\":" + engine_names_json(engines) +
                                    ",\"poses\":" + std::to_string(job.poses_b.size()) + "}"};
  for (const PoseRecord& record : records)
    lines.push_back(to_json(record));
  return lines;
}

}  // namespace

std::string to_json(const PoseRecord& record) {
  std::string line = "{\"pose\":" + std::to_string(record.pose) + ",\"answers\":[";
  const char* separator = "";
  for (const AnswerRecord& answer : record.answers) {
    line += separator;
    line += to_json(answer);
    separator = ",";
  }
  return line + "]}";
}

std::string digest_of(const Mesh& mesh, const std::string& before) {
  std::string text = before;
  for (const Eigen::Vector3d& vertex : mesh.vertices())
    text += cases::json_point(vertex);
  for (const TriangleIndices& t : mesh.triangles()) {
    for (const std::uint32_t index : t)
      text += std::to_string(index) + " ";
  }
  return cases::sha256_of(text);
}

std::string key_of(const ComparisonJob& job) {
  const CaseSettings& settings = job.question.settings;
  std::string text = name_of(job.question.ask);
  text += settings.touch == Touch::Exclude ? " exclude" : "";
  text += settings.interior == Interior::Solid ? " solid" : "";
  if (job.question.ask == Ask::Within) text += json_number(settings.clearance);
  text = digest_of(job.b.mesh, digest_of(job.a.mesh, text));
  text += cases::json_pose(job.a.pose);
  for (const Pose& pose : job.poses_b)
    text += cases::json_pose(pose);
  return cases::sha256_of(text);
}

Journal read_journal(const std::filesystem::path& path) {
  Journal journal;
  read_lines(path, [&](const JsonCursor& root, std::size_t number) {
    if (number > 1) {
      journal.records.push_back(read_record(root, journal.poses));
      return;
    }
    root.require_keys({"graze_comparison", "key", "engines", "poses"});
    if (root.member("graze_comparison").index(kMaxPoses) != kVersion) {
      root.member("graze_comparison").fail("is another version");
    }
    journal.key = root.member("key").text();
    const JsonCursor engines = root.member("engines");
    for (std::size_t i = 0; i < engines.size(); ++i)
      journal.engines.push_back(engines.item(i).text());
    journal.poses = root.member("poses").index(kMaxPoses);
  });
  if (journal.key.empty()) {
    throw CaseError(mesh_io::printable(path.string()) + ": is no record of a comparison");
  }
  return journal;
}

JournalWriter::JournalWriter(const std::filesystem::path& path, const ComparisonJob& job,
                             std::span<const EngineEntry> engines,
                             const std::vector<PoseRecord>& known)
    : file_(path, lines_of(job, engines, known)) {}

BaselineDifference compare_to_baseline(const Journal& baseline,
                                       const std::vector<PoseRecord>& records) {
  std::map<std::size_t, const AnswerRecord*> old;
  for (const PoseRecord& record : baseline.records)
    old[record.pose] = graze_answer(record);
  BaselineDifference difference;
  for (const PoseRecord& record : records) {
    const AnswerRecord* now = graze_answer(record);
    const auto at = old.find(record.pose);
    const AnswerRecord* before = at == old.end() ? nullptr : at->second;
    if (at != old.end()) old.erase(at);
    if (now == nullptr || before == nullptr) {
      difference.missing.push_back(record.pose);
      continue;
    }
    if (now->digest != before->digest) difference.changed.push_back(record.pose);
    difference.old_time += before->time;
    difference.new_time += now->time;
  }
  for (const auto& [pose, ignored] : old)
    difference.missing.push_back(pose);
  return difference;
}

}  // namespace graze::compare
