#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/triangle_box.h>
#include <tests/crosscheck/corpus_run.h>
#include <tests/oracle/case_text.h>

// Law 3 for oriented boxes: the referee gets the triangle after the rounding that the law
// prescribes, computed here once more, in the plainest way.

namespace graze::crosscheck {
namespace {

using Eigen::Vector3d;
using oracle::Sampler;
using oracle::TriangleAndBox;

struct TriangleAndObb {
  Triangle triangle;
  Obb box;
};

Vector3d into_frame(const Pose& pose, const Vector3d& v) {
  const double qx = v(0) - pose(0, 3);
  const double qy = v(1) - pose(1, 3);
  const double qz = v(2) - pose(2, 3);
  Vector3d result;
  for (int i = 0; i < 3; ++i) {
    const double x = pose(0, i) * qx;
    const double y = pose(1, i) * qy;
    const double z = pose(2, i) * qz;
    const double xy = x + y;
    result(i) = xy + z;
  }
  return result;
}

TriangleAndBox in_frame(const TriangleAndObb& pair) {
  const auto placed = [&](const Vector3d& v) { return into_frame(pair.box.pose, v); };
  return {oracle::for_each_vertex(pair.triangle, placed),
          {-pair.box.half_extents, pair.box.half_extents}};
}

// A rotation up to rounding, from a quaternion; or one of the turns of a cube, which rounds
// nothing.
Eigen::Matrix3d rotation(Sampler& s) {
  const bool is_cubic = s.one_in(3);
  const double w = is_cubic ? s.integer(-1, 1) : s.symmetric();
  const Vector3d v = is_cubic ? s.whole_point(1) : s.point();
  if (w == 0 && v.isZero(0)) return Eigen::Matrix3d::Identity();
  return Eigen::Quaterniond(w, v.x(), v.y(), v.z()).normalized().toRotationMatrix();
}

// The pair of an axis-aligned corpus, its box centred and then carried into a pose by rounding:
// what touched exactly now touches within ulps, or still exactly.
TriangleAndObb oriented(const TriangleAndBox& pair, Sampler& s) {
  TriangleAndObb result;
  result.box.half_extents = (pair.box.max - pair.box.min) / 2;
  const Vector3d centre = pair.box.min + result.box.half_extents;
  result.box.pose = Pose::Identity();
  result.box.pose.linear() = rotation(s);
  const double distance = s.one_in(2) ? 1 : s.magnitude(-10, 20);
  if (!s.one_in(4)) result.box.pose.translation() = distance * s.point();
  const auto carry = [&](const Vector3d& v) {
    return Vector3d(result.box.pose * Vector3d(v - centre));
  };
  result.triangle = oracle::for_each_vertex(pair.triangle, carry);
  return result;
}

std::string fault_of(const TriangleAndObb& pair) {
  const TriangleAndBox framed = in_frame(pair);
  const bool truth = compare::referee_intersects(framed.triangle, framed.box);
  if (intersects(pair.triangle, pair.box) == truth) return "";
  return "law 3: wrong for the oriented box; in its frame the truth is:\n" + to_text(framed, truth);
}

class Law3OrientedBoxes : public testing::TestWithParam<oracle::Corpus<TriangleAndBox>> {
 protected:
  void run(int count) {
    Sampler sampler("oriented_" + GetParam().name(), 0, oracle::Grid::Double);
    run_corpus(GetParam(), count,
               [&](const TriangleAndBox& pair) { return fault_of(oriented(pair, sampler)); });
  }
};
class Law3OrientedBoxesSlow : public Law3OrientedBoxes {};

TEST_P(Law3OrientedBoxes, AgreeWithReferee) {
  run(kElements);
}
TEST_P(Law3OrientedBoxesSlow, AgreeWithReferee) {
  run(kElementsSlow);
}

// Poses move metres, not the ends of the range: those corpora would only overflow here.
std::vector<oracle::Corpus<TriangleAndBox>> ordinary_corpora() {
  std::vector<oracle::Corpus<TriangleAndBox>> corpora;
  for (const auto& corpus : oracle::box_corpora()) {
    if (corpus.category.range == oracle::Range::Float) corpora.push_back(corpus);
  }
  return corpora;
}

INSTANTIATE_TEST_SUITE_P(Crosscheck, Law3OrientedBoxes, testing::ValuesIn(ordinary_corpora()),
                         CorpusName());
INSTANTIATE_TEST_SUITE_P(Crosscheck, Law3OrientedBoxesSlow, testing::ValuesIn(ordinary_corpora()),
                         CorpusName());

}  // namespace
}  // namespace graze::crosscheck
