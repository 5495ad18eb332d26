#pragma once

#include <graze/bvh/aabb.h>

#include <cstdint>
#include <ostream>

namespace graze::test {

/// Where boxes of a random history lie.
enum class Habitat {
  Uniform,   // sizes about 1 in a world of 10
  Lattice,   // whole coordinates, some an ulp off: boxes that touch, coincide or just miss
  OnePoint,  // all the same box, or nearly
  Sizes,     // 1e-6 to 1e6, one in ten a floor
  Far,       // sizes about 1e-3 at 1e7 from the origin
  Extreme    // the largest and the smallest doubles, points, zeros of both signs
};

inline constexpr Habitat kHabitats[] = {Habitat::Uniform, Habitat::Lattice, Habitat::OnePoint,
                                        Habitat::Sizes,   Habitat::Far,     Habitat::Extreme};

inline void PrintTo(Habitat habitat, std::ostream* out) {
  const char* names[] = {"Uniform", "Lattice", "OnePoint", "Sizes", "Far", "Extreme"};
  *out << names[static_cast<int>(habitat)];
}

/// SplitMix64 (Steele, Lea and Flood 2014): the same numbers everywhere.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(bits() % limit); }
  bool one_in(std::uint32_t n) { return below(n) == 0; }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint64_t state_;
};

Aabb random_box(Habitat habitat, Chance& chance);

/// The box after a small step, the same size but for rounding.
Aabb stepped(const Aabb& box, Habitat habitat, Chance& chance);

/// True if the closed boxes share a point: by comparing doubles, the definition itself.
bool share_point(const Aabb& s, const Aabb& t);

}  // namespace graze::test
