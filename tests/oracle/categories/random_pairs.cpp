#include <tests/oracle/category.h>

// Pairs in general position, where everything should be easy.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

TrianglePair anywhere(Sampler& s) {
  return {s.triangle(), s.triangle()};
}

// B around a point of A.
TrianglePair close(Sampler& s) {
  const Triangle a = s.triangle();
  const Vector3d centre = s.point_in(a);
  return {a, moved(scaled(s.triangle(), 0.5), centre)};
}

// Much smaller than its partner, and anywhere near it.
TrianglePair small_and_large(Sampler& s) {
  const Triangle a = s.triangle();
  const double size = s.magnitude(-12, -3);
  const Vector3d near = s.point_in(a);
  const Triangle b = scaled(s.triangle(), size);
  return {a, moved(b, near + size / 2 * s.point())};
}

}  // namespace

void add_random_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"random", anywhere});
  categories.push_back({"random_close", close});
  categories.push_back({"random_small_and_large", small_and_large});
}

}  // namespace graze::oracle
