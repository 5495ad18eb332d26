#include <graze/bvh/error.h>
#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/peers/process/protocol.h>
#include <graze/engine/compare/run/answers/answer_file.h>
#include <graze/engine/compare/run/answers/answer_line.h>
#include <graze/engine/compare/run/poses/block_cache.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/io/file_bytes.h>

#include <fstream>
#include <functional>
#include <utility>

namespace graze::compare {
namespace {

using cases::JsonCursor;

constexpr std::uint32_t kAnswersVersion = 1;
constexpr std::size_t kLinesOfBlock = 1024;

class AnswerLines : public RecordedAnswers {
 public:
  AnswerLines(const std::filesystem::path& path, const AnswersWanted& wanted)
      : path_(path),
        name_(mesh_io::printable(path.string())),
        is_table_(path.extension() == ".csv"),
        query_(case_of(wanted.job, 0)),
        blocks_([this](std::size_t block) { return lines_of(block); }) {
    std::ifstream file = opened();
    std::string line;
    next_line(file, line, 1);
    if (is_table_ && line.starts_with('#')) line.erase(0, 1);
    sums_ = files::sha256_of(line);
    parsed(line, 1, [&](const JsonCursor& at) { read_start(at, wanted); });
    if (is_table_) {
      next_line(file, line, 2);
      columns_ = answer_columns(line, name_ + ":2");
      sums_ = files::sha256_of(sums_ + line);
      first_line_ = 3;
    }
    read_all(file, wanted.job.places());
  }

  TimedAnswer at(std::size_t place) const override {
    const BlockCache<std::string>::Block block = blocks_.at(place / kLinesOfBlock);
    const std::string& line = (*block)[place % kLinesOfBlock];
    TimedAnswer heard;
    parsed(line, first_line_ + place,
           [&](const JsonCursor& cursor) { heard = heard_answer(cursor, query_); });
    return heard;
  }
  const std::string& digest() const override { return sums_; }
  const CaseWitness& witness() const { return witness_; }
  std::optional<double> tolerance() const { return tolerance_; }

 private:
  std::ifstream opened() const {
    std::ifstream file(path_, std::ios::binary);
    if (!file) throw CaseError(name_ + ": cannot be read");
    return file;
  }

  std::string place_of(std::size_t number) const { return name_ + ":" + std::to_string(number); }

  /// Reads the next line. False at the end.
  bool next_line(std::ifstream& file, std::string& line, std::size_t number) const {
    if (std::getline(file, line)) return true;
    if (file.bad()) throw CaseError(name_ + ": cannot be read to its end");
    if (number < first_line_) throw CaseError(place_of(number) + ": there is no such line");
    return false;
  }

  /// Parses a line, where one of a table becomes what it would be in JSON.
  void parsed(const std::string& line, std::size_t number,
              const std::function<void(const JsonCursor&)>& read) const {
    const std::string place = place_of(number);
    const bool is_row = is_table_ && number >= first_line_;
    const cases::JsonValue tree =
        cases::parse_json(is_row ? json_of_row(line, columns_, place) : line, place);
    read(JsonCursor(tree, place));
  }

  void read_start(const JsonCursor& at, const AnswersWanted& wanted) {
    at.require_keys({"graze_answers", "engine", "version", "question", "settings", "mesh_a",
                     "mesh_b", "shape_a", "shape_b", "poses", "tolerance"});
    const JsonCursor version = at.member("graze_answers");
    if (version.index(kAnswersVersion + 1) != kAnswersVersion) {
      version.fail("is another version; this program reads " + std::to_string(kAnswersVersion));
    }
    witness_.engine = mesh_io::printable(at.member("engine").text());
    if (at.has("version")) witness_.version = mesh_io::printable(at.member("version").text());
    if (at.has("tolerance")) {
      tolerance_ = at.member("tolerance").number();
      if (!(*tolerance_ >= 0)) at.member("tolerance").fail("is below 0");
    }
    const Question& question = wanted.job.question;
    if (at.member("question").text() != name_of(question.ask)) {
      at.member("question")
          .fail(mesh_io::quoted(at.member("question").text()) +
                " is not what is asked: " + name_of(question.ask));
    }
    const CaseSettings settings = cases::read_settings(at, question.ask);
    if (settings.clearance != question.settings.clearance) {
      at.fail("its clearance is not that of this run");
    }
    check_shape(at, "a", wanted.mesh_a, wanted.job.a);
    check_shape(at, "b", wanted.mesh_b, wanted.job.b);
    constexpr std::int64_t kMostPoses = std::int64_t{1} << 53;
    const std::size_t places = wanted.job.places();
    if (at.has("poses") &&
        at.member("poses").whole(0, kMostPoses) != static_cast<std::int64_t>(places)) {
      at.member("poses").fail("is not " + std::to_string(places) + ", as many as there are");
    }
  }

  /// Checks a shape that is a file's, or stands in the line itself.
  static void check_shape(const JsonCursor& at, const std::string& which,
                          const std::filesystem::path& file, const CaseShape& asked) {
    const std::string mesh = "mesh_" + which;
    const std::string shape = "shape_" + which;
    if (at.has(mesh) && at.has(shape)) at.fail("has both a " + mesh + " and a " + shape);
    if (!at.has(shape)) return check_mesh(at.member(mesh), file);
    const JsonCursor there = at.member(shape);
    if (there.has("sha256")) return check_mesh(there, file);
    const auto* body = std::get_if<CaseBody>(&asked);
    if (body == nullptr || !is_same_shape(read_shape(there), body->shape)) {
      there.fail("is not " + mesh_io::printable(file.string()));
    }
  }

  /// Compares the text of both, bit for bit.
  static bool is_same_shape(const Shape& a, const Shape& b) {
    const auto text = [](const Shape& shape) {
      return to_json(Case{.note = "",
                          .ask = Ask::Any,
                          .settings = {},
                          .a = CaseBody(shape, Pose::Identity()),
                          .b = std::nullopt,
                          .answer = std::nullopt,
                          .answered_by = {}});
    };
    return text(a) == text(b);
  }

  static void check_mesh(const JsonCursor& at, const std::filesystem::path& file) {
    at.require_keys({"file", "sha256"});
    const std::string name = mesh_io::printable(file.string());
    if (at.has("file")) at.member("file").text();
    if (at.member("sha256").text() == files::sha256_of(mesh_io::read_file(file, name))) return;
    at.member("sha256").fail("is not that of " + name);
  }

  void read_all(std::ifstream& file, std::size_t places) {
    std::string line;
    std::string block;
    std::size_t count = 0;
    for (;; ++count) {
      if (count % kLinesOfBlock == 0) {
        sums_ = files::sha256_of(sums_ + block);
        block.clear();
        starts_.push_back(file.tellg());
      }
      const std::size_t number = first_line_ + count;
      if (!next_line(file, line, number)) break;
      if (count == places) {
        throw CaseError(place_of(number) + ": one more than the " + std::to_string(places) +
                        " that are asked for");
      }
      parsed(line, number, [&](const JsonCursor& at) { check_answer_line(at, count); });
      block += line;
      block += '\n';
    }
    if (count < places) {
      throw CaseError(place_of(first_line_ + count) + ": ends after " + std::to_string(count) +
                      " answers of " + std::to_string(places));
    }
    sums_ = files::sha256_of(sums_ + block);
  }

  std::vector<std::string> lines_of(std::size_t block) const {
    std::ifstream file = opened();
    file.seekg(starts_[block]);
    std::vector<std::string> lines;
    for (std::string line; lines.size() < kLinesOfBlock && std::getline(file, line);)
      lines.push_back(line);
    lines.resize(kLinesOfBlock);  // if somebody cuts the file meanwhile there are lines that cannot
                                  // be read
    return lines;
  }

  std::filesystem::path path_;
  std::string name_;
  bool is_table_;
  Case query_;  ///< how an answer is read; its pose does not matter
  std::size_t first_line_ = 2;
  CaseWitness witness_;
  std::optional<double> tolerance_;
  std::vector<std::string> columns_;
  std::string sums_;  ///< the sums of all lines
  std::vector<std::streampos> starts_;
  BlockCache<std::string> blocks_;
};

}  // namespace

AnswerFile read_answer_file(const std::filesystem::path& path, const AnswersWanted& wanted) {
  auto lines = std::make_shared<const AnswerLines>(path, wanted);
  return {lines->witness(), lines, lines->tolerance()};
}

}  // namespace graze::compare
