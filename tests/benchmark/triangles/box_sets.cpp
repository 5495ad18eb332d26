#include <tests/benchmark/triangles/box_sets.h>
#include <tests/benchmark/triangles/pair_sets.h>
#include <tests/oracle/category.h>
#include <stdexcept>

namespace graze::benchmark {
namespace {

using oracle::Sampler;
using oracle::TriangleAndBox;

/// A random triangle about the origin and a random box moved away by `distance`.
struct Generic {
  const char* name;
  double distance;
  std::size_t triangles;  // in a row that are one
  std::size_t boxes;
};

constexpr Generic kGeneric[] = {{"generic 5 %", 1.065, 1, 1},
                                {"generic 50 %", 0.545, 1, 1},
                                {"generic 5 %, one triangle", 1.065, kGroup, 1},
                                {"generic 50 %, one triangle", 0.545, kGroup, 1},
                                {"generic 5 %, one box", 1.065, 1, kGroup},
                                {"generic 50 %, one box", 0.545, 1, kGroup}};

std::vector<TriangleAndBox> generic_elements(const Generic& generic, std::size_t count) {
  std::vector<TriangleAndBox> elements;
  TriangleAndBox shared{};
  for (std::size_t n = 0; n < count; ++n) {
    Sampler s(generic.name, n, oracle::Grid::Double);
    Triangle triangle = s.triangle();
    triangle = oracle::moved(triangle, -(triangle.a + triangle.b + triangle.c) / 3);
    const Eigen::Vector3d way = s.point();
    const Eigen::Vector3d centre = way * (generic.distance / way.norm());
    const Eigen::Vector3d half = 0.5 * s.point();
    if (n % generic.triangles == 0) shared.triangle = triangle;
    if (n % generic.boxes == 0) shared.box = oracle::box_between(centre - half, centre + half);
    elements.push_back(shared);
  }
  return elements;
}

}  // namespace

std::vector<std::string> box_set_names() {
  std::vector<std::string> names;
  for (const Generic& generic : kGeneric)
    names.push_back(generic.name);
  for (const auto& corpus : oracle::box_corpora())
    names.push_back(corpus.name());
  return names;
}

Set<TriangleAndBox> box_set(const std::string& name, std::size_t count) {
  for (const Generic& generic : kGeneric) {
    if (name == generic.name) return {name, generic_elements(generic, count)};
  }
  for (const auto& corpus : oracle::box_corpora()) {
    if (name != corpus.name()) continue;
    Set<TriangleAndBox> set{name, {}};
    for (std::size_t n = 0; n < count; ++n)
      set.elements.push_back(corpus.element(n));
    return set;
  }
  throw std::invalid_argument("no set of triangles and boxes is named " + name);
}

}  // namespace graze::benchmark
