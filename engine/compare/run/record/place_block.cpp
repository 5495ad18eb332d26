#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/compare/run/record/base64.h>
#include <graze/engine/compare/run/record/place_block.h>
#include <graze/engine/compare/run/record/time_code.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <utility>

namespace graze::compare {
namespace {

using cases::JsonCursor;

/// Says what the first byte of a place says.
enum class Tag : unsigned char {
  Else,   ///< nothing here: it stands in "else"
  No,     ///< all say no
  Yes,    ///< all say yes
  Pairs,  ///< all name the same pairs: their digest, 8 bytes, and their number, 4
};

constexpr std::uint32_t kMostIndex = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kDigestDigits = 16;

std::string digest_of(bool says) {
  CaseAnswer answer;
  answer.says = says;
  return answer_digest(answer);
}

const std::string& digest_of(Tag tag) {
  static const std::string kNo = digest_of(false);
  static const std::string kYes = digest_of(true);
  return tag == Tag::Yes ? kYes : kNo;
}

std::string pairs_brief(std::uint32_t count) {
  return std::to_string(count) + (count == 1 ? " pair" : " pairs");
}

std::optional<std::uint32_t> pairs_of(const std::string& brief) {
  std::uint32_t count = 0;
  std::from_chars(brief.data(), brief.data() + brief.size(), count);
  return pairs_brief(count) == brief ? std::optional(count) : std::nullopt;
}

/// Writes whole numbers as bytes, the lowest first.
template <typename Number>
void put(std::string& bytes, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    bytes += static_cast<char>(number >> (8 * i) & 255);
}

class Bytes {
 public:
  explicit Bytes(std::string bytes) : bytes_(std::move(bytes)) {}
  bool is_empty() const { return at_ == bytes_.size(); }

  template <typename Number>
  std::optional<Number> take() {
    if (bytes_.size() - at_ < sizeof(Number)) return std::nullopt;
    std::uint64_t number = 0;
    for (std::size_t i = sizeof(Number); i-- > 0;)
      number = number << 8 | static_cast<unsigned char>(bytes_[at_ + i]);
    at_ += sizeof(Number);
    return static_cast<Number>(number);
  }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

/// Returns the indices of the engines that answer, if all agree.
std::optional<std::vector<std::size_t>> owners_of(const PlaceRecord& record,
                                                  std::span<const JournalEngine> engines) {
  std::vector<std::size_t> owners;
  std::size_t next = 0;
  for (const AnswerRecord& answer : record.answers) {
    while (next < engines.size() && engines[next].name != answer.engine)
      ++next;
    if (next == engines.size() || !answer.is_agreed || answer.value) return std::nullopt;
    owners.push_back(next++);
  }
  return owners;
}

Tag tag_of(const PlaceRecord& record) {
  if (record.answers.empty()) return Tag::Else;
  const AnswerRecord& first = record.answers.front();
  const bool are_alike =
      std::all_of(record.answers.begin(), record.answers.end(), [&](const AnswerRecord& each) {
        return each.digest == first.digest && each.brief == first.brief &&
               each.time == recorded_time(each.time);
      });
  if (!are_alike) return Tag::Else;
  if (first.brief == "yes" && first.digest == digest_of(Tag::Yes)) return Tag::Yes;
  if (first.brief == "no" && first.digest == digest_of(Tag::No)) return Tag::No;
  const bool is_digest = first.digest.size() == kDigestDigits &&
                         first.digest.find_first_not_of("0123456789abcdef") == std::string::npos;
  return is_digest && pairs_of(first.brief) ? Tag::Pairs : Tag::Else;
}

void put_agreed(std::string& bytes, const PlaceRecord& record, Tag tag) {
  const AnswerRecord& first = record.answers.front();
  if (tag == Tag::Pairs) {
    std::uint64_t digest = 0;
    std::from_chars(first.digest.data(), first.digest.data() + kDigestDigits, digest, 16);
    put(bytes, digest);
    put(bytes, *pairs_of(first.brief));
  }
  for (const AnswerRecord& answer : record.answers)
    put(bytes, time_code(answer.time));
}

std::string hex_of(std::uint64_t digest) {
  std::string text(kDigestDigits, '0');
  for (std::size_t i = kDigestDigits; i-- > 0; digest >>= 4)
    text[i] = "0123456789abcdef"[digest & 15];
  return text;
}

/// Reads the places that agree, and those that stand in full.
class BlockReader {
 public:
  BlockReader(const JsonCursor& at, std::span<const JournalEngine> engines)
      : at_(at), engines_(engines), bytes_(bytes_of(at.member("agreed"))) {
    const JsonCursor by = at.member("by");
    for (std::size_t i = 0; i < by.size(); ++i) {
      owners_.push_back(by.item(i).index(kMostIndex));
      if (owners_.back() >= engines.size()) by.item(i).fail("there is no such engine");
    }
  }

  std::vector<PlaceRecord> read(std::size_t first, std::size_t count) {
    std::vector<PlaceRecord> block;
    for (std::size_t place = first; place < first + count; ++place) {
      const auto tag = static_cast<Tag>(*taken<unsigned char>());
      if (tag > Tag::Pairs) fail();
      block.push_back(tag == Tag::Else ? next_else(place) : agreed(place, tag));
    }
    if (!bytes_.is_empty()) fail();
    if (next_else_ != at_.member("else").size()) at_.member("else").fail("has places too many");
    return block;
  }

 private:
  static std::string bytes_of(const JsonCursor& at) {
    std::optional<std::string> bytes = from_base64(at.text());
    if (!bytes) at.fail("is no Base64");
    return *std::move(bytes);
  }

  [[noreturn]] void fail() const { at_.member("agreed").fail("is not of so many places"); }

  template <typename Number>
  std::optional<Number> taken() {
    const std::optional<Number> number = bytes_.take<Number>();
    if (!number) fail();
    return number;
  }

  PlaceRecord next_else(std::size_t place) {
    const JsonCursor list = at_.member("else");
    if (next_else_ == list.size()) list.fail("has not all places");
    return read_place_record(list.item(next_else_++), "pose", {place, place + 1});
  }

  PlaceRecord agreed(std::size_t place, Tag tag) {
    std::string digest;
    std::string brief = tag == Tag::Yes ? "yes" : "no";
    if (tag == Tag::Pairs) {
      digest = hex_of(*taken<std::uint64_t>());
      brief = pairs_brief(*taken<std::uint32_t>());
    } else {
      digest = digest_of(tag);
    }
    PlaceRecord record{place, {}};
    for (const std::size_t owner : owners_) {
      record.answers.push_back({.engine = engines_[owner].name,
                                .digest = digest,
                                .brief = brief,
                                .time = time_of_code(*taken<std::uint16_t>()),
                                .is_agreed = true,
                                .judgement = {}});
    }
    return record;
  }

  const JsonCursor& at_;
  std::span<const JournalEngine> engines_;
  Bytes bytes_;
  std::vector<std::size_t> owners_;
  std::size_t next_else_ = 0;
};

}  // namespace

std::string to_json(std::span<const PlaceRecord> block, std::span<const JournalEngine> engines) {
  std::string bytes;
  std::string others;
  std::optional<std::vector<std::size_t>> by;  // the owners of all places that agree in this block
  for (const PlaceRecord& record : block) {
    Tag tag = tag_of(record);
    std::optional<std::vector<std::size_t>> owners = owners_of(record, engines);
    if (!owners) tag = Tag::Else;
    if (tag != Tag::Else && !by) by = owners;
    if (tag != Tag::Else && owners != by) tag = Tag::Else;
    bytes += static_cast<char>(tag);
    if (tag == Tag::Else) {
      others += (others.empty() ? "" : ",") + to_json(record, "pose");
    } else {
      put_agreed(bytes, record, tag);
    }
  }
  const auto index = [](std::size_t each) { return std::to_string(each); };
  const std::vector<std::size_t> none;
  return "{\"poses\":[" + std::to_string(block.front().place) + "," + std::to_string(block.size()) +
         "],\"by\":" + cases::json_list(by ? *by : none, ",", index) + ",\"agreed\":\"" +
         to_base64(bytes) + "\",\"else\":[" + others + "]}";
}

std::vector<PlaceRecord> read_place_block(const JsonCursor& at,
                                          std::span<const JournalEngine> engines, std::size_t first,
                                          std::size_t end) {
  at.require_keys({"poses", "by", "agreed", "else", "sum"});
  const JsonCursor poses = at.member("poses");
  poses.require_size(2);
  read_place(poses.item(0), {first, end});
  const std::size_t count = poses.item(1).index(kMostIndex);
  if (count == 0 || count > end - first) poses.item(1).fail("is no number of poses that are left");
  return BlockReader(at, engines).read(first, count);
}

}  // namespace graze::compare
