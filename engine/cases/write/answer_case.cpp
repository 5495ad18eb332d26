#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/cases/to_case.h>
#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/inside/solid.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/version.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/engine/world/shape_ray.h>
#include <graze/engine/world/shape_separation.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_ray.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <graze/narrowphase/volumes/aabb_overlap.h>
#include <graze/narrowphase/volumes/contains.h>
#include <graze/narrowphase/volumes/obb_overlap.h>
#include <graze/narrowphase/volumes/sphere_box.h>
#include <graze/narrowphase/volumes/sphere_overlap.h>
#include <graze/narrowphase/volumes/triangle_sphere.h>

#include <limits>
#include <string>

namespace graze {
namespace {

[[noreturn]] void refuse(const Case& query) {
  throw InputError(std::string("no query answers \"") + name_of(query.ask) + "\" for a " +
                   name_of(query.a) + (query.b ? std::string(" and a ") + name_of(*query.b) : ""));
}

PlacedMeshView placed(const CaseMesh& mesh) {
  return {mesh.mesh, mesh.pose};
}

/// Asks intersects(A, B), if there is one.
struct AnyAnswer {
  const Case& query;
  Work* work;

  bool operator()(const Triangle& a, const Triangle& b) const {
    return intersects(a, b, touch_of(query.settings.hit));
  }
  template <typename B>
  bool operator()(const Triangle& a, const B& b) const {
    if constexpr (requires { intersects(a, b); }) return intersects(a, b);
    refuse(query);
  }
  bool operator()(const CaseMesh& a, const CaseMesh& b) const {
    return intersects(placed(a), placed(b), {.hit = query.settings.hit}, work);
  }
  bool operator()(const CaseBody& a, const CaseBody& b) const {
    return intersects({a.shape, a.pose}, {b.shape, b.pose}, work);
  }
  template <typename B>
  bool operator()(const CaseMesh& a, const B& b) const {
    if constexpr (requires { intersects(placed(a), b, VolumeQuerySettings{}, work); }) {
      const bool is_solid = query.settings.hit == Hit::Solid;
      return intersects(placed(a), b, {.interior = is_solid ? Interior::Solid : Interior::Surface},
                        work);
    }
    refuse(query);
  }
  template <typename A, typename B>
  bool operator()(const A& a, const B& b) const {
    if constexpr (requires { intersects(a, b); }) return intersects(a, b);
    refuse(query);
  }
};

std::size_t limit_of(const Case& query) {
  return query.settings.limit.value_or(std::numeric_limits<std::size_t>::max());
}

struct ListAnswer {
  const Case& query;
  const CaseMesh& a;
  Work* work;

  CaseAnswer operator()(const CaseMesh& b) const {
    return answer_of(find_triangle_pairs(
        placed(a), placed(b), {.limit = limit_of(query), .touch = touch_of(query.settings.hit)},
        work));
  }
  template <typename B>
  CaseAnswer operator()(const B& b) const {
    if constexpr (requires { find_triangles(placed(a), b); }) {
      return answer_of(find_triangles(placed(a), b, {.limit = limit_of(query)}, work));
    }
    refuse(query);
  }
};

CaseAnswer says(bool is_so) {
  CaseAnswer answer;
  answer.says = is_so;
  return answer;
}

struct ContainsAnswer {
  const Case& query;
  const Eigen::Vector3d& point;
  Work* work;

  bool operator()(const CaseMesh& a) const { return contains(a.mesh, point, work); }
  template <typename A>
  bool operator()(const A& a) const {
    if constexpr (requires { contains(a, point); }) return contains(a, point);
    refuse(query);
  }
};

CaseAnswer about_ray(const Case& query, const Ray& ray, Work* work) {
  if (const auto* mesh = std::get_if<CaseMesh>(&query.a)) {
    if (query.ask == Ask::RayAll) return answer_of(cast_ray_all(placed(*mesh), ray, work));
    return answer_of(cast_ray(placed(*mesh), ray, work));
  }
  if (query.ask == Ask::RayAll) refuse(query);
  if (const auto* t = std::get_if<Triangle>(&query.a)) return answer_of(cast_ray(*t, ray));
  if (const auto* body = std::get_if<CaseBody>(&query.a)) {
    return answer_of(cast_ray({body->shape, body->pose}, ray, work));
  }
  refuse(query);
}

CaseAnswer about_triangles(const Case& query, const Triangle& a, const Triangle& b) {
  if (query.ask == Ask::Distance) return answer_of(distance(a, b));
  if (query.ask == Ask::Intersection) return answer_of(intersection(a, b));
  refuse(query);
}

CaseAnswer about_bodies(const Case& query, const CaseBody& a, const CaseBody& b, Work* work) {
  if (query.ask == Ask::Distance) {
    return answer_of(distance({a.shape, a.pose}, {b.shape, b.pose}, work));
  }
  if (query.ask == Ask::Contacts) {
    return answer_of(find_contacts({a.shape, a.pose}, {b.shape, b.pose}, work));
  }
  if (query.ask == Ask::Separation && !query.settings.direction) {
    return answer_of(find_separation({a.shape, a.pose}, {b.shape, b.pose}, work));
  }
  if (query.ask == Ask::Within) {  // the answer as World::find_within() has it
    return says(distance({a.shape, a.pose}, {b.shape, b.pose}, work).distance <=
                query.settings.clearance);
  }
  refuse(query);
}

CaseAnswer about_motions(const Case& query, const CaseBody& a, const CaseBody& b, Work* work) {
  const RigidContactSettings settings = contact_settings(query.settings);
  if (query.ask == Ask::Free)
    return says(is_free({a.shape, motion_of(a)}, {b.shape, motion_of(b)}, settings, work));
  return answer_of(first_contact({a.shape, motion_of(a)}, {b.shape, motion_of(b)}, settings, work));
}

CaseAnswer about_motions(const Case& query, const CaseMesh& a, const CaseMesh& b, Work* work) {
  const RigidContactSettings settings = contact_settings(query.settings);
  if (query.ask == Ask::Free)
    return says(is_free({a.mesh, motion_of(a)}, {b.mesh, motion_of(b)}, settings, work));
  return answer_of(first_contact({a.mesh, motion_of(a)}, {b.mesh, motion_of(b)}, settings, work));
}

CaseAnswer about_two_meshes(const Case& query, const PlacedMeshView& a, const PlacedMeshView& b,
                            Work* work) {
  switch (query.ask) {
    case Ask::Distance:
      return answer_of(distance(a, b, {}, work));
    case Ask::Within:
      return says(within(a, b, query.settings.clearance, {}, work));
    case Ask::Contacts:
      return answer_of(find_contacts(a, b, {}, work));
    case Ask::Intersection:
      return answer_of(find_intersection(a, b, {}, work));
    case Ask::Separation:
      return query.settings.direction
                 ? answer_of(separating_translation(a, b, *query.settings.direction, work))
                 : answer_of(separating_translation(a, b, work));
    default:
      refuse(query);
  }
}

CaseAnswer about_itself(const Case& query, const Mesh& mesh, Work* work) {
  if (query.ask == Ask::SelfPairs) {
    return answer_of(
        find_self_pairs(mesh, {.kind = query.settings.self_kind, .limit = limit_of(query)}, work));
  }
  return says(self_intersects(mesh, work));
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
  if (query.ask == Ask::Contains) {
    const auto* point = std::get_if<CasePoint>(&*query.b);
    if (point == nullptr) refuse(query);
    return says(std::visit(ContainsAnswer{query, point->position, work}, query.a));
  }
  if (query.ask == Ask::Ray || query.ask == Ask::RayAll) {
    const auto* ray = std::get_if<Ray>(&*query.b);
    if (ray == nullptr) refuse(query);
    return about_ray(query, *ray, work);
  }
  if (mesh_a != nullptr && query.ask == Ask::Pairs) {
    return std::visit(ListAnswer{query, *mesh_a, work}, *query.b);
  }
  if (query.a.index() != query.b->index()) refuse(query);
  const auto* body_a = std::get_if<CaseBody>(&query.a);
  if (cases::is_about_motion(query.ask) && mesh_a != nullptr)
    return about_motions(query, *mesh_a, std::get<CaseMesh>(*query.b), work);
  if (cases::is_about_motion(query.ask) && body_a != nullptr)
    return about_motions(query, *body_a, std::get<CaseBody>(*query.b), work);
  if (mesh_a != nullptr) {
    return about_two_meshes(query, placed(*mesh_a), placed(std::get<CaseMesh>(*query.b)), work);
  }
  if (const auto* a = std::get_if<Triangle>(&query.a)) {
    return about_triangles(query, *a, std::get<Triangle>(*query.b));
  }
  if (body_a != nullptr) {
    return about_bodies(query, *body_a, std::get<CaseBody>(*query.b), work);
  }
  refuse(query);
}

CaseWitness this_library() {
  return {"graze", library_version()};
}

}  // namespace graze
