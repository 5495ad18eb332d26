#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/derived/sign_of_products.h>
#include <graze/narrowphase/predicates/predicates.h>
#include <graze/narrowphase/ray/face_kernels.h>
#include <graze/narrowphase/ray/ray_stages.h>

namespace graze {
namespace narrowphase {
namespace {

constexpr double kZero[3] = {0, 0, 0};

/// ((p - o) x (q - o)) . d
Sign side_of_edge(const double* p, const double* q, const PreparedRay& ray, Stage& stage) {
  const double* o = ray.ray.origin.data();
  const Step along{kZero, ray.ray.direction.data()};
  if (const auto sign = triple_filter({o, p}, {o, q}, along)) return *sign;
  stage = Stage::Exact;
  return sign_of_triple({o, p}, {o, q}, along);
}

/// How the ray's line passes the triangle.
enum class Passage { Beside, Through, InPlane };

struct Pass {
  Passage passage;
  Sign against_normal;  ///< n . d, if it goes through
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
  const double length = -ray.scaled.length;
  return {d[0] / length, d[1] / length, d[2] / length};
}

}  // namespace

std::optional<TriangleRayHit> cast_ray(const Triangle& triangle, const PreparedRay& ray,
                                       Stage& stage) {
  stage = Stage::Triage;
  const Pass pass = pass_of(triangle, ray, stage);
  if (pass.passage == Passage::Beside) return std::nullopt;
  std::optional<RayPlace> place;
  if (pass.passage == Passage::InPlane) {
    stage = Stage::Exact;
    place = place_in_plane(triangle, ray);
    if (!place) return std::nullopt;
  } else {
    // The plane is before the origin if the origin is on the side to which the ray goes.
    const Sign side = orientation_3d(triangle.a.data(), triangle.b.data(), triangle.c.data(),
                                     ray.ray.origin.data());
    if (side == pass.against_normal) return std::nullopt;
    place = side == Sign::Zero ? RayPlace{0, ray.ray.origin} : place_on_face(triangle, ray);
  }
  const double distance = place->scale * ray.scaled.length;
  if (!(distance <= ray.ray.max_distance)) return std::nullopt;
  if (pass.passage == Passage::InPlane) return TriangleRayHit{distance, place->point, against(ray)};
  Eigen::Vector3d normal = unit_normal(triangle);
  if (pass.against_normal == Sign::Positive) {
    for (int k = 0; k < 3; ++k)
      normal.data()[k] = -normal.data()[k];
  }
  return TriangleRayHit{distance, place->point, normal};
}

std::optional<TriangleRayHit> cast_through(const double* a, const double* b, const double* c,
                                           const PreparedRay& ray) {
  const double* d = ray.scaled.component;
  const double* o = ray.ray.origin.data();
  FaceValues face;
  if (!face_values({{a, b, c}, o, d}, face)) return std::nullopt;
  const double distance = face.scale * ray.scaled.length;
  if (!(distance <= ray.ray.max_distance)) return std::nullopt;
  const double turn = face.against_normal > 0 ? -1 : 1;
  return TriangleRayHit{
      distance,
      {o[0] + face.scale * d[0], o[1] + face.scale * d[1], o[2] + face.scale * d[2]},
      {turn * face.normal[0], turn * face.normal[1], turn * face.normal[2]}};
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
