#include "data/generator/hash.h"

namespace graze::generator {
namespace {

// The finaliser of SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators,
// OOPSLA 2014), in the variant of Stafford's Mix13: a bijection in which each bit of the argument
// flips each bit of the result with a probability near one half.
std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111eb;
  return bits ^ bits >> 31;
}

// The odd number next to 2^64 divided by the golden ratio keeps a list of zeros from staying zero.
constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;

}  // namespace

std::uint64_t hash(std::initializer_list<std::int64_t> numbers) {
  std::uint64_t bits = 0;
  for (std::int64_t number : numbers) {
    bits = mixed(bits + kStep + static_cast<std::uint64_t>(number));
  }
  return bits;
}

double unit_interval(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace graze::generator
