#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/to_case.h>

#include <utility>

namespace graze {
namespace {

void check_complete(Completeness completeness) {
  if (completeness == Completeness::Complete) return;
  throw InputError("to_case: a list that a limit has cut is no answer that can be asked for again");
}

Case make_case(Ask ask, CaseShape a, std::optional<CaseShape> b, CaseAnswer answer,
               const CaseSettings& settings = {}) {
  return {.note = "",
          .ask = ask,
          .settings = settings,
          .a = std::move(a),
          .b = std::move(b),
          .answer = std::move(answer),
          .answered_by = this_library()};
}

CaseSettings settings_of(const QuerySettings& settings) {
  return {.touch = settings.touch, .interior = settings.interior};
}

CaseAnswer says_so(bool is_so) {
  CaseAnswer answer;
  answer.says = is_so;
  return answer;
}

}  // namespace

CaseAnswer answer_of(const TrianglePairs& pairs) {
  check_complete(pairs.completeness);
  CaseAnswer answer;
  answer.pairs = pairs.pairs;
  return answer;
}

CaseAnswer answer_of(const TriangleList& triangles) {
  check_complete(triangles.completeness);
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
  check_complete(contacts.completeness);
  CaseAnswer answer;
  answer.contacts.emplace();
  for (const MeshContact& c : contacts)
    answer.contacts->push_back({c.point, c.point_a, c.point_b, c.normal, c.depth});
  return answer;
}

CaseAnswer answer_of(const Separation& separation) {
  CaseAnswer answer;
  answer.distance = separation.distance;
  answer.translation = separation.translation;
  return answer;
}

Case to_case(const PlacedMesh& a, const PlacedMesh& b, bool says, const QuerySettings& settings) {
  return make_case(Ask::Any, CaseMesh(a), CaseMesh(b), says_so(says), settings_of(settings));
}

Case to_case(const CaseShape& a, const CaseShape& b, bool says, const QuerySettings& settings) {
  return make_case(Ask::Any, a, b, says_so(says), settings_of(settings));
}

Case to_case(const PlacedMesh& a, const PlacedMesh& b, const TrianglePairs& pairs,
             const PairSettings& settings) {
  return make_case(Ask::Pairs, CaseMesh(a), CaseMesh(b), answer_of(pairs),
                   {.touch = settings.touch});
}

Case to_case(const PlacedMesh& a, const CaseShape& volume, const TriangleList& triangles) {
  return make_case(Ask::Pairs, CaseMesh(a), volume, answer_of(triangles));
}

Case to_case(const PlacedMesh& a, const PlacedMesh& b, const MeshDistance& gap) {
  return make_case(Ask::Distance, CaseMesh(a), CaseMesh(b), answer_of(gap));
}

Case to_case_within(const PlacedMesh& a, const PlacedMesh& b, double clearance, bool says) {
  return make_case(Ask::Within, CaseMesh(a), CaseMesh(b), says_so(says), {.clearance = clearance});
}

Case to_case(const PlacedMesh& a, const PlacedMesh& b, const MeshContacts& contacts) {
  return make_case(Ask::Contacts, CaseMesh(a), CaseMesh(b), answer_of(contacts));
}

Case to_case(const PlacedMesh& a, const PlacedMesh& b, const Separation& separation) {
  return make_case(Ask::Separation, CaseMesh(a), CaseMesh(b), answer_of(separation));
}

Case to_case_contains(const Mesh& mesh, const Eigen::Vector3d& point, bool is_inside) {
  return make_case(Ask::Contains, CaseMesh(mesh, Pose::Identity()), CasePoint{point},
                   says_so(is_inside));
}

Case to_case_self(const Mesh& mesh, bool crosses_itself, const QuerySettings& settings) {
  return make_case(Ask::SelfAny, CaseMesh(mesh, Pose::Identity()), std::nullopt,
                   says_so(crosses_itself), settings_of(settings));
}

Case to_case_self(const Mesh& mesh, const TrianglePairs& self_pairs) {
  return make_case(Ask::SelfPairs, CaseMesh(mesh, Pose::Identity()), std::nullopt,
                   answer_of(self_pairs));
}

}  // namespace graze
