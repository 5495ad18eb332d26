#include <graze/narrowphase/translation/axes.h>
#include <graze/narrowphase/translation/ball_features.h>
#include <graze/narrowphase/translation/unit_vector.h>

namespace graze::narrowphase {
namespace {

/// Adds g^2 to f.
void add_square(Polynomial& f, const LinearPath& g) {
  const Polynomial square = product(g, g);
  for (int i = 0; i < 3; ++i)
    f.coefficient[i] = f.coefficient[i] + square.coefficient[i];
}

/// Returns the square of v - t w.
Polynomial square_of(const BigVector& v, const BigVector& w) {
  Polynomial square;
  add_square(square, {v.x, -w.x});
  add_square(square, {v.y, -w.y});
  add_square(square, {v.z, -w.z});
  return square;
}

}  // namespace

BallFeatures::BallFeatures(const Corners<double>& triangle, const MovingBall& ball)
    : unit_({ball.radius}) {
  unit_.include(ball.centre, 3);
  unit_.include(ball.displacement, 3);
  for (const double* point : triangle.point)
    unit_.include(point, 3);
  for (int i = 0; i < 3; ++i) {
    corner_[i] = BigVector::difference(triangle.point[i], ball.centre, unit_);
    edge_[i] = BigVector::difference(triangle.point[(i + 1) % 3], triangle.point[i], unit_);
  }
  normal_ = cross(edge_[0], edge_[1]);
  d_ = BigVector::difference(ball.displacement, kZeroPoint, unit_);
  radius2_ = squared(unit_.of(ball.radius));
}

bool BallFeatures::has(const BallFeature& feature) const {
  switch (feature.kind) {
    case BallFeature::Kind::Edge:
      return !is_zero(edge_[feature.place]);
    case BallFeature::Kind::Face:
      return !is_zero(normal_);
    case BallFeature::Kind::Vertex:
      break;
  }
  return true;
}

Polynomial BallFeatures::gap(const BallFeature& feature) const {
  const BigVector& corner = corner_[feature.place];
  const BigVector& edge = edge_[feature.place];
  Polynomial gap;
  switch (feature.kind) {
    case BallFeature::Kind::Vertex:
      gap = square_of(corner, d_);
      gap.coefficient[0] = gap.coefficient[0] - radius2_;
      break;
    case BallFeature::Kind::Edge:
      gap = square_of(cross(corner, edge), cross(d_, edge));
      gap.coefficient[0] = gap.coefficient[0] - radius2_ * squared(edge);
      break;
    case BallFeature::Kind::Face:
      add_square(gap, {dot(corner, normal_), -dot(d_, normal_)});
      gap.coefficient[0] = gap.coefficient[0] - radius2_ * squared(normal_);
      break;
  }
  gap.take(3);
  return gap;
}

// With v = w - t d from the centre to a corner w of the start, a foot is before the end of an edge
// if v . e is not negative there, and within the face if no (v_i x v_j) . n is negative: that is
// (w_i x w_j - t d x e_i) . n.
LinearPath BallFeatures::within(const BallFeature& feature, int side) const {
  if (feature.kind == BallFeature::Kind::Face) {
    const BigVector across = cross(corner_[side], corner_[(side + 1) % 3]);
    return {dot(across, normal_), -dot(cross(d_, edge_[side]), normal_)};
  }
  const BigVector& edge = edge_[feature.place];
  const BigInteger along = dot(d_, edge);
  if (side == 0) return {-dot(corner_[feature.place], edge), along};
  return {dot(corner_[(feature.place + 1) % 3], edge), -along};
}

}  // namespace graze::narrowphase
