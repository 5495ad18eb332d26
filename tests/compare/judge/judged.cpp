#include "tests/compare/judge/judged.h"

#include <graze/engine/cases/to_case.h>

#include "tests/shapes/formula_meshes.h"

namespace graze::compare {

Triangle moved(const Triangle& t, const Eigen::Vector3d& by) {
  return {t.a + by, t.b + by, t.c + by};
}

CaseMesh cube_at(double x, double y) {
  Pose pose = Pose::Identity();
  pose.translation() = Eigen::Vector3d(x, y, 0);
  return {tests::make_box({1, 1, 1}), pose};
}

Judgement judged(const CaseShape& a, const CaseShape& b, bool says) {
  const Case query = to_case(a, b, says);
  return Judge(query).judge(*query.answer, {"somebody", ""});
}

}  // namespace graze::compare
