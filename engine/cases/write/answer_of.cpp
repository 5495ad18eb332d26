#include <graze/bvh/error.h>
#include <graze/engine/cases/to_case.h>

#include <algorithm>

namespace graze {
namespace {

void require_finite(const RayHit& hit) {
  if (hit.point.allFinite()) return;
  throw InputError("to_case: a hit beyond the largest double is no answer that a file can hold");
}

}  // namespace

CaseAnswer answer_of(const TrianglePairs& pairs) {
  CaseAnswer answer;
  answer.pairs = pairs.pairs;
  return answer;
}

CaseAnswer answer_of(const TriangleList& triangles) {
  CaseAnswer answer;
  answer.triangles = triangles.triangles;
  return answer;
}

CaseAnswer answer_of(const MeshDistance& gap) {
  CaseAnswer answer;
  answer.distance = gap.distance;
  answer.point_a = gap.point_a;
  answer.point_b = gap.point_b;
  answer.pair = gap.pair;
  return answer;
}

CaseAnswer answer_of(const MeshContacts& contacts) {
  CaseAnswer answer;
  answer.contacts.emplace();
  for (const MeshContact& c : contacts)
    answer.contacts->push_back({c.point, c.point_a, c.point_b, c.normal, c.depth});
  return answer;
}

CaseAnswer answer_of(const MeshIntersection& intersection) {
  CaseAnswer answer;
  answer.intersection = in_parts(intersection);
  return answer;
}

CaseAnswer answer_of(const ShapeSeparation& separation) {
  CaseAnswer answer;
  answer.distance = std::max(-separation.distance, 0.0);
  answer.translation = *answer.distance * separation.normal;
  return answer;
}

CaseAnswer answer_of(const SeparatingTranslation& separation) {
  CaseAnswer answer;
  answer.distance = separation.distance;
  answer.translation = separation.translation;
  return answer;
}

CaseAnswer answer_of(const TriangleDistance& gap) {
  CaseAnswer answer;
  answer.distance = gap.distance;
  answer.point_a = gap.point_a;
  answer.point_b = gap.point_b;
  return answer;
}

CaseAnswer answer_of(const TriangleIntersection& intersection) {
  CaseAnswer answer;
  answer.corners.emplace(intersection.begin(), intersection.end());
  return answer;
}

CaseAnswer answer_of(const ShapeDistance& gap) {
  CaseAnswer answer;
  answer.distance = gap.distance;
  answer.lower_bound = gap.lower_bound;
  answer.is_converged = gap.status == PairStatus::Converged;
  answer.normal = gap.normal;
  answer.point_a = gap.point_a;
  answer.point_b = gap.point_b;
  return answer;
}

CaseAnswer answer_of(const Manifold& manifold) {
  CaseAnswer answer;
  answer.manifold.emplace();
  for (const ShapeContact& c : manifold)
    answer.manifold->push_back({c.point, c.point_a, c.point_b, c.normal, c.depth, c.feature});
  return answer;
}

CaseAnswer answer_of(const std::optional<RayHit>& first) {
  CaseAnswer answer;
  answer.hits.emplace();
  if (!first) return answer;
  require_finite(*first);
  answer.hits->push_back(*first);
  return answer;
}

CaseAnswer answer_of(const std::optional<TriangleRayHit>& hit) {
  std::optional<RayHit> first;
  if (hit) first = RayHit{.distance = hit->distance, .point = hit->point, .normal = hit->normal};
  return answer_of(first);
}

CaseAnswer answer_of(const std::vector<RayHit>& all) {
  for (const RayHit& hit : all)
    require_finite(hit);
  CaseAnswer answer;
  answer.hits = all;
  return answer;
}

}  // namespace graze
