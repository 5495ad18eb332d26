#include <graze/bvh/error.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/meshes/mesh_judges.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/mesh/placement.h>

#include <cmath>

namespace graze::compare {
namespace {

using Eigen::Vector3d;

/// The direction is a unit vector to a few ulp, and each product with the length is rounded.
constexpr double kLengthTolerance = 0x1p-49;

/// The translation may be longer than it must be by this share of its length.
constexpr double kLongerTolerance = 0x1p-20;

Judgement wrong(const char* what, double error) {
  Judgement judgement;
  judgement.verdict = Verdict::Wrong;
  judgement.truth = what;
  judgement.error = error;
  return judgement;
}

/// Returns nothing if the placement would overflow.
std::optional<Pose> moved(const CaseMesh& mesh, const Vector3d& by) {
  Pose pose = mesh.pose;
  pose.translation() += by;
  try {
    check_placement(pose, mesh.mesh.bounds(), "the pose of B");
  } catch (const Error&) {
    return std::nullopt;
  }
  return pose;
}

Judgement judge_apart(const MeshCase& meshes, const Pose& pose_b) {
  const Case after = {.note = "",
                      .ask = Ask::Any,
                      .settings = {},
                      .a = meshes.a,
                      .b = CaseMesh(meshes.b.mesh, pose_b),
                      .answer = std::nullopt,
                      .answered_by = {}};
  CaseAnswer apart;
  apart.says = false;
  return Judge(after).judge(apart, {"referee", ""});
}

}  // namespace

Judgement judge_separation(const Case& query, const MeshCase& meshes, const CaseAnswer& answer) {
  const Vector3d& translation = *answer.translation;
  const double length = translation.stableNorm();
  const double off = std::abs(length - *answer.distance);
  if (!(off <= kLengthTolerance * length)) return wrong("a translation of another length", off);
  if (query.settings.direction && length > 0) {
    const Vector3d direction = query.settings.direction->stableNormalized();
    const double aside = (translation.stableNormalized() - direction).norm();
    if (aside > kLengthTolerance) return wrong("another direction", aside * length);
  }
  const std::optional<Pose> after = moved(meshes.b, translation);
  if (!after) {
    Judgement judgement;
    judgement.truth = "it takes B out of the range of double";
    return judgement;
  }
  Judgement judgement = judge_apart(meshes, *after);
  if (judgement.verdict != Verdict::Right) {
    judgement.truth = "still a hit after it";
    return judgement;
  }
  judgement.truth = "apart after it";
  const std::optional<Pose> before = moved(meshes.b, (1 - kLongerTolerance) * translation);
  const bool is_needed =
      length == 0 ||
      (before && MeshReferee({meshes.a.mesh, meshes.a.pose}, {meshes.b.mesh, *before}).find_hit());
  if (is_needed) return judgement;
  judgement.verdict = Verdict::NotJudged;
  judgement.truth += "; not judged: its length";
  return judgement;
}

}  // namespace graze::compare
