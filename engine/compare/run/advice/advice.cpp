#include <graze/engine/compare/run/advice/advice.h>
#include <graze/engine/compare/run/advice/evidence.h>
#include <graze/engine/compare/run/advice/issue_text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace graze::compare {
namespace {

/// So many examples of a kind are looked at again.
constexpr std::size_t kMostLookedAt = 8;

std::string number(double value) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

/// Returns the next power of ten that is no less.
std::string rounded_up(double value) {
  if (!(value > 0) || !std::isfinite(value)) return "0";
  double power = std::pow(10.0, std::ceil(std::log10(value)));
  if (power < value) power *= 10;  // as the logarithm was rounded
  return number(power);
}

/// Holds what looking at the examples again has shown.
struct Seen {
  std::size_t looked_at = 0;
  std::size_t within_tolerance = 0;
  std::map<Single, std::size_t> single;
  std::size_t explained = 0;  ///< explained by the tolerance or by single precision
  std::vector<std::string> flat;

  bool is_all_explained() const { return looked_at > 0 && explained == looked_at; }
};

std::string flat_text(const std::string& name, const std::vector<std::uint32_t>& first,
                      std::size_t count, std::size_t all) {
  std::string text;
  for (const std::uint32_t each : first)
    text += (text.empty() ? "" : ", ") + std::to_string(each);
  return std::to_string(count) + " of the " + std::to_string(all) + " triangles of " + name + " (" +
         text + (count > first.size() ? ", ..." : "") + ")";
}

void add_flat(const WrongKind& kind, const Case& query, const Evidence& evidence, Seen& seen) {
  const std::optional<MeshCase> meshes = as_meshes(query);
  if (!meshes || !seen.flat.empty()) return;
  if (evidence.flat_count_a > 0) {
    seen.flat.push_back(flat_text(kind.name_a, evidence.flat_a, evidence.flat_count_a,
                                  meshes->a.mesh.triangles().size()));
  }
  if (evidence.flat_count_b > 0) {
    seen.flat.push_back(flat_text(kind.name_b, evidence.flat_b, evidence.flat_count_b,
                                  meshes->b.mesh.triangles().size()));
  }
}

Seen looked_again(const WrongKind& kind) {
  Seen seen;
  for (const WrongAnswer& each : kind.examples) {
    if (seen.looked_at == kMostLookedAt) break;
    ++seen.looked_at;
    const bool is_within = kind.tolerance && each.answer->judgement.error <= *kind.tolerance &&
                           kind.error_class != ErrorClass::EngineError;
    seen.within_tolerance += is_within;
    Evidence evidence;
    if (each.query) {
      const Case query = each.query();
      evidence = evidence_of(query, *each.answer);
      add_flat(kind, query, evidence, seen);
    }
    if (evidence.single) ++seen.single[*evidence.single];
    seen.explained += is_within || evidence.single.has_value();
  }
  return seen;
}

std::string single_words(Single single) {
  switch (single) {
    case Single::Poses:
      return "right once the poses are rounded to float: they are so where you hand them over, or "
             "where the engine keeps them";
    case Single::Vertices:
      return "right once poses and vertices are rounded to float: meshes go through single "
             "precision, in a file, in your wrapper or in the engine's build";
    case Single::Placed:
      return "right once the placed vertices are rounded to float: the engine places them in "
             "single precision";
    case Single::Arithmetic:
      return "off by no more than single precision makes it (64 ulp of float of the largest "
             "coordinate)";
  }
  return "";
}

std::string of_them(std::size_t count, const Seen& seen) {
  return std::to_string(count) + " of the " + std::to_string(seen.looked_at) +
         " that were looked at again ";
}

void add_evidence(const WrongKind& kind, const Seen& seen, Advice& advice) {
  if (seen.within_tolerance > 0) {
    advice.steps.push_back(
        {Remedy::Tolerance, of_them(seen.within_tolerance, seen) + "are within the " +
                                number(*kind.tolerance) +
                                " m that the engine itself states: allow for them, no bug is "
                                "worth reporting that is smaller."});
  }
  for (const auto& [single, count] : seen.single) {
    advice.steps.push_back(
        {Remedy::Precision, of_them(count, seen) + "are " + single_words(single) +
                                ". Build the engine in double, or scale and centre what you ask "
                                "about."});
  }
}

std::string sizes(const WrongKind& kind) {
  return "by at most " + number(kind.largest_error) + " m (" + number(kind.largest_ulps) + " ulp)";
}

std::string margin(const WrongKind& kind) {
  const std::string size = rounded_up(kind.largest_error);
  return "Take what is nearer than " + size +
         " m as undecided, or keep that much away; --fail-on '" + kind.engine + ">" + size +
         "' fails on what is larger alone.";
}

/// Adds what the class itself says.
void add_of_class(const WrongKind& kind, const Seen& seen, Advice& advice) {
  const auto add = [&](Remedy remedy, std::string words) {
    advice.steps.push_back({remedy, std::move(words)});
  };
  switch (kind.error_class) {
    case ErrorClass::Touching:
      return add(Remedy::Tolerance, "The two touch, or miss each other, " + sizes(kind) +
                                        ": your tolerance. " + margin(kind));
    case ErrorClass::PoseRounding:
      return add(Remedy::Poses,
                 "Rounding where things are placed has changed the answer, " + sizes(kind) +
                     ": your poses. Multiply fewer of them together, in double, keep rotations "
                     "orthonormal, and ask in a frame near to what you ask about. " +
                     margin(kind));
    case ErrorClass::Coplanar:
      return add(Remedy::Tolerance,
                 "Faces lie exactly in one plane, as where a part rests on "
                 "another, " +
                     sizes(kind) + ": say whether resting counts. " + margin(kind));
    case ErrorClass::Degenerate: {
      std::string which;
      for (const std::string& each : seen.flat)
        which += (which.empty() ? "" : " and ") + each;
      return add(Remedy::Triangles,
                 "Triangles without area mislead it" + (which.empty() ? "" : ": " + which) +
                     ". Remove them, or mend the mesh: graze info --check MESH names all of them.");
    }
    case ErrorClass::NotLeast:
      return add(Remedy::Question,
                 "What it calls the depth does part the two, but a shorter way does, " +
                     sizes(kind) +
                     ": not every engine means the least depth of all directions. See what the "
                     "makers of this one promise, and ask for the least where you need it.");
    case ErrorClass::Containment:
      return add(Remedy::Question,
                 "The surfaces do not meet, and one closed mesh lies inside the other: another "
                 "question is answered, of solids for one of surfaces or the other way round. "
                 "Ask which of them the engine means, and ask for that.");
    case ErrorClass::EngineError:
      add(Remedy::Guard,
          "It gave no answer. Be ready for that where you call it: a time limit, a check for what "
          "is no number, and no answer taken for \"free\".");
      break;
    case ErrorClass::Real:
      break;
  }
}

bool is_worth_reporting(const WrongKind& kind, const Seen& seen) {
  switch (kind.error_class) {
    case ErrorClass::Touching:
    case ErrorClass::PoseRounding:
    case ErrorClass::Containment:
      return false;
    default:
      return !seen.is_all_explained();
  }
}

}  // namespace

const char* name_of(Remedy remedy) {
  switch (remedy) {
    case Remedy::Tolerance:
      return "tolerance";
    case Remedy::Poses:
      return "poses";
    case Remedy::Precision:
      return "precision";
    case Remedy::Triangles:
      return "triangles";
    case Remedy::Question:
      return "question";
    case Remedy::Guard:
      return "guard";
    case Remedy::Threads:
      return "threads";
    case Remedy::Report:
      return "report";
  }
  return "";
}

Advice advise(const WrongKind& kind) {
  const Seen seen = looked_again(kind);
  Advice advice{.engine = kind.engine,
                .kind = name_of(kind.error_class),
                .count = kind.count,
                .looked_at = seen.looked_at,
                .steps = {}};
  add_evidence(kind, seen, advice);
  add_of_class(kind, seen, advice);
  if (is_worth_reporting(kind, seen)) {
    advice.issue = issue_text(kind);
    const bool is_real = kind.error_class == ErrorClass::Real;
    advice.steps.push_back(
        {Remedy::Report,
         (is_real ? "Off " + sizes(kind) + ", and no rounding of the input " +
                        (seen.explained > 0 ? "explains all of them" : "explains it")
                  : std::string("Tell those who make ") + kind.engine +
                        (kind.error_class == ErrorClass::NotLeast ? ", if they promise the least"
                                                                  : "")) +
             (is_real ? ": a bug to report" : "") +
             (advice.issue.empty() ? "." : "; the text of an issue is ready.")});
  }
  return advice;
}

Advice advise_unsteady(const std::string& engine, std::size_t count) {
  return {.engine = engine,
          .kind = name_of(Verdict::NotConfirmed),
          .count = count,
          .looked_at = 0,
          .steps = {{Remedy::Threads,
                     "Wrong once, and right when it was asked again where nothing else had been "
                     "asked: what it was asked before, or another thread, changes what it says. "
                     "Ask each instance from one thread; see whether --threads 1 is free of it."}}};
}

}  // namespace graze::compare
