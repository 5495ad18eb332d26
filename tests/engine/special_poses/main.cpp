// Hunts for wrong answers about two shapes in special position: COUNT pairs drawn from SEED, every
// other time with half-spaces and meshes among them, and one in eight asked about at another scale,
// too; or the pairs of a file, each held against every promise. Prints the pairs that break one, as
// such files have them, then what was counted. The exit code is 1 if any did, 2 for bad arguments.

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "tests/engine/special_poses/pair_laws.h"
#include "tests/engine/special_poses/pair_text.h"
#include "tests/engine/special_poses/special_pairs.h"
#include "tests/shapes/shape_kinds.h"

namespace graze::tests {
namespace {

bool read(const char* text, std::uint64_t& value) {
  const char* end = text + std::strlen(text);
  return std::from_chars(text, end, value).ptr == end && end != text;
}

std::string kinds_of(const PlacedPair& pair) {
  return std::string(name_of(pair.a.kind())) + "/" + name_of(pair.b.kind());
}

/// Draws the next pair, or says that there is none.
using Draw = std::function<std::optional<PlacedPair>()>;

int hunt(const Draw& draw) {
  constexpr std::size_t kMostPrinted = 20;  // of each promise
  std::map<std::string, std::size_t> broken, open;
  PairLawCounts counts;
  while (const std::optional<PlacedPair> pair = draw()) {
    const PairLawCounts before = counts;
    std::string law = broken_law(*pair, {}, counts);
    // About 1e-93, 1e-8, 1e8 and 1e93.
    constexpr double kFactors[] = {0x1p-310, 0x1p-27, 0x1p27, 0x1p310};
    // A length of every shape must stay one that shapes may have.
    const bool has_usual_sizes = smaller_size(*pair) >= 1e-3 && scale_of(*pair) <= 1e3;
    if (law.empty() && counts.pairs % 8 == 0 && has_usual_sizes)
      law = broken_scaling(*pair, kFactors[counts.pairs / 8 % 4]);
    if (counts.unproved > before.unproved) ++open[kinds_of(*pair) + " unproved"];
    if (counts.unconverged > before.unconverged) ++open[kinds_of(*pair) + " open"];
    if (law.empty()) continue;
    if (++broken[law.substr(0, law.find(':'))] > kMostPrinted) continue;
    std::printf("# pair %zu: %s\n%s\n", before.pairs, law.c_str(), text_of(*pair).c_str());
    std::fflush(stdout);
  }
  std::printf(
      "%zu pairs, %zu with a mesh, %zu hits, %zu depths held against the least, %zu unproved, %zu "
      "distances "
      "open\nworst depth %.3g, worst distance %.3g, worst contact point %.3g, of two "
      "meshes %.3g, of what is promised\n"
      "worst unproved depth %.3g of the smaller size, worst open distance %.3g of the scale\n",
      counts.pairs, counts.surfaces, counts.hits, counts.depths, counts.unproved,
      counts.unconverged, counts.worst_depth, counts.worst_distance, counts.worst_point,
      counts.worst_mesh_point, counts.worst_unproved, counts.worst_open);
  for (const auto& [kinds, times] : open)
    std::printf("%zu %s\n", times, kinds.c_str());
  for (const auto& [law, times] : broken)
    std::printf("BROKEN %zu times: %s\n", times, law.c_str());
  return broken.empty() ? 0 : 1;
}

}  // namespace
}  // namespace graze::tests

int main(int argc, char** argv) {
  using graze::tests::kConvexKinds;
  using graze::tests::PlacedPair;
  std::uint64_t count = 0, seed = 0;
  if (argc == 3 && graze::tests::read(argv[1], count) && graze::tests::read(argv[2], seed)) {
    graze::RandomSource source(seed);
    return graze::tests::hunt([&]() -> std::optional<PlacedPair> {
      if (count-- == 0) return std::nullopt;
      const std::size_t kinds = count % 2 == 0 ? kConvexKinds : graze::tests::kOwnKinds.size();
      return graze::tests::drawn_pair(source, kinds);
    });
  }
  std::ifstream file;
  if (argc == 2) file.open(argv[1]);
  if (!file.is_open()) {
    std::fputs("usage: graze_shape_hunt COUNT SEED\n       graze_shape_hunt FILE\n", stderr);
    return 2;
  }
  return graze::tests::hunt([&] { return graze::tests::read_pair(file); });
}
