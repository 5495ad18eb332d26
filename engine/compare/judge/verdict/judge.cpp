#include <graze/engine/compare/judge/bodies/body_judges.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/compare/judge/meshes/mesh_judges.h>
#include <graze/engine/compare/judge/meshes/mesh_truth.h>
#include <graze/engine/compare/judge/motions/motion_judge.h>
#include <graze/engine/compare/judge/shape_judge.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/work.h>
#include <graze/engine/world/manifold.h>

#include <array>

namespace graze::compare {
namespace {

Judgement judge_ray(const Case& query, const CaseAnswer& answer, bool is_graze) {
  const auto* ray = std::get_if<Ray>(&*query.b);
  if (ray == nullptr) return {};
  const auto* body = std::get_if<CaseBody>(&query.a);
  if (body == nullptr) return judge_surface_ray(query, answer, is_graze);
  const Mesh* mesh = body->shape.as<Mesh>();
  if (mesh == nullptr) return judge_body_ray(*body, *ray, answer);
  Case of_mesh = query;
  of_mesh.a = CaseMesh(*mesh, body->pose);
  return judge_surface_ray(of_mesh, answer, is_graze);
}

/// True if graze says of itself that it has not found the least depth of these two.
bool has_no_least_depth(const PlacedBody& a, const PlacedBody& b) {
  Work work;
  find_contacts({a.shape, a.pose}, {b.shape, b.pose}, &work);
  return work.penetration_failures > 0;
}

PartsReview review_distance_or_contacts(const PlacedBody& a, const PlacedBody& b, const Case& query,
                                        const CaseAnswer& answer, bool is_graze,
                                        std::string& truth) {
  if (query.ask == Ask::Distance) return review_distance(a, b, answer, is_graze);
  return is_graze ? review_manifold(a, b, *answer.manifold, truth)
                  : review_others_contacts(a, b, *answer.manifold, truth);
}

/// Returns the class: small errors are of tolerance, whatever was found.
ErrorClass class_of(const ShapeJudge& judge, const Judgement& judgement) {
  const ErrorClass by_size = judge.class_of(judgement.error);
  return by_size == ErrorClass::Real ? judgement.error_class : by_size;
}

/// Judges whether they meet, and if that is right or not judged, what else is said of them.
Judgement judge_bodies(const ShapeJudge& judge, const Case& query, const CaseAnswer& answer,
                       const CaseWitness& witness) {
  const BodyCase pair = *as_bodies(query);
  const PlacedBody a{pair.a.shape, pair.a.pose};
  const PlacedBody b{pair.b.shape, pair.b.pose};
  if (query.ask == Ask::Any && answer.says) return judge.judge(*answer.says, witness);
  const bool is_graze = witness.engine == "graze";
  if (query.ask == Ask::Within && answer.says) {
    Judgement judgement = judge_within(a, b, judge.is_hit(), query, *answer.says, is_graze);
    judgement.ulps = judgement.error / judge.ulp();
    judgement.error_class = judge.class_of(judgement.error);
    return judgement;
  }
  if (query.ask == Ask::Separation && answer.distance && answer.translation) {
    Judgement judgement = judge_separation(a, b, judge.is_hit(), answer, is_graze);
    if (judgement.verdict == Verdict::Wrong && is_graze && has_no_least_depth(a, b)) {
      judgement = {};
      judgement.truth =
          "not judged: a way out of which the library says that it may not be the least";
    }
    judgement.ulps = judgement.error / judge.ulp();
    judgement.error_class = class_of(judge, judgement);
    return judgement;
  }
  const bool is_of_contacts = query.ask == Ask::Contacts && answer.manifold;
  if (!is_of_contacts && query.ask != Ask::Distance) return {};
  const bool says = is_of_contacts ? !answer.manifold->empty() : *answer.distance <= 0;
  Judgement judgement = judge.judge(says, witness);
  if (judgement.verdict == Verdict::Wrong) return judgement;
  PartsReview review = review_distance_or_contacts(a, b, query, answer, is_graze, judgement.truth);
  const bool is_excused = review.fault && is_of_contacts && is_graze && has_no_least_depth(a, b);
  if (is_excused) review = {.unjudged = "contacts whose least depth the library did not find"};
  add_review(judgement, review, judge.ulp());
  if (judgement.verdict == Verdict::Wrong) judgement.error_class = class_of(judge, judgement);
  return judgement;
}

}  // namespace

struct Judge::Truth {
  explicit Truth(const Case& the_query) : query(the_query) {
    if (query.ask == Ask::FirstContact || query.ask == Ask::Free) {
      motions.emplace(query);
      return;
    }
    if (const std::optional<MeshCase> pair = as_meshes(query)) meshes.emplace(query, *pair);
    if (const std::optional<BodyCase> pair = as_bodies(query)) {
      bodies.emplace(PlacedBody{pair->a.shape, pair->a.pose},
                     PlacedBody{pair->b.shape, pair->b.pose});
    }
  }

  const Case& query;
  std::optional<MeshTruth> meshes;
  std::optional<ShapeJudge> bodies;
  std::optional<MotionJudge> motions;
};

Judge::Judge(const Case& query) : truth_(std::make_unique<Truth>(query)) {}
Judge::~Judge() = default;

Judgement Judge::judge(const CaseAnswer& answer, const CaseWitness& witness) const {
  const bool is_graze = witness.engine == "graze";
  const Case& query = truth_->query;
  if (const std::optional<std::string> fault = fault_of_answer(query, answer)) {
    return engine_error(*fault);
  }
  if (!query.b) return {};
  if (query.ask == Ask::Ray || query.ask == Ask::RayAll) {
    return judge_ray(query, answer, is_graze);
  }
  if (query.ask == Ask::Contains) return judge_contains(query, *answer.says);
  if (truth_->motions) return truth_->motions->judge(answer, is_graze);
  if (truth_->bodies) return judge_bodies(*truth_->bodies, query, answer, witness);
  if (!truth_->meshes) return judge_volumes(query, answer, is_graze);
  return truth_->meshes->judge(answer, witness);
}

const char* name_of(Verdict verdict) {
  constexpr std::array kNames = {"right", "wrong", "not judged", "not confirmed"};
  return kNames[static_cast<std::size_t>(verdict)];
}

const char* name_of(ErrorClass error_class) {
  constexpr std::array kNames = {"touching",  "pose rounding", "coplanar", "degenerate",
                                 "not least", "containment",   "real",     "engine error"};
  return kNames[static_cast<std::size_t>(error_class)];
}

}  // namespace graze::compare
