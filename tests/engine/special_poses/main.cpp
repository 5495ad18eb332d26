// Hunts for wrong answers about two shapes in special position: COUNT pairs drawn from SEED, each
// held against every promise. Prints the pairs that break one, then what was counted. The exit code
// is 1 if any did, 2 for bad arguments.

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>

#include "tests/engine/special_poses/pair_laws.h"
#include "tests/engine/special_poses/special_pairs.h"

namespace graze::tests {
namespace {

bool read(const char* text, std::uint64_t& value) {
  const char* end = text + std::strlen(text);
  return std::from_chars(text, end, value).ptr == end && end != text;
}

std::string kinds_of(const PlacedPair& pair) {
  return std::string(name_of(pair.a.kind())) + "/" + name_of(pair.b.kind());
}

int hunt(std::uint64_t count, std::uint64_t seed) {
  constexpr std::size_t kMostPrinted = 3;  // of each promise
  std::map<std::string, std::size_t> broken, open;
  PairLawCounts counts;
  RandomSource source(seed);
  for (std::uint64_t n = 0; n < count; ++n) {
    const PlacedPair pair = drawn_pair(source);
    const PairLawCounts before = counts;
    const std::string law = broken_law(pair, {}, counts);
    if (counts.unproved > before.unproved) ++open[kinds_of(pair) + " unproved"];
    if (counts.unconverged > before.unconverged) ++open[kinds_of(pair) + " open"];
    if (law.empty()) continue;
    if (++broken[law.substr(0, law.find(':'))] > kMostPrinted) continue;
    std::printf("pair %llu: %s\n%s\n\n", static_cast<unsigned long long>(n), law.c_str(),
                text_of(pair).c_str());
  }
  std::printf(
      "%zu pairs, %zu hits, %zu depths held against the least, %zu unproved, %zu distances "
      "open\nworst depth %.3g, worst distance %.3g of what is promised\n"
      "worst unproved depth %.3g of the smaller size\n",
      counts.pairs, counts.hits, counts.depths, counts.unproved, counts.unconverged,
      counts.worst_depth, counts.worst_distance, counts.worst_unproved);
  for (const auto& [kinds, times] : open)
    std::printf("%zu %s\n", times, kinds.c_str());
  for (const auto& [law, times] : broken)
    std::printf("BROKEN %zu times: %s\n", times, law.c_str());
  return broken.empty() ? 0 : 1;
}

}  // namespace
}  // namespace graze::tests

int main(int argc, char** argv) {
  std::uint64_t count = 0, seed = 0;
  if (argc != 3 || !graze::tests::read(argv[1], count) || !graze::tests::read(argv[2], seed)) {
    std::fputs("usage: graze_shape_hunt COUNT SEED\n", stderr);
    return 2;
  }
  return graze::tests::hunt(count, seed);
}
