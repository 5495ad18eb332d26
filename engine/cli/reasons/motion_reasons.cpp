#include <graze/engine/cli/reasons/reasons.h>
#include <graze/engine/compare/judge/motions/motion_proofs.h>

#include <fmt/format.h>

namespace graze::cli {
namespace {

using compare::MotionProofs;

void append(Reasons more, Reasons& all) {
  for (std::string& each : more)
    all.push_back(std::move(each));
}

void add_contact(const MotionProofs& proofs, double time, Reasons& all) {
  all.push_back(fmt::format(
      "At {:.12g} of the way, which begins at 0 and ends at 1, they are in contact.", time));
  append(place_reasons(proofs.at(time, 0)), all);
}

void add_freedom_before(MotionProofs& proofs, double contact, Reasons& all) {
  const double until = proofs.proposed().low;
  if (until > 0 && proofs.is_free_until(until)) {
    all.push_back(fmt::format(
        "Until {:.12g} of the way they are apart, which a certificate proves for every moment, and "
        "not for samples of them: the first contact lies between these two times, {:.3g} of the "
        "way from each other.",
        until, contact - until));
  } else if (until > 0) {
    all.push_back(
        fmt::format("Until {:.12g} of the way no contact was found; there is no proof.", until));
  } else {
    all.push_back("They are in contact from the beginning.");
  }
}

/// Returns "free", a time, yes or no, in words.
std::string said(const Case& query) {
  const CaseAnswer& answer = *query.answer;
  if (query.ask == Ask::Free)
    return *answer.says ? "The answer says that they never meet."
                        : "The answer says that they meet.";
  if (*answer.status == RigidStatus::Free) return "The answer says that they never meet.";
  if (*answer.status == RigidStatus::Close)
    return fmt::format("The answer says that they come near at {:.12g}.", *answer.low);
  return fmt::format("The answer says that they meet at {:.12g}.", *answer.high);
}

/// Says by how much a wrong time is off.
std::string difference(const Case& query, double contact, const compare::Judgement& judgement) {
  const CaseAnswer& answer = *query.answer;
  const bool is_missed =
      query.ask == Ask::Free ? *answer.says : *answer.status == RigidStatus::Free;
  if (is_missed) {
    return fmt::format(
        "That contact is missed: at the worst moment of the way that was looked at "
        "the two are {:.3g} m deep in each other.",
        judgement.error);
  }
  if (query.ask == Ask::Free || !answer.low || !answer.high) return words_of_error(judgement);
  if (*answer.low > contact) {
    return fmt::format(
        "That is {:.3g} of the way too late: until then the two go {:.3g} m deep "
        "into each other.",
        *answer.low - contact, judgement.error);
  }
  return fmt::format("That is {:.3g} of the way too early: there they are {:.3g} m apart.",
                     contact - *answer.high, judgement.error);
}

}  // namespace

Reasons motion_reasons(const Case& query, const compare::Judgement& judgement) {
  MotionProofs proofs(query);
  const bool is_wrong = judgement.verdict == compare::Verdict::Wrong;
  Reasons all;
  if (const std::optional<double> contact = proofs.contact()) {
    add_contact(proofs, *contact, all);
    add_freedom_before(proofs, *contact, all);
    all.push_back(said(query));
    if (is_wrong) all.push_back(difference(query, *contact, judgement));
    return all;
  }
  const double nearest = proofs.nearest_time();
  if (proofs.is_free()) {
    all.push_back("They never meet: that is proved for the whole way, and not for samples of it.");
  } else {
    all.push_back(
        "Neither a contact nor that there is none is proved: they come too near to tell.");
  }
  all.push_back(
      fmt::format("Of the moments that were looked at they come nearest at {:.3g} of the "
                  "way.",
                  nearest));
  append(place_reasons(proofs.at(nearest, 0)), all);
  all.push_back(said(query));
  if (is_wrong) {
    all.push_back(
        fmt::format("There is no such contact: where the answer has one they are {:.3g} m "
                    "apart.",
                    judgement.error));
  }
  return all;
}

}  // namespace graze::cli
