#include <tests/oracle/case_text.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <span>
#include <sstream>

namespace graze::oracle {
namespace {

constexpr const char* kPairWord = "triangle_triangle";
constexpr const char* kBoxWord = "triangle_box";
constexpr const char* kTrueWord = "intersects";
constexpr const char* kFalseWord = "apart";

struct Word {
  std::string text;
  int line;
};

std::vector<Word> words_of(const std::filesystem::path& path) {
  std::ifstream stream(path);
  if (!stream) throw CaseError(path.string() + ": cannot be read");
  std::vector<Word> words;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    std::istringstream fields(line.substr(0, line.find('#')));
    for (std::string text; fields >> text;)
      words.push_back({text, number});
  }
  return words;
}

class Parser {
 public:
  Parser(const std::filesystem::path& path) : name_(path.string()), words_(words_of(path)) {}

  bool is_at_end() const { return next_ == words_.size(); }

  KnownCase next_case() {
    KnownCase result;
    result.line = words_[next_].line;
    const std::string kind = next_word().text;
    if (kind != kPairWord && kind != kBoxWord) fail(result.line, "unknown kind '" + kind + "'");
    const Word answer = next_word();
    if (answer.text != kTrueWord && answer.text != kFalseWord) {
      fail(answer.line, "unknown answer '" + answer.text + "'");
    }
    result.intersects = answer.text == kTrueWord;
    if (kind == kPairWord) {
      result.shapes = TrianglePair{next_triangle(), next_triangle()};
    } else {
      result.shapes = TriangleAndBox{next_triangle(), {next_point(), next_point()}};
    }
    return result;
  }

  [[noreturn]] void fail(int line, const std::string& why) const {
    throw CaseError(name_ + ":" + std::to_string(line) + ": " + why);
  }

 private:
  const Word& next_word() {
    if (is_at_end()) fail(words_.back().line, "the file ends within a case");
    return words_[next_++];
  }

  double next_number() {
    const Word& word = next_word();
    char* end = nullptr;
    const double value = std::strtod(word.text.c_str(), &end);
    if (*end != '\0' || !std::isfinite(value)) {
      fail(word.line, "not a finite number: '" + word.text + "'");
    }
    return value;
  }

  Eigen::Vector3d next_point() {
    return Eigen::Vector3d{next_number(), next_number(), next_number()};
  }

  Triangle next_triangle() { return {next_point(), next_point(), next_point()}; }

  std::string name_;
  std::vector<Word> words_;
  std::size_t next_ = 0;
};

std::string to_text(const char* kind, bool intersects, std::span<const Eigen::Vector3d> points) {
  std::string text = std::string(kind) + " " + (intersects ? kTrueWord : kFalseWord) + "\n";
  for (const Eigen::Vector3d& p : points) {
    char line[128];
    std::snprintf(line, sizeof line, "  %a %a %a\n", p.x(), p.y(), p.z());
    text += line;
  }
  return text;
}

}  // namespace

std::vector<KnownCase> read_cases(const std::filesystem::path& path) {
  Parser parser(path);
  if (parser.is_at_end()) parser.fail(1, "no case");
  std::vector<KnownCase> cases;
  while (!parser.is_at_end())
    cases.push_back(parser.next_case());
  return cases;
}

std::string to_text(const TrianglePair& pair, bool intersects) {
  const Eigen::Vector3d points[] = {pair.a.a, pair.a.b, pair.a.c, pair.b.a, pair.b.b, pair.b.c};
  return to_text(kPairWord, intersects, points);
}

std::string to_text(const TriangleAndBox& pair, bool intersects) {
  const Triangle& t = pair.triangle;
  const Eigen::Vector3d points[] = {t.a, t.b, t.c, pair.box.min, pair.box.max};
  return to_text(kBoxWord, intersects, points);
}

}  // namespace graze::oracle
