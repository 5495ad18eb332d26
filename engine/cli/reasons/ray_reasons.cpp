#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cli/reasons/reasons.h>
#include <graze/engine/compare/judge/judge.h>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace graze::cli {
namespace {

using compare::Verdict;

/// Returns what the library answers, once the judge has found it right, and else nothing.
std::optional<CaseAnswer> proved_answer(const Case& query) {
  const CaseAnswer answer = answer_case(query);
  const compare::Judgement judgement = compare::Judge(query).judge(answer, {"graze", ""});
  return judgement.verdict == Verdict::Right ? std::optional(answer) : std::nullopt;
}

std::string words_of_hit(const RayHit& hit) {
  const std::string where =
      hit.triangle == kNoTriangle ? "" : fmt::format(" in triangle {}", hit.triangle);
  return fmt::format("meets the surface{} after {:.12g} m, at {}, where the surface faces {}",
                     where, hit.distance, words_of(hit.point), words_of(hit.normal));
}

void add_difference(const CaseAnswer& told, const CaseAnswer& truth, Reasons& all) {
  const bool is_told = told.hits && !told.hits->empty();
  if (!is_told) {
    all.push_back(truth.hits->empty() ? "The answer says so, too."
                                      : "The answer says that it meets nothing.");
    return;
  }
  const RayHit& first = told.hits->front();
  all.push_back("The answer says that it " + words_of_hit(first) + ".");
  if (truth.hits->empty()) return;
  const double off = first.distance - truth.hits->front().distance;
  if (off != 0) {
    all.push_back(fmt::format("That is {:.3g} m too {}.", std::abs(off), off > 0 ? "far" : "near"));
  }
}

}  // namespace

Reasons ray_reasons(const Case& query, const compare::Judgement& judgement) {
  const Ray& ray = std::get<Ray>(*query.b);
  Reasons all = {fmt::format("The ray begins at {}, goes along {} and ends after {:.6g} m.",
                             words_of(ray.origin), words_of(ray.direction.normalized()),
                             ray.max_distance)};
  const std::optional<CaseAnswer> truth = proved_answer(query);
  if (!truth || !truth->hits) {
    all.push_back(
        "It comes nearer to an edge or to the surface than can be told: " + judgement.truth + ".");
    return all;
  }
  if (truth->hits->empty()) all.push_back("It meets nothing.");
  constexpr std::size_t kMost = 4;  // so many of a ray's hits are told
  for (std::size_t i = 0; i < std::min(truth->hits->size(), kMost); ++i)
    all.push_back((i == 0 ? "It first " : "Then it ") + words_of_hit((*truth->hits)[i]) + ".");
  if (truth->hits->size() > kMost)
    all.push_back(fmt::format("There are {} hits in all.", truth->hits->size()));
  add_difference(*query.answer, *truth, all);
  return all;
}

Reasons inside_reasons(const Case& query) {
  const Eigen::Vector3d& point = std::get<CasePoint>(*query.b).position;
  const std::optional<CaseAnswer> truth = proved_answer(query);
  if (!truth) return {"Of a mesh that is not closed nobody can say what is inside."};
  const std::string is = *truth->says ? "is inside, or on the surface" : "is outside";
  const auto* mesh = std::get_if<CaseMesh>(&query.a);
  Reasons all = {fmt::format("The point {} {}.", words_of(point), is)};
  if (mesh == nullptr) {
    const compare::Judgement judgement = compare::Judge(query).judge(*truth, {"graze", ""});
    all.push_back("In rational numbers it is " + judgement.truth +
                  "; what lies on the surface counts.");
    return all;
  }
  const Ray ray{point, {1, 0, 0}};
  const std::size_t count = cast_ray_all({mesh->mesh}, ray).size();
  all.push_back(
      fmt::format("Who goes from it along x meets the closed surface {} time{}: an odd "
                  "number leads out of it. Where the ray passes an edge the count "
                  "misleads, and the referee moves it aside exactly.",
                  count, count == 1 ? "" : "s"));
  return all;
}

}  // namespace graze::cli
