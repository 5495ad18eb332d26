#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/predicates/exact_vector.h>
#include <graze/narrowphase/translation/axes.h>
#include <graze/narrowphase/translation/meeting_time.h>
#include <graze/narrowphase/translation/unit_vector.h>

namespace graze::narrowphase {
namespace {

/// Holds a pair in integers. Coordinates times a determinant are of degree four (BigInteger).
class ExactPair {
 public:
  explicit ExactPair(const TranslatedPair& pair) : unit_({}) {
    for (int i = 0; i < 3; ++i) {
      unit_.include(pair.a.point[i], 3);
      unit_.include(pair.b.point[i], 3);
    }
    unit_.include(pair.displacement, 3);
    d_ = BigVector::difference(pair.displacement, kZeroPoint, unit_);
  }

  const BigVector& d() const { return d_; }
  BigVector minus(const double* p, const double* q) const {
    return BigVector::difference(p, q, unit_);
  }
  BigVector edge(const Corners<double>& triangle, int from) const {
    return minus(triangle.point[(from + 1) % 3], triangle.point[from]);
  }
  BigVector normal(const Corners<double>& t) const {
    return cross(minus(t.point[1], t.point[0]), minus(t.point[2], t.point[0]));
  }

  /// Returns point + numerator / divisor along, the divisor not zero.
  Eigen::Vector3d moved(const double* point, BigInteger numerator, BigInteger divisor,
                        const BigVector& along) const {
    if (divisor.sign() == Sign::Negative) {
      numerator = -numerator;
      divisor = -divisor;
    }
    const BigInteger* component[3] = {&along.x, &along.y, &along.z};
    Eigen::Vector3d moved;
    for (int k = 0; k < 3; ++k)
      moved.data()[k] = rounded_ratio(unit_.of(point[k]) * divisor + *component[k] * numerator,
                                      divisor, unit_.exponent());
    return moved;
  }

 private:
  CommonUnit unit_;
  BigVector d_;
};

}  // namespace

Eigen::Vector3d point_of(const TranslatedPair& pair, const Meeting& meeting) {
  const double* corner_a = pair.a.point[meeting.a];
  const double* corner_b = pair.b.point[meeting.b];
  switch (meeting.kind) {
    case Meeting::Kind::VertexFace:
    case Meeting::Kind::VertexOnEdge:
    case Meeting::Kind::VertexVertex:
      break;
    case Meeting::Kind::EdgeEdge: {
      // The point is on both edges, one of which moves along d: a + s e = b + u f + t d, so that s
      // = (b - a) . (f x d) / e . (f x d).
      const ExactPair exact(pair);
      const BigVector along = exact.edge(pair.a, meeting.a);
      const BigVector across = cross(exact.edge(pair.b, meeting.b), exact.d());
      return exact.moved(corner_a, dot(exact.minus(corner_b, corner_a), across), dot(along, across),
                         along);
    }
    case Meeting::Kind::FaceVertex:
    case Meeting::Kind::EdgeWithVertex: {
      const ExactPair exact(pair);
      const TimeQuotient time(pair, meeting);
      const auto exactly = [&](Step step) { return exact.minus(step.to, step.from); };
      if (meeting.kind == Meeting::Kind::FaceVertex) {
        const BigVector across = cross(exactly(time.p), exactly(time.q));
        return exact.moved(corner_b, dot(across, exactly(time.w)), dot(across, exactly(time.d)),
                           exact.d());
      }
      // (e x axis) . w is (w x e) along the axis: no unit vector is needed.
      const auto component = [&](const BigVector& v) {
        const BigVector all = cross(v, exactly(time.p));
        return meeting.axis == 0 ? all.x : (meeting.axis == 1 ? all.y : all.z);
      };
      return exact.moved(corner_b, component(exactly(time.w)), component(exactly(time.d)),
                         exact.d());
    }
  }
  return {corner_a[0], corner_a[1], corner_a[2]};
}

Eigen::Vector3d normal_of(const TranslatedPair& pair, const Meeting& meeting) {
  const ExactPair exact(pair);
  const auto across_edge = [&](const BigVector& edge) {
    return unit_against(cross(edge, cross(edge, exact.d())), exact.d());
  };
  switch (meeting.kind) {
    case Meeting::Kind::VertexFace:
      return unit_against(exact.normal(pair.b), exact.d());
    case Meeting::Kind::FaceVertex:
      return unit_against(exact.normal(pair.a), exact.d());
    case Meeting::Kind::EdgeEdge:
      return unit_against(cross(exact.edge(pair.a, meeting.a), exact.edge(pair.b, meeting.b)),
                          exact.d());
    case Meeting::Kind::VertexOnEdge:
      return across_edge(exact.edge(pair.b, meeting.b));
    case Meeting::Kind::EdgeWithVertex:
      return across_edge(exact.edge(pair.a, meeting.a));
    case Meeting::Kind::VertexVertex:
      break;
  }
  return unit_against(exact.d(), exact.d());
}

Eigen::Vector3d normal_at_start(const TranslatedPair& pair) {
  const ExactPair exact(pair);
  for (const Corners<double>* t : {&pair.a, &pair.b}) {
    const BigVector normal = exact.normal(*t);
    if (!is_zero(normal)) return unit_against(normal, exact.d());
  }
  return unit_against(exact.d(), exact.d());
}

}  // namespace graze::narrowphase
