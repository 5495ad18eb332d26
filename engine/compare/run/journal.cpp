#include <graze/engine/cases/case_error.h>
#include <graze/engine/cases/json_cursor.h>
#include <graze/engine/cases/json_text.h>
#include <graze/engine/cases/sha256.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/run/journal.h>
#include <graze/engine/mesh/io/source.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <sstream>

namespace graze::compare {
namespace {

using cases::json_number;
using cases::json_string;
using cases::JsonCursor;

constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kMaxPoses = std::numeric_limits<std::uint32_t>::max();
constexpr std::array kVerdicts = {Verdict::Right, Verdict::Wrong, Verdict::NotJudged};
constexpr std::array kClasses = {ErrorClass::Touching, ErrorClass::PoseRounding,
                                 ErrorClass::Degenerate, ErrorClass::Containment, ErrorClass::Real};

template <typename List>
auto named(const JsonCursor& at, const List& list) {
  for (const auto value : list) {
    if (at.text() == name_of(value)) return value;
  }
  at.fail("unknown word " + mesh_io::quoted(at.text()));
}

std::string to_json(const AnswerRecord& answer) {
  std::string out = "{\"engine\":";
  out += json_string(answer.engine) + ",\"answer\":" + json_string(answer.brief) +
         ",\"digest\":" + json_string(answer.digest) + ",\"us\":" + json_number(answer.time);
  if (answer.is_agreed) return out + ",\"agreed\":true}";
  const Judgement& judgement = answer.judgement;
  out += ",\"agreed\":false,\"verdict\":";
  out += json_string(name_of(judgement.verdict)) + ",\"truth\":" + json_string(judgement.truth);
  if (!answer.is_wrong()) return out + "}";
  out += ",\"class\":" + json_string(name_of(judgement.error_class)) +
         ",\"error\":" + json_number(judgement.error) + ",\"ulps\":" + json_number(judgement.ulps) +
         ",\"wrong_pairs\":" + std::to_string(judgement.wrong_pairs);
  if (judgement.culprit) {
    out += ",\"culprit\":[" + std::to_string(judgement.culprit->a) + "," +
           std::to_string(judgement.culprit->b) + "]";
  }
  return out + "}";
}

AnswerRecord read_answer(const JsonCursor& at) {
  at.require_keys({"engine", "answer", "digest", "us", "agreed", "verdict", "truth", "class",
                   "error", "ulps", "wrong_pairs", "culprit"});
  AnswerRecord answer{.engine = at.member("engine").text(),
                      .digest = at.member("digest").text(),
                      .brief = at.member("answer").text(),
                      .time = at.member("us").number(),
                      .is_agreed = at.member("agreed").boolean(),
                      .judgement = {}};
  if (answer.is_agreed) return answer;
  Judgement& judgement = answer.judgement;
  judgement.verdict = named(at.member("verdict"), kVerdicts);
  judgement.truth = at.member("truth").text();
  if (!answer.is_wrong()) return answer;
  judgement.error_class = named(at.member("class"), kClasses);
  judgement.error = at.member("error").number();
  judgement.ulps = at.member("ulps").number();
  judgement.wrong_pairs = at.member("wrong_pairs").index(kMaxPoses);
  if (at.has("culprit")) {
    const JsonCursor pair = at.member("culprit");
    pair.require_size(2);
    judgement.culprit = {pair.item(0).index(kMaxPoses), pair.item(1).index(kMaxPoses)};
  }
  return answer;
}

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

std::string header(const ComparisonJob& job) {
  return "{\"graze_comparison\":" + std::to_string(kVersion) +
         ",\"key\":" + json_string(key_of(job)) +
         ",\"poses\":" + std::to_string(job.poses_b.size()) + "}\n";
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

std::string key_of(const ComparisonJob& job) {
  std::string text = name_of(job.question.ask);
  const auto add_mesh = [&](const Mesh& mesh) {
    for (const Eigen::Vector3d& vertex : mesh.vertices())
      text += cases::json_point(vertex);
    for (const TriangleIndices& t : mesh.triangles()) {
      for (const std::uint32_t index : t)
        text += std::to_string(index) + " ";
    }
    text = cases::sha256_of(text);
  };
  add_mesh(job.a.mesh);
  add_mesh(job.b.mesh);
  text += cases::json_pose(job.a.pose);
  for (const Pose& pose : job.poses_b)
    text += cases::json_pose(pose);
  return cases::sha256_of(text);
}

Journal read_journal(const std::filesystem::path& path) {
  const std::string name = mesh_io::printable(path.string());
  std::ifstream file(path, std::ios::binary);
  if (!file) throw CaseError(name + ": cannot be read");
  Journal journal;
  std::string line;
  for (std::size_t number = 1; std::getline(file, line); ++number) {
    if (file.eof()) break;  // no line break: the run was stopped while it wrote this
    const std::string place = name + ":" + std::to_string(number);
    const cases::JsonValue tree = cases::parse_json(line, place);
    const JsonCursor root(tree, place);
    if (number == 1) {
      root.require_keys({"graze_comparison", "key", "poses"});
      if (root.member("graze_comparison").index(kMaxPoses) != kVersion) {
        root.member("graze_comparison").fail("is another version");
      }
      journal.key = root.member("key").text();
      journal.poses = root.member("poses").index(kMaxPoses);
    } else {
      journal.records.push_back(read_record(root, journal.poses));
    }
  }
  if (journal.key.empty()) throw CaseError(name + ": is no record of a comparison");
  return journal;
}

JournalWriter::JournalWriter(const std::filesystem::path& path, const ComparisonJob& job,
                             const std::vector<PoseRecord>& known)
    : name_(mesh_io::printable(path.string())) {
  // Beside the old file, which is lost only when the new one is there.
  std::filesystem::path fresh = path;
  fresh += ".new";
  file_.open(fresh, std::ios::binary | std::ios::trunc);
  file_ << header(job);
  for (const PoseRecord& record : known)
    file_ << to_json(record) << '\n';
  std::error_code error;
  if (file_.flush()) std::filesystem::rename(fresh, path, error);
  if (!file_ || error) throw CaseError(name_ + ": cannot be written");
}

void JournalWriter::add(const PoseRecord& record) {
  file_ << to_json(record) << '\n';
  if (!file_.flush()) throw CaseError(name_ + ": cannot be written");
}

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
      difference.missing_poses.push_back(record.pose);
      continue;
    }
    if (now->digest != before->digest) difference.changed_poses.push_back(record.pose);
    difference.old_time += before->time;
    difference.new_time += now->time;
  }
  for (const auto& [pose, ignored] : old)
    difference.missing_poses.push_back(pose);
  return difference;
}

}  // namespace graze::compare
