// decide_distance() of two triangles with surely nearest vertices p and q has these features and
// points, for no other features hold a pair of nearest points. Its distance is the root of |q -
// p|^2, rounded in twice the precision of double or, if nearest_guess.cpp erred, from integers. The
// first is off by half an ulp and 2^-95 of itself at most, the second by half an ulp. So both are
// the double d if the root is nearer to d than to the middle between d and its neighbours by a
// millionth of that. In units of |q - p|^2 the middles' squares are more than 2^-54 away from d^2,
// and |q - p|^2 - d^2 is computed with an error of less than 2^-98: a millionth covers it.

#include <graze/narrowphase/derived/double_pair.h>
#include <graze/narrowphase/derived/nearest_vertices.h>
#include <graze/narrowphase/derived/sign_of_products.h>
#include <cmath>

namespace graze::narrowphase {
namespace {

// Between these no square overflows or has an error term that underflows visibly.
constexpr double kShortestRoot = 0x1p-90;
constexpr double kLongestRoot = 0x1p+90;

constexpr double kShareOfHalfAnUlp = 1 - 0x1p-20;

/// True if the distance of p and q is nearer to `root` than to what is halfway to its neighbours.
bool is_surely_rounded_to(double root, const double* p, const double* q) {
  if (!(root >= kShortestRoot && root <= kLongestRoot)) return false;
  const PairVector offset = PairVector::difference(q, p);
  const DoublePair square = dot(offset, offset);
  const RoundedPair again = two_product(root, root);
  const double excess = ((square.high - again.value) - again.error) + square.low;
  const double half_an_ulp = 0.5 * (root - std::nextafter(root, 0.0));
  return std::abs(excess) < kShareOfHalfAnUlp * (2 * root * half_an_ulp);
}

/// Returns the number of the corner of a triangle that is this point, or 3.
int corner_at(const double* const (&corners)[3], const double* point) {
  int i = 0;
  while (i < 3 &&
         !(corners[i][0] == point[0] && corners[i][1] == point[1] && corners[i][2] == point[2])) {
    ++i;
  }
  return i;
}

}  // namespace

void NearestVertices::set(const TriangleDistance& found) {
  found_ = found;
  is_known_ = found.feature_a == Feature::Vertex && found.feature_b == Feature::Vertex &&
              is_surely_rounded_to(found.distance, found.point_a.data(), found.point_b.data());
}

const TriangleDistance* NearestVertices::of(const Triangle& triangle_a,
                                            const Triangle& triangle_b) const {
  if (!is_known_) return nullptr;
  const double* const a[3] = {triangle_a.a.data(), triangle_a.b.data(), triangle_a.c.data()};
  const double* const b[3] = {triangle_b.a.data(), triangle_b.b.data(), triangle_b.c.data()};
  const double* p = found_.point_a.data();
  const double* q = found_.point_b.data();
  const int i = corner_at(a, p);
  const int j = corner_at(b, q);
  if (i == 3 || j == 3) return nullptr;
  const auto is_beyond = [&](Step step) { return dot_filter(step, {p, q}) == Sign::Positive; };
  for (int k = 1; k < 3; ++k) {
    if (!is_beyond({a[(i + k) % 3], p}) || !is_beyond({q, b[(j + k) % 3]})) return nullptr;
  }
  return &found_;
}

}  // namespace graze::narrowphase
