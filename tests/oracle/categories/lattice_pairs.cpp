#include <tests/oracle/category.h>

// Small integers, where every kind of contact happens by itself, and often.

namespace graze::oracle {
namespace {

TrianglePair within(Sampler& s, int reach) {
  const Triangle a = s.whole_triangle(reach);
  return {a, s.whole_triangle(reach)};
}

TrianglePair tiny(Sampler& s) {
  return within(s, 1);
}
TrianglePair small(Sampler& s) {
  return within(s, 3);
}
TrianglePair large(Sampler& s) {
  return within(s, 1 << 20);
}

// One vertex of A is the origin: cancellation in some differences and none in others.
TrianglePair at_origin(Sampler& s) {
  TrianglePair pair = within(s, 2);
  pair.a.a = Eigen::Vector3d::Zero();
  return pair;
}

// A lattice of thirds: the same kinds of contact, broken or not by rounding.
TrianglePair thirds(Sampler& s) {
  const TrianglePair pair = within(s, 3);
  const auto divide = [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p / 3); };
  return {for_each_vertex(pair.a, divide), for_each_vertex(pair.b, divide)};
}

}  // namespace

void add_lattice_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"lattice_tiny", tiny});
  categories.push_back({"lattice_small", small});
  categories.push_back({"lattice_large", large});
  categories.push_back({"lattice_at_origin", at_origin});
  categories.push_back({"lattice_of_thirds", thirds});
}

}  // namespace graze::oracle
