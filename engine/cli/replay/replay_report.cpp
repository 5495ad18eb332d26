#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/replay/replay_report.h>
#include <graze/engine/files/source.h>

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>

namespace graze::cli {
namespace {

using cases::json_string;
using compare::brief;
using compare::Testimony;
using compare::Verdict;

std::string engine_of(const Testimony& testimony) {
  std::string name = testimony.witness.engine;
  if (!testimony.witness.version.empty()) name += " " + testimony.witness.version;
  return testimony.is_recorded ? name + " (recorded)" : name;
}

/// Returns the class of a wrong answer, and a word for one that is no longer as it was.
std::string reason_of(const Testimony& testimony) {
  std::string reason;
  if (testimony.is_wrong()) reason = name_of(testimony.judgement.error_class);
  if (testimony.differs_from_record) reason += reason.empty() ? "changed" : ", changed";
  return reason;
}

/// Returns the engines that gave no answer: they have no such query, or refuse such shapes.
std::vector<std::string> silent_ones(std::span<const std::string> engines,
                                     const std::vector<Testimony>& testimonies) {
  std::vector<std::string> silent;
  for (const std::string& engine : engines) {
    const bool has_spoken = std::any_of(
        testimonies.begin(), testimonies.end(),
        [&](const Testimony& t) { return !t.is_recorded && t.witness.engine == engine; });
    if (!has_spoken) silent.push_back(engine);
  }
  return silent;
}

/// Returns distances with all digits: two that differ in the last one are two answers.
std::string in_full(const CaseAnswer& answer) {
  return answer.distance ? cases::json_plain_number(*answer.distance) + " m" : brief(answer);
}

}  // namespace

std::string to_json(const Testimony& t, const FailOn& fail_on) {
  const compare::Judgement& judgement = t.judgement;
  std::string out =
      fmt::format("{{\"engine\":{},\"version\":{},\"recorded\":{},\"answer\":{},\"verdict\":{}",
                  json_string(t.witness.engine), json_string(t.witness.version), t.is_recorded,
                  to_plain_json(t.answer), json_string(name_of(judgement.verdict)));
  if (!judgement.truth.empty()) out += fmt::format(",\"truth\":{}", json_string(judgement.truth));
  if (judgement.verdict == Verdict::Wrong) {
    out += fmt::format(",\"class\":{},\"error\":{},\"ulps\":{}",
                       json_string(name_of(judgement.error_class)),
                       cases::json_plain_or_infinite(judgement.error),
                       cases::json_plain_or_infinite(judgement.ulps));
    if (judgement.wrong_pairs > 0) out += fmt::format(",\"wrong_pairs\":{}", judgement.wrong_pairs);
  }
  if (t.differs_from_record) out += ",\"changed\":true";
  if (fail_on.matches(t)) out += ",\"fails\":true";
  if (!t.is_recorded) out += fmt::format(",\"us\":{:.3f}", t.time.count());
  return out + "}";
}

ReplayReport::ReplayReport(Output& output, const FailOn& fail_on, bool is_json)
    : output_(output),
      fail_on_(fail_on),
      is_json_(is_json),
      table_({{"case", 28},
              {"question", 13},
              {"engine", 20},
              {"answer", 21},
              {"truth", 20},
              {"verdict", 10},
              {"why", 13},
              {"error (m)", 10},
              {"ulp", 8},
              {"time (us)", 10}}) {}

void ReplayReport::begin(std::span<const compare::EngineEntry> engines) {
  for (const compare::EngineEntry& entry : engines)
    if (entry.engine != nullptr) engines_.push_back(entry.name);
  if (is_json_) return;
  for (const compare::EngineEntry& entry : engines) {
    if (entry.engine == nullptr)
      output_.write(entry.name + ": not found when this command was built\n");
  }
  output_.write(table_.header());
}

void ReplayReport::add(const std::string& file, const Case& query,
                       const std::vector<Testimony>& testimonies) {
  ++cases_;
  for (const Testimony& testimony : testimonies) {
    failures_ += fail_on_.matches(testimony);
    if (!testimony.is_graze()) continue;
    const bool is_judged = testimony.judgement.verdict != Verdict::NotJudged;
    graze_wrong_ += testimony.is_wrong();
    changed_ += testimony.differs_from_record;
    changed_unjudged_ += testimony.differs_from_record && !is_judged;
  }
  if (is_json_) {
    std::string line = fmt::format("{{\"case\":{},\"question\":{},\"testimonies\":[",
                                   json_string(file), json_string(name_of(query.ask)));
    const char* separator = "";
    for (const Testimony& testimony : testimonies) {
      line += separator;
      line += to_json(testimony, fail_on_);
      separator = ",";
    }
    line += "],\"silent\":[";
    separator = "";
    for (const std::string& engine : silent_ones(engines_, testimonies)) {
      line += separator;
      line += json_string(engine);
      separator = ",";
    }
    output_.write(line + "]}\n");
    return;
  }
  std::string rows;
  std::string name = mesh_io::printable(std::filesystem::path(file).filename().string());
  std::string question = name_of(query.ask);
  for (const Testimony& t : testimonies) {
    const bool is_wrong = t.is_wrong();
    rows += table_.row({name, question, engine_of(t), in_full(t.answer), t.judgement.truth,
                        name_of(t.judgement.verdict), reason_of(t),
                        is_wrong ? fmt::format("{:.3g}", t.judgement.error) : "",
                        is_wrong ? fmt::format("{:.3g}", t.judgement.ulps) : "",
                        t.is_recorded ? "" : fmt::format("{:.1f}", t.time.count())});
    name.clear();
    question.clear();
  }
  for (const std::string& engine : silent_ones(engines_, testimonies)) {
    rows += table_.row({name, question, engine, "knows no such query", "", "", "", "", "", ""});
    name.clear();
    question.clear();
  }
  output_.write(rows);
}

void ReplayReport::end() {
  if (is_json_) return;
  std::string line = fmt::format("{} case{}, graze wrong in {}, changed in {}", cases_,
                                 cases_ == 1 ? "" : "s", graze_wrong_, changed_);
  if (fail_on_.is_set()) {
    line += fmt::format(", {} wrong answer{} of --fail-on", failures_, failures_ == 1 ? "" : "s");
  }
  output_.write(line + "\n");
}

}  // namespace graze::cli
