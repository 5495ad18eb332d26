#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/run/advice/issue_text.h>
#include <graze/engine/compare/run/advice/plain_case.h>
#include <graze/engine/compare/run/trial.h>

#include <array>
#include <cstdio>
#include <optional>

namespace graze::compare {
namespace {

/// The numbers of longer cases are left to the file.
constexpr std::size_t kLongestCase = 6000;

std::string question_in_words(Ask ask) {
  switch (ask) {
    case Ask::Any:
      return "do the two intersect (touching counts)";
    case Ask::Pairs:
      return "which pairs of triangles intersect (touching counts)";
    case Ask::Distance:
      return "how far apart are the two";
    case Ask::Within:
      return "are the two no further apart than a clearance";
    case Ask::Contacts:
      return "where do the two touch, along which normal, how deep";
    case Ask::FirstContact:
      return "when do the two meet first on their way";
    case Ask::Free:
      return "does the motion stay free of contact";
    default:
      return name_of(ask);
  }
}

std::string size_text(const Judgement& judgement) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.3g m, %.3g ulp", judgement.error, judgement.ulps);
  return text.data();
}

/// Holds what is known of the error that is told: of the least case, or else of the first example.
struct Told {
  const Case* query = nullptr;
  const Judgement* judgement = nullptr;
  std::string says;
};

std::string numbers_of(const Case& query) {
  Case bare = query;
  bare.note.clear();
  return with_plain_numbers(to_json(bare));
}

}  // namespace

std::string issue_text(const WrongKind& kind) {
  if (kind.least == nullptr && kind.examples.empty()) return "";
  std::optional<Case> asked;
  Told told;
  if (kind.least != nullptr) {
    const std::optional<CaseAnswer>& answer = kind.least->query.answer;
    told = {&kind.least->query, &kind.least->judgement, answer ? brief(*answer) : "nothing"};
  } else {
    const WrongAnswer& first = kind.examples.front();
    if (first.query) asked = first.query();
    told = {asked ? &*asked : nullptr, &first.answer->judgement, first.answer->brief};
  }
  const bool is_fault = kind.error_class == ErrorClass::EngineError;
  const std::string who = kind.engine + (kind.version.empty() ? "" : " " + kind.version);
  std::string text = "# ";
  text += is_fault ? "No answer: " + told.judgement->truth
                   : "Wrong answer: says " + told.says + ", the truth is " + told.judgement->truth;
  text += "\n\n- Engine: " + who + "\n";
  if (told.query != nullptr) text += "- Question: " + question_in_words(told.query->ask) + "\n";
  if (is_fault) {
    text += "- Expected: an answer\n- Got: " + told.judgement->truth + "\n";
  } else {
    text += "- Expected: " + told.judgement->truth +
            ", settled in exact rational arithmetic for the vertices as they are placed\n- Got: " +
            told.says + ", off by " + size_text(*told.judgement) + "\n";
  }
  if (kind.count > 1) {
    text += "- Seen: " + std::to_string(kind.count) + " times in one run, of which this is " +
            (kind.least != nullptr && kind.least->is_smaller ? "one, made smaller\n" : "one\n");
  }
  const std::string least = kind.least != nullptr ? least_size(*kind.least) : "";
  if (!least.empty()) text += "- The case " + least + "\n";
  if (!kind.file.empty()) text += "- To see it again: `graze replay " + kind.file + "`\n";
  if (told.query == nullptr) return text;
  const std::string numbers = numbers_of(*told.query);
  if (numbers.size() <= kLongestCase) {
    text +=
        "\nThe case, lengths in metres, poses the rows of [R | t], numbers with as many digits "
        "as read back as the same double:\n\n```json\n" +
        numbers + "```\n";
  } else if (!kind.file.empty()) {
    text += "\nThe case is in the file above (JSON).\n";
  }
  return text;
}

}  // namespace graze::compare
