#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cli/reports/case_explanation.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/trial.h>
#include <graze/engine/files/source.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>

#include <fmt/format.h>
#include <cmath>

namespace graze::cli {
namespace {

using cases::json_plain_or_infinite;
using cases::json_string;
using compare::ClassicStep;
using compare::ClassicVariant;
using compare::MeshCase;
using compare::Verdict;

/// Returns the judge's pair, or else the first pair that touches, or the nearest.
TrianglePair pair_of(const MeshCase& meshes, const std::optional<TrianglePair>& culprit) {
  const PlacedMeshView a{meshes.a.mesh, meshes.a.pose};
  const PlacedMeshView b{meshes.b.mesh, meshes.b.pose};
  if (culprit && culprit->a < a.mesh.triangles().size() && culprit->b < b.mesh.triangles().size()) {
    return *culprit;
  }
  const TrianglePairs hits = find_triangle_pairs(a, b, {.limit = 1});
  return hits.empty() ? distance(a, b).pair : hits[0];
}

/// True if signs decide the answer: a number other than that of a touch is not decided by signs.
bool is_about_signs(const Case& query) {
  const CaseAnswer& answer = *query.answer;
  return answer.says || answer.pairs || (answer.distance && *answer.distance <= 0);
}

std::string no_blame(const CaseExplanation& e) {
  if (e.judgement.error_class == compare::ErrorClass::Containment) {
    return "The surfaces do not meet, and one closed mesh is inside the other: the engine answers "
           "for solids, or what it was asked was meant for surfaces.";
  }
  return "None of these textbook tests gives that answer in double. Look elsewhere: at boxes that "
         "are too small by rounding, a pose that was turned or inverted, a triangle that was left "
         "out, a tolerance.";
}

std::vector<ClassicVariant> variants_in(const std::vector<ClassicVariant>& variants,
                                        compare::ClassicNumbers numbers) {
  std::vector<ClassicVariant> some;
  for (const ClassicVariant& variant : variants)
    if (variant.numbers == numbers) some.push_back(variant);
  return some;
}

/// True if an answer is gone through by tests of two triangles.
bool has_textbook_tests(const Case& query) {
  const bool is_asked =
      query.ask == Ask::Any || query.ask == Ask::Pairs || query.ask == Ask::Distance;
  return is_asked && compare::as_meshes(query);
}

void explain_wrong(const Case& query, CaseExplanation& e) {
  if (e.reasons) {
    e.why = "The answer is wrong.";
    return;
  }
  if (!has_textbook_tests(query)) {
    e.why = fmt::format(
        "An answer to \"{}\" about these is judged, as the truth above says, but not explained: "
        "answers about two triangles, two meshes at rest, shapes, motions, rays and points are.",
        name_of(query.ask));
    return;
  }
  const std::optional<MeshCase> meshes = compare::as_meshes(query);
  e.pair = pair_of(*meshes, e.judgement.culprit);
  e.variants = compare::classic_variants({meshes->a.mesh.triangle(e.pair->a), meshes->a.pose,
                                          meshes->b.mesh.triangle(e.pair->b), meshes->b.pose});
  if (!is_about_signs(query)) {
    e.why = fmt::format(
        "The answer is a number, which is off by {:.3g} m: {:.3g} ulp of double, {:.3g} of float.",
        e.judgement.error, e.judgement.ulps, e.judgement.ulps * 0x1p-29);
    return;
  }
  const bool says = !e.variants.front().placed_touch;
  const std::optional<std::string> in_double =
      compare::blame(variants_in(e.variants, compare::ClassicNumbers::Double), says);
  const std::optional<std::string> in_float =
      compare::blame(variants_in(e.variants, compare::ClassicNumbers::Float), says);
  if (in_double) {
    e.why = *in_double;
  } else if (in_float && e.judgement.ulps > compare::kTouchUlps) {
    e.why = *in_float;
  } else {
    e.why = no_blame(e);
    // This near to a touch float is wrong every other time, whoever was wrong here.
    if (in_float) e.why += " Or, if the engine computes in float: " + *in_float;
  }
}

const char* yes(bool says) {
  return says ? "yes" : "no";
}

/// Returns a number as JSON has it: there is none for one that overflows.
std::string number_json(double value) {
  return std::isfinite(value) ? cases::json_plain_number(value) : "null";
}

std::string step_json(const ClassicStep& step) {
  return fmt::format("{{\"name\":{},\"computed\":{},\"exact\":{},\"ulps\":{}}}",
                     json_string(step.name), number_json(step.computed), number_json(step.exact),
                     number_json(step.ulps));
}

std::string variant_json(const ClassicVariant& variant) {
  std::string out = fmt::format(
      "{{\"placed\":{},\"numbers\":{},\"moved\":{},\"touch\":{},\"axes\":{},\"determinants\":{},"
      "\"misleading\":[",
      json_string(name_of(variant.frame)), json_string(name_of(variant.numbers)),
      json_plain_or_infinite(variant.moved), variant.placed_touch, variant.axes.says,
      variant.determinants.says);
  const char* separator = "";
  for (const compare::ClassicRun* run : {&variant.axes, &variant.determinants}) {
    const ClassicStep* step = run->misleading(variant.placed_touch);
    if (step == nullptr) continue;
    out += separator + step_json(*step);
    separator = ",";
  }
  return out + "]}";
}

}  // namespace

CaseExplanation explain_case(const Case& query) {
  const CaseWitness& witness = query.answered_by;
  CaseExplanation e{
      .question = name_of(query.ask),
      .engine = witness.engine + (witness.version.empty() ? "" : " " + witness.version),
      .says = compare::brief(*query.answer),
      .judgement = compare::Judge(query).judge(*query.answer, witness),
      .why = ""};
  e.reasons = reasons_of(query, e.judgement);
  switch (e.judgement.verdict) {
    case Verdict::Wrong:
      explain_wrong(query, e);
      break;
    case Verdict::Right:
      e.why = "The answer is right.";
      break;
    default:
      e.why = "The referee could not judge all of it, and found nothing wrong.";
  }
  return e;
}

std::string to_text(const CaseExplanation& e) {
  const compare::Judgement& judgement = e.judgement;
  std::string text = fmt::format(
      "  question         {}\n  {:<16} says {}\n  truth            {}\n  verdict          {}",
      e.question, mesh_io::printable(e.engine), e.says, judgement.truth,
      name_of(judgement.verdict));
  if (judgement.verdict == Verdict::Wrong) {
    text += fmt::format(": {}, off by {:.3g} m, {:.3g} ulp", name_of(judgement.error_class),
                        judgement.error, judgement.ulps);
  }
  text += "\n";
  if (e.pair) {
    text +=
        fmt::format("  shown by         triangle {} of A and {} of B\n\n", e.pair->a, e.pair->b);
    text += fmt::format("  {:<20}{:<9}{:<15}{:<11}{:<7}{}\n", "placed", "in", "moved by (m)",
                        "do touch", "axes", "determinants");
    for (const ClassicVariant& variant : e.variants) {
      text += fmt::format("  {:<20}{:<9}{:<15.3g}{:<11}{:<7}{}\n", name_of(variant.frame),
                          name_of(variant.numbers), variant.moved, yes(variant.placed_touch),
                          yes(variant.axes.says), yes(variant.determinants.says));
    }
    text += "\n";
  }
  if (e.reasons) text += "\n";
  for (const std::string& reason : e.reasons.value_or(Reasons()))
    text += reason + "\n";
  return text + e.why + "\n";
}

std::string to_json(const CaseExplanation& e) {
  const compare::Judgement& judgement = e.judgement;
  std::string out =
      fmt::format("{{\"question\":{},\"engine\":{},\"says\":{},\"verdict\":{},\"truth\":{}",
                  json_string(e.question), json_string(e.engine), json_string(e.says),
                  json_string(name_of(judgement.verdict)), json_string(judgement.truth));
  if (judgement.verdict == Verdict::Wrong) {
    out += fmt::format(
        ",\"class\":{},\"error\":{},\"ulps\":{}", json_string(name_of(judgement.error_class)),
        json_plain_or_infinite(judgement.error), json_plain_or_infinite(judgement.ulps));
  }
  if (e.pair) {
    out += fmt::format(",\"pair\":[{},{}],\"variants\":", e.pair->a, e.pair->b);
    out += cases::json_list(e.variants, ",", variant_json);
  }
  if (e.reasons) {
    out += ",\"reasons\":" + cases::json_list(*e.reasons, ",", [](const std::string& each) {
             return json_string(each);
           });
  }
  return out + ",\"why\":" + json_string(e.why) + "}\n";
}

}  // namespace graze::cli
