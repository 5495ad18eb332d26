#include "tests/engine/broad_phase/box_histories.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Aabb box_about(const Eigen::Vector3d& centre, double half) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(half);
  return {centre - reach, centre + reach};
}

Eigen::Vector3d point(Chance& chance, double half) {
  Eigen::Vector3d p;
  for (int c = 0; c < 3; ++c)
    p[c] = chance.between(-half, half);
  return p;
}

double nudged(double value, Chance& chance) {
  const std::uint32_t what = chance.below(8);
  return what == 0   ? std::nextafter(value, kInfinity)
         : what == 1 ? std::nextafter(value, -kInfinity)
                     : value;
}

double extreme_number(Chance& chance) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  constexpr double kNumbers[] = {0.0,    -0.0,    kSmallest, -kSmallest, 1.0,  -1.0,
                                 1e-300, -1e-300, kLargest,  -kLargest,  1e300};
  return nudged(kNumbers[chance.below(11)] * 0.5, chance);
}

Aabb spanned(const Eigen::Vector3d& s, const Eigen::Vector3d& t) {
  return {s.cwiseMin(t), s.cwiseMax(t)};
}

}  // namespace

std::uint64_t Chance::bits() {
  std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 27) * 0x94d049bb133111ebu;
  return z ^ z >> 31;
}

Aabb random_box(Habitat habitat, Chance& chance) {
  Eigen::Vector3d s, t;
  switch (habitat) {
    case Habitat::Uniform: {
      s = point(chance, 5);
      return box_about(s, chance.between(0.1, 0.9));
    }
    case Habitat::Lattice: {
      for (int c = 0; c < 3; ++c) {
        const int low = static_cast<int>(chance.below(9)) - 4;
        const int side = static_cast<int>(chance.below(3));
        s[c] = nudged(low, chance);
        t[c] = std::max(s[c], nudged(low + side, chance));
      }
      return {s, t};
    }
    case Habitat::OnePoint: {
      for (int c = 0; c < 3; ++c) {
        s[c] = chance.one_in(20) ? nudged(-1, chance) : -1;
        t[c] = chance.one_in(20) ? nudged(1, chance) : 1;
      }
      return {s, t};
    }
    case Habitat::Sizes: {
      if (chance.one_in(10)) return {Eigen::Vector3d(-1e6, -1e6, -1), Eigen::Vector3d(1e6, 1e6, 0)};
      constexpr double kPowers[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1,
                                    10,   100,  1e3,  1e4,  1e5,  1e6};
      const double size = kPowers[chance.below(13)];
      s = point(chance, 3 * size);
      return box_about(s, size * chance.between(0.2, 1));
    }
    case Habitat::Far: {
      s = point(chance, 5e-3);
      return box_about(Eigen::Vector3d(1e7, -1e7, 1e7) + s, chance.between(1e-4, 1e-3));
    }
    case Habitat::Extreme: {
      for (int c = 0; c < 3; ++c) {
        s[c] = extreme_number(chance);
        t[c] = chance.one_in(4) ? s[c] : extreme_number(chance);
      }
      return spanned(s, t);
    }
  }
  return {};
}

Aabb stepped(const Aabb& box, Habitat habitat, Chance& chance) {
  if (habitat == Habitat::Extreme || habitat == Habitat::OnePoint)
    return random_box(habitat, chance);
  Eigen::Vector3d step = point(chance, habitat == Habitat::Far ? 1e-4 : 0.1);
  if (habitat == Habitat::Lattice)
    step = step.unaryExpr([](double x) { return x > 0.05 ? 1.0 : x < -0.05 ? -1.0 : 0.0; });
  const Eigen::Vector3d s = box.min + step, t = box.max + step;
  return spanned(s, t);
}

bool share_point(const Aabb& s, const Aabb& t) {
  for (int c = 0; c < 3; ++c) {
    if (s.min[c] > t.max[c] || t.min[c] > s.max[c]) return false;
  }
  return true;
}

}  // namespace graze::test
