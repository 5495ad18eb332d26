#include <graze/engine/compare/judge/meshes/mesh_judges.h>
#include <graze/engine/compare/judge/meshes/pair_error.h>
#include <graze/engine/compare/judge/rational/in_metres.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/judge/rational/rational_inside.h>
#include <graze/engine/compare/judge/rational/volume_error.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

std::vector<Triangle> triangles_of(const Mesh& mesh, const Pose& pose) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
    triangles.push_back(place(pose, mesh.triangle(i)));
  return triangles;
}

bool has_part_inside(const CaseMesh& part, const std::vector<Triangle>& surface) {
  const std::vector<std::uint32_t> vertices = one_of_each_part(part.mesh);
  return std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t vertex) {
    return is_enclosed(surface, place(part.pose, part.mesh.vertices()[vertex]));
  });
}

Judgement told(bool is_inside, bool says, double error, double ulp) {
  Judgement judgement;
  judgement.truth = in_metres(is_inside ? "inside by" : "outside by", error);
  judgement.verdict = is_inside == says ? Verdict::Right : Verdict::Wrong;
  if (judgement.verdict == Verdict::Right) return judgement;
  judgement.error = error;
  judgement.ulps = error / ulp;
  judgement.error_class = judgement.ulps <= kTouchUlps ? ErrorClass::Touching : ErrorClass::Real;
  return judgement;
}

}  // namespace

Judgement judge_contains(const Case& query, bool says) {
  const Vector3d point = std::get<CasePoint>(*query.b).position;
  const Triangle there{point, point, point};
  if (const auto* mesh = std::get_if<CaseMesh>(&query.a)) {
    if (!mesh->mesh.topology().is_closed) return {};
    // The point is one of the mesh's own frame: no pose takes part.
    const std::vector<Triangle> surface = triangles_of(mesh->mesh, Pose::Identity());
    const bool is_inside = is_on_surface(surface, point) || is_enclosed(surface, point);
    const auto coordinates = std::max(mesh->mesh.bounds().min.cwiseAbs().maxCoeff(),
                                      mesh->mesh.bounds().max.cwiseAbs().maxCoeff());
    const Vector3d corner = Vector3d::Constant(coordinates);
    return told(is_inside, says, distance_to(surface, point),
                ulp_of(there, Triangle{corner, corner, corner}));
  }
  const bool is_volume = std::holds_alternative<Aabb>(query.a) ||
                         std::holds_alternative<Obb>(query.a) ||
                         std::holds_alternative<Sphere>(query.a);
  if (!is_volume) return {};
  // A triangle that is a point meets the volume if and only if the point lies in it.
  const VolumeError error = volume_error(there, query.a);
  const Vector3d corner = Vector3d::Constant(largest_coordinate(query.a));
  return told(error.is_hit, says, error.error, ulp_of(there, Triangle{corner, corner, corner}));
}

std::optional<bool> is_one_inside(const MeshCase& meshes) {
  if (!meshes.a.mesh.topology().is_closed || !meshes.b.mesh.topology().is_closed)
    return std::nullopt;
  return has_part_inside(meshes.a, triangles_of(meshes.b.mesh, meshes.b.pose)) ||
         has_part_inside(meshes.b, triangles_of(meshes.a.mesh, meshes.a.pose));
}

std::optional<bool> is_volume_inside(const CaseMesh& mesh, const CaseShape& volume) {
  if (!mesh.mesh.topology().is_closed) return std::nullopt;
  std::vector<Triangle> surface = triangles_of(mesh.mesh, mesh.pose);
  if (const auto* box = std::get_if<Aabb>(&volume)) return is_enclosed(surface, box->min);
  if (const auto* ball = std::get_if<Sphere>(&volume)) return is_enclosed(surface, ball->centre);
  const auto& box = std::get<Obb>(volume);
  std::transform(surface.begin(), surface.end(), surface.begin(),
                 [&](const Triangle& t) { return narrowphase::into_frame(t, box.pose); });
  return is_enclosed(surface, Vector3d::Zero());
}

}  // namespace graze::compare
