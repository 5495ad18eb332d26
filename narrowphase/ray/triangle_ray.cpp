#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/derived/sign_of_products.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/ray/face_kernels.h>
#include <graze/narrowphase/ray/ray_stages.h>

namespace graze {
namespace narrowphase {
namespace {

constexpr double kZero[3] = {0, 0, 0};

/// Returns the sign of ((p - o) x (q - o)) . d.
Sign side_of_edge(const double* p, const double* q, const PreparedRay& ray, Stage& stage) {
  const double* o = ray.ray.origin.data();
  const Step along{kZero, ray.ray.direction.data()};
  if (const auto sign = triple_filter({o, p}, {o, q}, along)) return *sign;
  stage = Stage::Exact;
  return sign_of_triple({o, p}, {o, q}, along);
}

/// Says how the ray's line passes the triangle.
enum class Passage { Beside, Through, InPlane };

struct Pass {
  Passage passage;
  Sign against_normal;  ///< the sign of n . d, if the line goes through
};

Pass pass_of(const Triangle& t, const PreparedRay& ray, Stage& stage) {
  const double* corner[3] = {t.a.data(), t.b.data(), t.c.data()};
  Sign common = Sign::Zero;
  for (int i = 0; i < 3; ++i) {
    const Sign sign = side_of_edge(corner[i], corner[(i + 1) % 3], ray, stage);
    if (sign == Sign::Zero) continue;
    if (common != Sign::Zero && sign != common) return {Passage::Beside, Sign::Zero};
    common = sign;
  }
  return {common == Sign::Zero ? Passage::InPlane : Passage::Through, common};
}

Eigen::Vector3d against(const PreparedRay& ray) {
  const double* d = ray.scaled.component;
  const double length = -bvh::length_of(ray.scaled);
  return {d[0] / length, d[1] / length, d[2] / length};
}

/// Returns the normal times 1 or -1. Zeros are positive, so that they do not tell from which side
/// the ray came.
Eigen::Vector3d turned(const double* normal, double turn) {
  return {turn * normal[0] + 0.0, turn * normal[1] + 0.0, turn * normal[2] + 0.0};
}

std::optional<TriangleRayHit> hit_at(const RayPlace& place, const Eigen::Vector3d& normal,
                                     const PreparedRay& ray) {
  const double distance = place.scale * bvh::length_of(ray.scaled);
  if (!(distance <= ray.ray.max_distance)) return std::nullopt;
  return TriangleRayHit{distance, place.point, normal};
}

std::optional<TriangleRayHit> hit_on(const FaceValues& face, const PreparedRay& ray) {
  return hit_at(point_at(face.scale, ray), turned(face.normal, face.against_normal > 0 ? -1 : 1),
                ray);
}

}  // namespace

std::optional<TriangleRayHit> cast_ray(const Triangle& triangle, const PreparedRay& ray,
                                       Stage& stage) {
  stage = Stage::Triage;
  const Pass pass = pass_of(triangle, ray, stage);
  if (pass.passage == Passage::Beside) return std::nullopt;
  if (pass.passage == Passage::InPlane) {
    stage = Stage::Exact;
    const auto place = place_in_plane(triangle, ray);
    return place ? hit_at(*place, against(ray), ray) : std::nullopt;
  }
  // The plane is before the origin if the origin is on the side to which the ray goes.
  const double *a = triangle.a.data(), *b = triangle.b.data(), *c = triangle.c.data();
  const Sign side = orientation_3d(a, b, c, ray.ray.origin.data());
  if (side == pass.against_normal) return std::nullopt;
  FaceValues face;
  if (side != Sign::Zero &&
      face_values({{a, b, c}, ray.ray.origin.data(), ray.scaled.component}, face))
    return hit_on(face, ray);
  const RayPlace place =
      side == Sign::Zero ? RayPlace{0, ray.ray.origin} : place_on_face(triangle, ray);
  const bool is_against = pass.against_normal == Sign::Positive;
  return hit_at(place, turned(unit_normal(triangle).data(), is_against ? -1 : 1), ray);
}

std::optional<TriangleRayHit> cast_through(const double* a, const double* b, const double* c,
                                           const PreparedRay& ray) {
  FaceValues face;
  if (!face_values({{a, b, c}, ray.ray.origin.data(), ray.scaled.component}, face))
    return std::nullopt;
  return hit_on(face, ray);
}

}  // namespace narrowphase

std::optional<TriangleRayHit> cast_ray(const Triangle& triangle, const Ray& ray) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<TriangleRayHit> {
    narrowphase::check_finite(triangle, "triangle");
    check_ray(ray, "ray");
    narrowphase::Stage stage;
    return narrowphase::cast_ray(triangle, narrowphase::PreparedRay(ray), stage);
  });
}

}  // namespace graze
