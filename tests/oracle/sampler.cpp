#include <tests/oracle/sampler.h>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace graze::oracle {
namespace {

// Kept out of line and through memory: g++ 12 drops the rounding of a pair of conversions to float
// and back when it vectorises them.
[[gnu::noinline]] float narrowed(double value) {
  volatile float rounded = static_cast<float>(value);
  return rounded;
}

bool fits_float(double value) {
  return std::abs(value) <= std::numeric_limits<float>::max();
}

double neighbour(double x, double towards, Grid grid) {
  if (grid == Grid::Double || !fits_float(x)) {
    const double next = std::nextafter(x, towards);
    return std::isfinite(next) ? next : x;
  }
  const float next = std::nextafter(narrowed(x), towards > 0 ? HUGE_VALF : -HUGE_VALF);
  return std::isfinite(next) ? next : x;
}

}  // namespace

double on_grid(double value, Grid grid) {
  if (grid == Grid::Double || !fits_float(value)) return value;
  return narrowed(value);
}

Sampler::Sampler(std::string_view name, std::uint64_t index, Grid grid)
    : state_(index), grid_(grid) {
  std::uint64_t hash = grid == Grid::Float ? 1 : 0;
  for (const char letter : name) {  // FNV-1a's step, then SplitMix64's own mixing in bits()
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
  }
  state_ = hash;
  state_ = bits() ^ (index * 0xd1342543de82ef95ULL);
  state_ = bits();
}

std::uint64_t Sampler::bits() {
  state_ += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

int Sampler::integer(int low, int high) {
  const auto count = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
  return static_cast<int>(low + static_cast<std::int64_t>((bits() >> 11) % count));
}

bool Sampler::one_in(int n) {
  return integer(1, n) == 1;
}

double Sampler::sign() {
  return one_in(2) ? -1 : 1;
}

double Sampler::unit() {
  return std::ldexp(static_cast<double>(bits() >> 11), -53);
}

double Sampler::symmetric() {
  return std::ldexp(static_cast<double>(static_cast<std::int64_t>(bits()) >> 11), -52);
}

double Sampler::magnitude(int low, int high) {
  const int exponent = integer(low, high);
  return std::ldexp(1 + unit(), exponent);
}

double Sampler::nudged(double x, int max_steps) {
  const int steps = integer(-max_steps, max_steps);
  double result = on_grid(x, grid_);
  for (int i = 0; i < std::abs(steps); ++i) {
    result = neighbour(result, steps < 0 ? -HUGE_VAL : HUGE_VAL, grid_);
  }
  return result;
}

Eigen::Vector3d Sampler::point() {
  const double x = symmetric();
  const double y = symmetric();
  const double z = symmetric();
  return {x, y, z};
}

Eigen::Vector3d Sampler::whole_point(int reach) {
  const int x = integer(-reach, reach);
  const int y = integer(-reach, reach);
  const int z = integer(-reach, reach);
  return Eigen::Vector3d(x, y, z);
}

Eigen::Vector3d Sampler::nudged(const Eigen::Vector3d& p, int max_steps) {
  const double x = nudged(p.x(), max_steps);
  const double y = nudged(p.y(), max_steps);
  const double z = nudged(p.z(), max_steps);
  return {x, y, z};
}

Triangle Sampler::triangle() {
  const Eigen::Vector3d a = point();
  const Eigen::Vector3d b = point();
  const Eigen::Vector3d c = point();
  return {a, b, c};
}

Triangle Sampler::whole_triangle(int reach) {
  const Eigen::Vector3d a = whole_point(reach);
  const Eigen::Vector3d b = whole_point(reach);
  const Eigen::Vector3d c = whole_point(reach);
  return {a, b, c};
}

Triangle Sampler::nudged(const Triangle& t, int max_steps) {
  const Eigen::Vector3d a = nudged(t.a, max_steps);
  const Eigen::Vector3d b = nudged(t.b, max_steps);
  const Eigen::Vector3d c = nudged(t.c, max_steps);
  return {a, b, c};
}

Eigen::Vector3d Sampler::point_in(const Triangle& t) {
  const double weight_b = unit() / 2;
  const double weight_c = unit() / 2;
  return t.a + weight_b * (t.b - t.a) + weight_c * (t.c - t.a);
}

Triangle Sampler::shuffled(const Triangle& t) {
  Triangle result = t;
  if (one_in(2)) std::swap(result.a, result.b);
  const int turns = integer(0, 2);
  for (int i = 0; i < turns; ++i)
    result = {result.b, result.c, result.a};
  return result;
}

}  // namespace graze::oracle
