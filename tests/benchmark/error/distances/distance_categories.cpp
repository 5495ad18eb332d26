#include "tests/benchmark/error/distances/distance_categories.h"

#include <tests/oracle/category.h>
#include <tests/oracle/sampler.h>

#include <cmath>
#include <iterator>

#include "tests/benchmark/error/distances/rounded_distance.h"

namespace graze::benchmark {
namespace {

using Eigen::Vector3d;
using oracle::Sampler;

Vector3d unit_normal(const Triangle& t) {
  return (t.b - t.a).cross(t.c - t.a).normalized();
}

TrianglePair random_apart(Sampler& s) {
  const Triangle a = s.triangle();
  const Triangle b = s.triangle();
  return {a, oracle::moved(b, 3 * s.point())};
}

/// A copy above the face, shifted along it: the nearest points are not unique.
TrianglePair parallel_faces(Sampler& s) {
  const Triangle a = s.triangle();
  const Vector3d along = 0.3 * (a.b - a.a);
  const double height = s.magnitude(-20, 0);
  return {a, oracle::moved(a, along + height * unit_normal(a))};
}

TrianglePair nearly_parallel_faces(Sampler& s) {
  TrianglePair pair = parallel_faces(s);
  pair.b.a += s.magnitude(-50, -10) * s.point();
  return pair;
}

/// Two edges side by side, to within a small angle.
TrianglePair nearly_parallel_edges(Sampler& s) {
  const Triangle a = s.triangle();
  const Vector3d out = (a.a + a.b - 2 * a.c).normalized();
  const Vector3d away = s.magnitude(-20, 0) * out;
  Triangle b = s.triangle();
  b.a = a.a + away;
  b.b = a.b + away + s.magnitude(-50, -10) * s.point();
  b.c = a.c + 3 * (a.a - a.c) + s.unit() * (a.b - a.a);
  return {a, b};
}

/// A vertex above a face, or above the middle of an edge.
TrianglePair close(Sampler& s) {
  const Triangle a = s.triangle();
  const Vector3d foot = s.one_in(3) ? Vector3d(0.5 * a.a + 0.5 * a.b) : s.point_in(a);
  const Vector3d normal = unit_normal(a);
  const Vector3d vertex = foot + s.magnitude(-50, -4) * normal;
  const Vector3d p = vertex + normal + s.point() / 2;
  return {a, {vertex, p, vertex + normal + s.point() / 2}};
}

Triangle needle(Sampler& s) {
  const Triangle t = s.triangle();
  return {t.a, t.b, t.b + s.magnitude(-45, -20) * (t.c - t.b)};
}

TrianglePair needles_apart(Sampler& s) {
  const Triangle a = needle(s);
  const Triangle b = s.one_in(2) ? needle(s) : s.triangle();
  return {a, oracle::moved(b, s.point())};
}

TrianglePair far_from_origin(Sampler& s) {
  const TrianglePair pair = random_apart(s);
  return oracle::moved(pair, 1e6 * s.point());
}

TrianglePair unequal_sizes(Sampler& s) {
  const Triangle a = s.triangle();
  const Triangle b = oracle::scaled(s.triangle(), s.magnitude(-30, -10));
  return {a, oracle::moved(b, s.point())};
}

constexpr oracle::PairCategory kApart[] = {{"random_apart", random_apart},
                                           {"parallel_faces", parallel_faces},
                                           {"nearly_parallel_faces", nearly_parallel_faces},
                                           {"nearly_parallel_edges", nearly_parallel_edges},
                                           {"close", close},
                                           {"needles_apart", needles_apart},
                                           {"far_from_origin_apart", far_from_origin},
                                           {"unequal_sizes", unequal_sizes}};

/// Without the variants in float: the errors would be the same.
std::vector<oracle::Corpus<TrianglePair>> corpora() {
  std::vector<oracle::Corpus<TrianglePair>> all;
  for (const oracle::PairCategory& category : kApart)
    all.push_back({category, oracle::Grid::Double});
  for (const oracle::Corpus<TrianglePair>& corpus : oracle::pair_corpora()) {
    if (corpus.grid == oracle::Grid::Double) all.push_back(corpus);
  }
  return all;
}

}  // namespace

std::size_t distance_category_count() {
  return corpora().size();
}

DistanceCategory distance_category(std::size_t index, const Sizes& sizes) {
  const oracle::Corpus<TrianglePair> corpus = corpora()[index];
  DistanceCategory category{corpus.name(), corpus.name().starts_with("random"), {}, {}, {}};
  for (std::size_t i = 0; i < sizes.distances; ++i) {
    const TrianglePair pair = corpus.element(i);
    category.elements.push_back(pair);
    category.truth.push_back(rounded_distance(pair.a, pair.b));
    category.ulp.push_back(
        ulp_of(std::max(largest_coordinate(pair.a), largest_coordinate(pair.b))));
  }
  return category;
}

}  // namespace graze::benchmark
