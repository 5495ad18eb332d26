#include <tests/oracle/base_elements.h>
#include <tests/oracle/category.h>
#include <cmath>

// Far from the origin, and of very different sizes.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

Vector3d far_offset(Sampler& s) {
  const double distance = s.magnitude(20, 49);
  return distance * s.point();
}

// Unit size, 1e6 to 1e15 away: the coordinates that are left are a coarse lattice.
TrianglePair far_away(Sampler& s) {
  const Vector3d offset = far_offset(s);
  const TrianglePair pair{s.triangle(), s.triangle()};
  return {moved(pair.a, offset), moved(pair.b, offset)};
}

TrianglePair far_away_adversarial(Sampler& s) {
  const Vector3d offset = far_offset(s);
  return moved(base_pair(s), offset);
}

// In one axis only.
TrianglePair far_along_axis(Sampler& s) {
  const double distance = s.magnitude(20, 49);
  const Vector3d offset = turned(s, Vector3d(distance, 0, 0));
  return moved(base_pair(s), offset);
}

// Each vertex of each triangle 1e-6 to 1e6 from the origin.
TrianglePair mixed_within(Sampler& s) {
  const auto vertex = [&] {
    const double scale = s.magnitude(-20, 20);
    return Vector3d(scale * s.point());
  };
  const auto triangle = [&] { return Triangle{vertex(), vertex(), vertex()}; };
  return {triangle(), triangle()};
}

// Each coordinate of its own magnitude.
TrianglePair mixed_coordinates(Sampler& s) {
  const auto coordinate = [&] {
    const double sign = s.sign();
    return sign * s.magnitude(-20, 20);
  };
  const auto vertex = [&] { return Vector3d{coordinate(), coordinate(), coordinate()}; };
  const auto triangle = [&] { return Triangle{vertex(), vertex(), vertex()}; };
  return {triangle(), triangle()};
}

// B is up to 1e6 times smaller than A, and within its own size of A's surface.
TrianglePair mixed_between(Sampler& s) {
  const double size_a = s.magnitude(-3, 3);
  const Triangle a = scaled(s.triangle(), size_a);
  const double size = s.magnitude(-20, -4);
  const Triangle shape = scaled(s.triangle(), size);
  const Vector3d near = s.point_in(a);
  return {a, moved(shape, near + size * s.point() / 4)};
}

// The axes have different units: the contact stays what it is.
TrianglePair stretched(Sampler& s) {
  const TrianglePair pair = base_pair(s);
  const auto factor = [&] { return std::ldexp(1.0, s.integer(-20, 20)); };
  const Vector3d factors{factor(), factor(), factor()};
  const auto stretch = [&](const Vector3d& p) { return Vector3d(p.cwiseProduct(factors)); };
  return {for_each_vertex(pair.a, stretch), for_each_vertex(pair.b, stretch)};
}

}  // namespace

void add_scale_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"far_away", far_away});
  categories.push_back({"far_away_adversarial", far_away_adversarial});
  categories.push_back({"far_along_axis", far_along_axis});
  categories.push_back({"scales_mixed_within", mixed_within});
  categories.push_back({"scales_mixed_coordinates", mixed_coordinates});
  categories.push_back({"scales_mixed_between", mixed_between});
  categories.push_back({"scales_stretched", stretched});
}

}  // namespace graze::oracle
