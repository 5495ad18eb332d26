#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/compare/run/record/step_record.h>

#include <limits>
#include <utility>

namespace graze::compare {
namespace {

using cases::json_plain_number;
using cases::json_string;
using cases::JsonCursor;

constexpr std::uint32_t kMaxIndex = std::numeric_limits<std::uint32_t>::max();

SceneDifference read_difference(const JsonCursor& at, std::size_t bodies) {
  at.require_keys({"a", "b", "answers"});
  SceneDifference difference{
      {read_place(at.member("a"), bodies), read_place(at.member("b"), bodies)},
      read_answers(at.member("answers"))};
  if (difference.answers.empty()) at.member("answers").fail("is empty");
  return difference;
}

}  // namespace

std::string to_json(const StepRecord& record) {
  std::string line = "{\"step\":" + std::to_string(record.place);
  line += ",\"time\":" + json_plain_number(record.time);
  line += ",\"questions\":" + std::to_string(record.questions) + ",\"engines\":[";
  const char* separator = "";
  for (const StepAnswers& each : record.engines) {
    line += separator;
    line += "{\"engine\":" + json_string(each.engine);
    line += ",\"answers\":" + std::to_string(each.answers);
    line +=
        ",\"digest\":" + json_string(each.digest) + ",\"us\":" + json_plain_number(each.time) + "}";
    separator = ",";
  }
  line += "],\"differences\":[";
  separator = "";
  for (const SceneDifference& difference : record.differences) {
    line += separator;
    line += "{\"a\":" + std::to_string(difference.pair.a);
    line += ",\"b\":" + std::to_string(difference.pair.b);
    line += ",\"answers\":" + to_json(difference.answers) + "}";
    separator = ",";
  }
  return line + "]}";
}

StepRecord read_step_record(const JsonCursor& at, const ExpectedPlace& expected,
                            std::size_t bodies) {
  at.require_keys({"step", "time", "questions", "engines", "differences", "sum"});
  StepRecord record;
  record.place = read_place(at.member("step"), expected);
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

std::vector<SaidThere> said_there(const StepRecord& record) {
  std::vector<SaidThere> all;
  SaidThere graze{.engine = "graze"};
  for (const StepAnswers& each : record.engines) {
    if (each.engine != "world" && each.engine != "graze") {
      all.push_back({.engine = each.engine, .digest = each.digest, .time = each.time});
      continue;
    }
    graze.digest += each.digest;
    graze.time += each.time;
  }
  all.insert(all.begin(), std::move(graze));
  return all;
}

}  // namespace graze::compare
