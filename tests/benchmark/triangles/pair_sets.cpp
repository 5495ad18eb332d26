#include <graze/narrowphase/triangle_triangle.h>

#include <tests/benchmark/triangles/pair_sets.h>
#include <tests/oracle/category.h>
#include <stdexcept>

namespace graze::benchmark {
namespace {

using oracle::Sampler;
using oracle::TrianglePair;

/// Random triangles; the second one is moved away by `distance` in a random direction, which sets
/// the share of hits. `group` pairs in a row have the first triangle in common.
struct Generic {
  const char* name;
  double distance;
  std::size_t group;
};

constexpr Generic kGeneric[] = {{"generic 5 %", 1.05, 1},
                                {"generic 50 %", 0.49, 1},
                                {"generic 5 %, one against many", 1.05, kGroup},
                                {"generic 50 %, one against many", 0.49, kGroup}};

Triangle around_origin(Sampler& s) {
  const Triangle t = s.triangle();
  return oracle::moved(t, -(t.a + t.b + t.c) / 3);
}

Eigen::Vector3d direction(Sampler& s) {
  const Eigen::Vector3d p = s.point();
  return p / p.norm();
}

std::vector<TrianglePair> generic_pairs(const Generic& generic, std::size_t count) {
  std::vector<TrianglePair> pairs;
  Triangle first;
  for (std::size_t n = 0; n < count; ++n) {
    Sampler s(generic.name, n, oracle::Grid::Double);
    const Triangle fresh = around_origin(s);
    if (n % generic.group == 0) first = fresh;
    const Triangle second = around_origin(s);
    pairs.push_back({first, oracle::moved(second, generic.distance * direction(s))});
  }
  return pairs;
}

}  // namespace

std::vector<std::string> pair_set_names() {
  std::vector<std::string> names;
  for (const Generic& generic : kGeneric)
    names.push_back(generic.name);
  for (const auto& corpus : oracle::pair_corpora())
    names.push_back(corpus.name());
  return names;
}

Set<TrianglePair> pair_set(const std::string& name, std::size_t count) {
  for (const Generic& generic : kGeneric) {
    if (name == generic.name) return {name, generic_pairs(generic, count)};
  }
  for (const auto& corpus : oracle::pair_corpora()) {
    if (name != corpus.name()) continue;
    Set<TrianglePair> set{name, {}};
    for (std::size_t n = 0; n < count; ++n)
      set.elements.push_back(corpus.element(n));
    return set;
  }
  throw std::invalid_argument("no set of pairs is named " + name);
}

}  // namespace graze::benchmark
