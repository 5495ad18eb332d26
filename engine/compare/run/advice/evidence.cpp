#include <graze/engine/compare/judge/rational/rational_triangle.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/compare/run/advice/evidence.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

double in_float(double value) {
  return static_cast<double>(static_cast<float>(value));
}

Eigen::Vector3d in_float(const Eigen::Vector3d& point) {
  return {in_float(point.x()), in_float(point.y()), in_float(point.z())};
}

Triangle in_float(const Triangle& t) {
  return {in_float(t.a), in_float(t.b), in_float(t.c)};
}

Pose in_float(const Pose& pose) {
  Pose rounded = pose;
  for (int i = 0; i < 12; ++i)
    rounded(i / 4, i % 4) = in_float(pose(i / 4, i % 4));
  return rounded;
}

double largest_of(const Triangle& t) {
  return std::max(
      {t.a.cwiseAbs().maxCoeff(), t.b.cwiseAbs().maxCoeff(), t.c.cwiseAbs().maxCoeff()});
}

/// Holds the two triangles that show an error best, and where they stand.
struct Culprits {
  Triangle a;
  Pose pose_a;
  Triangle b;
  Pose pose_b;

  std::array<Triangle, 2> placed(std::optional<Single> single) const {
    const bool is_posed = single == Single::Poses || single == Single::Vertices;
    const auto where = [&](const Pose& pose) { return is_posed ? in_float(pose) : pose; };
    const auto what = [&](const Triangle& t) {
      return single == Single::Vertices ? in_float(t) : t;
    };
    std::array<Triangle, 2> both = {place(where(pose_a), what(a)), place(where(pose_b), what(b))};
    if (single == Single::Placed) both = {in_float(both[0]), in_float(both[1])};
    return both;
  }
};

bool do_touch(const std::array<Triangle, 2>& placed) {
  return squared_distance(exactly(placed[0]), exactly(placed[1])) == 0;
}

bool is_finite(const std::array<Triangle, 2>& placed) {
  return std::isfinite(largest_of(placed[0])) && std::isfinite(largest_of(placed[1]));
}

/// Finds the rounding that changes whether the two touch, so that the engine, which says other than
/// what is true, is right.
std::optional<Single> single_of(const Culprits& culprits) {
  const bool is_hit = do_touch(culprits.placed(std::nullopt));
  for (const Single each : {Single::Poses, Single::Vertices, Single::Placed}) {
    const std::array<Triangle, 2> placed = culprits.placed(each);
    if (is_finite(placed) && do_touch(placed) != is_hit) return each;
  }
  return std::nullopt;
}

bool is_within_single(double error, double largest) {
  return error <=
         kSingleUlps * static_cast<double>(std::numeric_limits<float>::epsilon()) * largest;
}

double largest_of(const MeshCase& meshes) {
  double largest = 0;
  for (const CaseMesh* each : {&meshes.a, &meshes.b}) {
    for (const double value : largest_coordinates(each->pose, each->mesh.bounds()))
      largest = std::max(largest, value);
  }
  return largest;
}

std::size_t find_flat(const Mesh& mesh, std::vector<std::uint32_t>& first) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
    if (!has_no_area(exactly(mesh.triangle(i)))) continue;
    if (++count <= kFlatNamed) first.push_back(static_cast<std::uint32_t>(i));
  }
  return count;
}

}  // namespace

Evidence evidence_of(const Case& query, const AnswerRecord& answer) {
  Evidence evidence;
  const Judgement& judgement = answer.judgement;
  const std::optional<MeshCase> meshes = as_meshes(query);
  if (!meshes || judgement.error_class == ErrorClass::EngineError) return evidence;
  const Mesh& a = meshes->a.mesh;
  const Mesh& b = meshes->b.mesh;
  if (judgement.error_class == ErrorClass::Degenerate) {
    evidence.flat_count_a = find_flat(a, evidence.flat_a);
    evidence.flat_count_b = find_flat(b, evidence.flat_b);
  }
  // An error of rounding to double needs no float to explain it.
  if (judgement.ulps <= kTouchUlps || !is_within_single(judgement.error, largest_of(*meshes))) {
    return evidence;
  }
  if (query.ask == Ask::Distance) {
    evidence.single = Single::Arithmetic;
    return evidence;
  }
  const std::optional<TrianglePair>& pair = judgement.culprit;
  if (pair && pair->a < a.triangles().size() && pair->b < b.triangles().size()) {
    evidence.single =
        single_of({a.triangle(pair->a), meshes->a.pose, b.triangle(pair->b), meshes->b.pose});
  }
  return evidence;
}

}  // namespace graze::compare
