#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/run/record/answer_record.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/files/source.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace graze::compare {
namespace {

using cases::json_plain_or_infinite;
using cases::json_string;
using cases::JsonCursor;

constexpr std::uint32_t kMaxIndex = std::numeric_limits<std::uint32_t>::max();
constexpr std::array kVerdicts = {Verdict::Right, Verdict::Wrong, Verdict::NotJudged,
                                  Verdict::NotConfirmed};

template <typename List>
auto named(const JsonCursor& at, const List& list) {
  for (const auto value : list) {
    if (at.text() == name_of(value)) return value;
  }
  at.fail("unknown word " + mesh_io::quoted(at.text()));
}

}  // namespace

std::string answer_digest(const CaseAnswer& answer) {
  constexpr std::size_t kDigits = 16;
  return files::sha256_of(to_json(answer)).substr(0, kDigits);
}

std::optional<double> answer_value(const CaseAnswer& answer) {
  if (answer.distance) return answer.distance;
  if (answer.status) return answer.low;
  return std::nullopt;
}

std::string to_json(const AnswerRecord& answer) {
  std::string out = "{\"engine\":";
  out += json_string(answer.engine) + ",\"answer\":" + json_string(answer.brief) +
         ",\"digest\":" + json_string(answer.digest) +
         ",\"us\":" + json_plain_or_infinite(answer.time);
  if (answer.value) out += ",\"value\":" + json_plain_or_infinite(*answer.value);
  if (answer.is_agreed) return out + ",\"agreed\":true}";
  const Judgement& judgement = answer.judgement;
  out += ",\"agreed\":false,\"verdict\":";
  out += json_string(name_of(judgement.verdict)) + ",\"truth\":" + json_string(judgement.truth);
  if (!answer.is_wrong()) return out + "}";
  out += ",\"class\":" + json_string(name_of(judgement.error_class)) +
         ",\"error\":" + json_plain_or_infinite(judgement.error) +
         ",\"ulps\":" + json_plain_or_infinite(judgement.ulps) +
         ",\"wrong_pairs\":" + std::to_string(judgement.wrong_pairs);
  if (judgement.culprit) {
    out += ",\"culprit\":[" + std::to_string(judgement.culprit->a) + "," +
           std::to_string(judgement.culprit->b) + "]";
  }
  return out + "}";
}

AnswerRecord read_answer(const JsonCursor& at) {
  at.require_keys({"engine", "answer", "digest", "us", "agreed", "verdict", "truth", "class",
                   "error", "ulps", "wrong_pairs", "culprit", "value"});
  AnswerRecord answer{.engine = at.member("engine").text(),
                      .digest = at.member("digest").text(),
                      .brief = at.member("answer").text(),
                      .time = at.member("us").number_or_infinite(),
                      .is_agreed = at.member("agreed").boolean(),
                      .judgement = {}};
  if (at.has("value")) answer.value = at.member("value").number_or_infinite();
  if (answer.is_agreed) return answer;
  Judgement& judgement = answer.judgement;
  judgement.verdict = named(at.member("verdict"), kVerdicts);
  judgement.truth = at.member("truth").text();
  if (!answer.is_wrong()) return answer;
  judgement.error_class = named(at.member("class"), kErrorClasses);
  judgement.error = at.member("error").number_or_infinite();
  judgement.ulps = at.member("ulps").number_or_infinite();
  judgement.wrong_pairs = at.member("wrong_pairs").index(kMaxIndex);
  if (at.has("culprit")) {
    const JsonCursor pair = at.member("culprit");
    pair.require_size(2);
    judgement.culprit = {pair.item(0).index(kMaxIndex), pair.item(1).index(kMaxIndex)};
  }
  return answer;
}

std::string to_json(std::span<const AnswerRecord> answers) {
  std::string out = "[";
  const char* separator = "";
  for (const AnswerRecord& answer : answers) {
    out += separator;
    out += to_json(answer);
    separator = ",";
  }
  return out + "]";
}

std::vector<AnswerRecord> read_answers(const JsonCursor& at) {
  std::vector<AnswerRecord> answers;
  for (std::size_t i = 0; i < at.size(); ++i)
    answers.push_back(read_answer(at.item(i)));
  return answers;
}

std::string to_json(const PlaceRecord& record, std::string_view name) {
  return std::string("{") + json_string(name) + ":" + std::to_string(record.place) +
         ",\"answers\":" + to_json(record.answers) + "}";
}

PlaceRecord read_place_record(const JsonCursor& at, std::string_view name,
                              const ExpectedPlace& expected) {
  at.require_keys({name, "answers", "sum"});
  return {read_place(at.member(name), expected), read_answers(at.member("answers"))};
}

std::size_t read_place(const JsonCursor& at, std::size_t end) {
  constexpr std::int64_t kMostPlaces = std::int64_t{1} << 53;
  const auto place = static_cast<std::size_t>(at.whole(0, kMostPlaces));
  if (place >= end) at.fail("there are " + std::to_string(end));
  return place;
}

std::size_t read_place(const JsonCursor& at, const ExpectedPlace& expected) {
  const std::size_t place = read_place(at, expected.end);
  if (place != expected.next) {
    at.fail("is " + std::to_string(place) + " where " + std::to_string(expected.next) +
            " should stand");
  }
  return place;
}

std::vector<SaidThere> said_there(const PlaceRecord& record) {
  std::vector<SaidThere> all;
  for (const AnswerRecord& answer : record.answers) {
    const Verdict verdict = answer.is_agreed ? Verdict::Right : answer.judgement.verdict;
    all.push_back({answer.engine, answer.digest, answer.value, answer.time, verdict});
  }
  return all;
}

}  // namespace graze::compare
