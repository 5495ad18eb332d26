#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/mesh/inside/solid.h>

#include <utility>

namespace graze {
namespace {

/// Returns the limit that the case must name, too; a complete list has none.
template <typename List, typename Settings>
std::optional<std::uint32_t> limit_of(const List& list, const Settings& settings) {
  if (list.completeness == Completeness::Complete) return std::nullopt;
  if (settings.limit != list.size() || settings.volume != Settings{}.volume) {
    throw InputError(
        "to_case: a list that a limit has cut is asked for again with that limit and the volume "
        "that is the default; the settings say otherwise");
  }
  return static_cast<std::uint32_t>(list.size());
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

Hit hit_of(Touch touch) {
  return touch == Touch::Exclude ? Hit::Crossing : Hit::Touching;
}

CaseAnswer says_so(bool is_so) {
  CaseAnswer answer;
  answer.says = is_so;
  return answer;
}

}  // namespace

Case to_case(const PlacedMeshView& a, const PlacedMeshView& b, bool says,
             const QuerySettings& settings) {
  return make_case(Ask::Any, CaseMesh(a), CaseMesh(b), says_so(says), {.hit = settings.hit});
}

Case to_case(const PlacedMeshView& a, const CaseShape& volume, bool says,
             const VolumeQuerySettings& settings) {
  const bool is_solid = settings.interior == Interior::Solid;
  return make_case(Ask::Any, CaseMesh(a), volume, says_so(says),
                   {.hit = is_solid ? Hit::Solid : Hit::Touching});
}

Case to_case(const Triangle& a, const Triangle& b, Touch touch, bool says) {
  return make_case(Ask::Any, a, b, says_so(says), {.hit = hit_of(touch)});
}

Case to_case(const CaseShape& a, const CaseShape& b, bool says) {
  return make_case(Ask::Any, a, b, says_so(says));
}

Case to_case(const PlacedMeshView& a, const PlacedMeshView& b, const TrianglePairs& pairs,
             const PairSettings& settings) {
  return make_case(Ask::Pairs, CaseMesh(a), CaseMesh(b), answer_of(pairs),
                   {.hit = hit_of(settings.touch), .limit = limit_of(pairs, settings)});
}

Case to_case(const PlacedMeshView& a, const CaseShape& volume, const TriangleList& triangles,
             const TriangleSettings& settings) {
  return make_case(Ask::Pairs, CaseMesh(a), volume, answer_of(triangles),
                   {.limit = limit_of(triangles, settings)});
}

Case to_case(const PlacedMeshView& a, const PlacedMeshView& b, const MeshDistance& gap) {
  return make_case(Ask::Distance, CaseMesh(a), CaseMesh(b), answer_of(gap));
}

Case to_case_within(const PlacedMeshView& a, const PlacedMeshView& b, double clearance, bool says) {
  return make_case(Ask::Within, CaseMesh(a), CaseMesh(b), says_so(says), {.clearance = clearance});
}

Case to_case(const PlacedMeshView& a, const PlacedMeshView& b, const MeshContacts& contacts) {
  if (contacts.completeness != Completeness::Complete) {
    throw InputError("to_case: contacts that a limit has cut are no answer to ask for again");
  }
  return make_case(Ask::Contacts, CaseMesh(a), CaseMesh(b), answer_of(contacts));
}

Case to_case(const PlacedMeshView& a, const PlacedMeshView& b,
             const MeshIntersection& intersection) {
  return make_case(Ask::Intersection, CaseMesh(a), CaseMesh(b), answer_of(intersection));
}

Case to_case(const PlacedMeshView& a, const PlacedMeshView& b,
             const SeparatingTranslation& separation,
             const std::optional<Eigen::Vector3d>& direction) {
  return make_case(Ask::Separation, CaseMesh(a), CaseMesh(b), answer_of(separation),
                   {.direction = direction});
}

Case to_case(const Triangle& a, const Triangle& b, const TriangleDistance& gap) {
  return make_case(Ask::Distance, a, b, answer_of(gap));
}

Case to_case(const Triangle& a, const Triangle& b, const TriangleIntersection& intersection) {
  return make_case(Ask::Intersection, a, b, answer_of(intersection));
}

Case to_case(const CaseBody& a, const CaseBody& b, const ShapeDistance& gap) {
  return make_case(Ask::Distance, a, b, answer_of(gap));
}

Case to_case(const CaseBody& a, const CaseBody& b, const Manifold& manifold) {
  return make_case(Ask::Contacts, a, b, answer_of(manifold));
}

Case to_case(const CaseShape& shape, const Ray& ray, const std::optional<RayHit>& first) {
  return make_case(Ask::Ray, shape, ray, answer_of(first));
}

Case to_case(const Triangle& triangle, const Ray& ray, const std::optional<TriangleRayHit>& hit) {
  return make_case(Ask::Ray, triangle, ray, answer_of(hit));
}

Case to_case(const PlacedMeshView& mesh, const Ray& ray, const std::vector<RayHit>& all) {
  return make_case(Ask::RayAll, CaseMesh(mesh), ray, answer_of(all));
}

Case to_case_contains(const Mesh& mesh, const Eigen::Vector3d& point, bool is_inside) {
  return make_case(Ask::Contains, CaseMesh(mesh, Pose::Identity()), CasePoint{point},
                   says_so(is_inside));
}

Case to_case_contains(const CaseShape& volume, const Eigen::Vector3d& point, bool is_inside) {
  return make_case(Ask::Contains, volume, CasePoint{point}, says_so(is_inside));
}

Case to_case_self(const Mesh& mesh, bool crosses_itself) {
  return make_case(Ask::SelfAny, CaseMesh(mesh, Pose::Identity()), std::nullopt,
                   says_so(crosses_itself));
}

Case to_case_self(const Mesh& mesh, const TrianglePairs& self_pairs, const SelfSettings& settings) {
  return make_case(Ask::SelfPairs, CaseMesh(mesh, Pose::Identity()), std::nullopt,
                   answer_of(self_pairs),
                   {.self_kind = settings.kind, .limit = limit_of(self_pairs, settings)});
}

}  // namespace graze
