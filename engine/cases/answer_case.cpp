#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/narrowphase/derived/triangle_distance.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <graze/narrowphase/volumes/aabb_overlap.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <string>

namespace graze {
namespace {

[[noreturn]] void refuse(const Case& query) {
  throw InputError(std::string("no query answers \"") + name_of(query.ask) + "\" for a " +
                   name_of(query.a) + (query.b ? std::string(" and a ") + name_of(*query.b) : ""));
}

PlacedMesh placed(const CaseMesh& mesh) {
  return {mesh.mesh, mesh.pose};
}

QuerySettings settings_of(const Case& query) {
  return {.touch = query.settings.touch, .interior = query.settings.interior};
}

/// intersects(A, B) or overlaps(A, B), whichever there is.
struct AnyAnswer {
  const Case& query;
  Work* work;

  bool operator()(const Triangle& a, const Triangle& b) const { return intersects(a, b); }
  template <typename B>
  bool operator()(const Triangle& a, const B& b) const {
    if constexpr (requires { intersects(a, b); }) return intersects(a, b);
    refuse(query);
  }
  bool operator()(const CaseMesh& a, const CaseMesh& b) const {
    return intersects(placed(a), placed(b), settings_of(query), work);
  }
  bool operator()(const CaseBody& a, const CaseBody& b) const {
    return intersects(a.shape, a.pose, b.shape, b.pose, work);
  }
  template <typename B>
  bool operator()(const CaseMesh& a, const B& b) const {
    if constexpr (requires { intersects(placed(a), b, settings_of(query), work); }) {
      return intersects(placed(a), b, settings_of(query), work);
    }
    refuse(query);
  }
  template <typename A, typename B>
  bool operator()(const A& a, const B& b) const {
    if constexpr (requires { overlaps(a, b); }) return overlaps(a, b);
    refuse(query);
  }
};

struct ListAnswer {
  const Case& query;
  const CaseMesh& a;
  Work* work;

  CaseAnswer operator()(const CaseMesh& b) const {
    return answer_of(
        find_triangle_pairs(placed(a), placed(b), {.touch = query.settings.touch}, work));
  }
  template <typename B>
  CaseAnswer operator()(const B& b) const {
    if constexpr (requires { find_triangles(placed(a), b); }) {
      return answer_of(find_triangles(placed(a), b, {}, work));
    }
    refuse(query);
  }
};

CaseAnswer says(bool is_so) {
  CaseAnswer answer;
  answer.says = is_so;
  return answer;
}

CaseAnswer about_two_meshes(const Case& query, const PlacedMesh& a, const PlacedMesh& b,
                            Work* work) {
  switch (query.ask) {
    case Ask::Distance:
      return answer_of(distance(a, b, {}, work));
    case Ask::Within:
      return says(within(a, b, query.settings.clearance, {}, work));
    case Ask::Contacts:
      return answer_of(find_contacts(a, b, {}, work));
    case Ask::Separation:
      return answer_of(separating_translation(a, b, work));
    default:
      refuse(query);
  }
}

CaseAnswer about_itself(const Case& query, const Mesh& mesh, Work* work) {
  if (query.ask == Ask::SelfPairs) return answer_of(find_self_pairs(mesh, {}, work));
  return says(self_intersects(mesh, {.touch = query.settings.touch}, work));
}

CaseAnswer of_triangles(const TriangleDistance& gap) {
  CaseAnswer answer;
  answer.distance = gap.distance;
  answer.point_a = gap.point_a;
  answer.point_b = gap.point_b;
  return answer;
}

}  // namespace

CaseAnswer answer_case(const Case& query, Work* work) {
  const auto* mesh_a = std::get_if<CaseMesh>(&query.a);
  if (query.ask == Ask::SelfAny || query.ask == Ask::SelfPairs) {
    if (mesh_a == nullptr) refuse(query);
    return about_itself(query, mesh_a->mesh, work);
  }
  if (!query.b) refuse(query);
  if (query.ask == Ask::Any) return says(std::visit(AnyAnswer{query, work}, query.a, *query.b));
  if (const auto* a = std::get_if<Triangle>(&query.a)) {
    const auto* b = std::get_if<Triangle>(&*query.b);
    if (query.ask != Ask::Distance || b == nullptr) refuse(query);
    return of_triangles(distance(*a, *b));
  }
  if (mesh_a == nullptr) refuse(query);
  if (query.ask == Ask::Pairs) return std::visit(ListAnswer{query, *mesh_a, work}, *query.b);
  if (query.ask == Ask::Contains) {
    const auto* point = std::get_if<CasePoint>(&*query.b);
    if (point == nullptr) refuse(query);
    return says(contains(mesh_a->mesh, point->position, work));
  }
  const auto* mesh_b = std::get_if<CaseMesh>(&*query.b);
  if (mesh_b == nullptr) refuse(query);
  return about_two_meshes(query, placed(*mesh_a), placed(*mesh_b), work);
}

CaseWitness this_library() {
  return {"graze", GRAZE_VERSION};
}

}  // namespace graze
