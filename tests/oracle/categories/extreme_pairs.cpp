#include <tests/oracle/base_elements.h>
#include <tests/oracle/category.h>
#include <cmath>
#include <limits>

// The ends of the range of double: products overflow, underflow and lose bits. The ends of the
// range of float need no category of their own: in double arithmetic they are ordinary numbers.

namespace graze::oracle {
namespace {

using Eigen::Vector3d;

constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

// A power of two changes no answer as long as nothing is rounded; below 1e-290 something is.
TrianglePair scaled_by(Sampler& s, int low, int high) {
  const TrianglePair pair = base_pair(s);
  return scaled(pair, std::ldexp(1.0, s.integer(low, high)));
}

TrianglePair large(Sampler& s) {
  return scaled_by(s, 200, 500);
}
TrianglePair small(Sampler& s) {
  return scaled_by(s, -530, -200);
}
TrianglePair tiny(Sampler& s) {
  return scaled_by(s, -1060, -900);
}

// Coordinates up to the largest double, and differences beyond it.
TrianglePair nearly_infinite(Sampler& s) {
  const double largest = std::numeric_limits<double>::max();
  const auto scale = [&](const Triangle& t) {
    return for_each_vertex(t, [&](const Vector3d& p) { return Vector3d(p * largest); });
  };
  const TrianglePair pair = s.one_in(2) ? TrianglePair{s.triangle(), s.triangle()}
                                        : TrianglePair{s.whole_triangle(1), s.whole_triangle(1)};
  return {scale(pair.a), scale(pair.b)};
}

// Lattices with their corners near the largest double: exact contacts there.
TrianglePair large_lattice(Sampler& s) {
  const TrianglePair pair{s.whole_triangle(3), s.whole_triangle(3)};
  return scaled(pair, std::ldexp(1.0, 1022));
}

double extreme_coordinate(Sampler& s) {
  const double sign = s.sign();
  return s.one_in(8) ? 0 : sign * s.magnitude(-530, 500);
}

// Magnitudes from 1e-160 to 1e150 within one triangle.
TrianglePair mixed(Sampler& s) {
  const auto vertex = [&] {
    return Vector3d{extreme_coordinate(s), extreme_coordinate(s), extreme_coordinate(s)};
  };
  const auto triangle = [&] { return Triangle{vertex(), vertex(), vertex()}; };
  return {triangle(), triangle()};
}

// The axes have units that differ by up to 1e300: every exact contact stays one.
TrianglePair stretched(Sampler& s) {
  const TrianglePair pair = base_pair(s);
  const auto factor = [&] { return std::ldexp(1.0, s.integer(-530, 490)); };
  const Vector3d factors{factor(), factor(), factor()};
  const auto stretch = [&](const Vector3d& p) { return Vector3d(p.cwiseProduct(factors)); };
  return {for_each_vertex(pair.a, stretch), for_each_vertex(pair.b, stretch)};
}

TrianglePair denormal_lattice(Sampler& s) {
  const int reach = s.one_in(2) ? 3 : 1000;
  const TrianglePair pair{s.whole_triangle(reach), s.whole_triangle(reach)};
  return scaled(pair, kDenormal);
}

TrianglePair denormal(Sampler& s) {
  return scaled_by(s, -1040, -1023);
}

// An ordinary pair with some coordinates moved off zero by denormals.
TrianglePair denormal_beside_normal(Sampler& s) {
  const TrianglePair pair{s.whole_triangle(1), s.whole_triangle(1)};
  const auto disturb = [&](const Vector3d& p) {
    Vector3d result = p;
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] == 0 && s.one_in(2)) result[axis] = s.integer(-2, 2) * kDenormal;
    }
    return result;
  };
  const Triangle a = for_each_vertex(pair.a, disturb);
  return {a, for_each_vertex(pair.b, disturb)};
}

// The two zeros are one number.
TrianglePair signed_zeros(Sampler& s) {
  const auto sign_zeros = [&](const Vector3d& p) {
    Vector3d result = p;
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] == 0 && s.one_in(2)) result[axis] = -0.0;
    }
    return result;
  };
  const Triangle a = for_each_vertex(s.whole_triangle(1), sign_zeros);
  return {a, for_each_vertex(s.whole_triangle(1), sign_zeros)};
}

}  // namespace

void add_extreme_pairs(std::vector<PairCategory>& categories) {
  categories.push_back({"extreme_large", large, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_small", small, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_tiny", tiny, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_nearly_infinite", nearly_infinite, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_large_lattice", large_lattice, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_mixed", mixed, Answers::Mixed, Range::Double});
  categories.push_back({"extreme_stretched", stretched, Answers::Mixed, Range::Double});
  categories.push_back({"denormal_lattice", denormal_lattice, Answers::Mixed, Range::Double});
  categories.push_back({"denormal", denormal, Answers::Mixed, Range::Double});
  categories.push_back(
      {"denormal_beside_normal", denormal_beside_normal, Answers::Mixed, Range::Double});
  categories.push_back({"signed_zeros", signed_zeros});
}

}  // namespace graze::oracle
