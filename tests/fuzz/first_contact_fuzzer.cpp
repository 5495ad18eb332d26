#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/byte_shapes.h"
#include "tests/narrowphase/motion/rational_contact.h"

// Law 12 for a point and a triangle and for two edges, with rational arithmetic as oracle, at the
// exact stage alone, too. A crash prints the paths.

using namespace graze;

namespace {

void require(bool is_right, const std::string& paths, const std::optional<FirstContact>& answer,
             const std::optional<FirstContact>& truth) {
  if (is_right) return;
  std::fputs(
      (paths + "\n" + oracle::text_of(answer) + " for " + oracle::text_of(truth) + "\n").c_str(),
      stderr);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes shapes(data, size);
  const StartContact start = shapes.byte() % 2 != 0 ? StartContact::IsLeft : StartContact::Counts;
  const Triangle from = shapes.triangle(), to = shapes.triangle(), ends = shapes.triangle();
  const TrianglePath triangle{{from.a, to.a}, {from.b, to.b}, {from.c, to.c}};
  const PointPath point{ends.a, ends.b};
  const auto answer = first_contact(point, triangle, {.start = start});
  const auto truth = oracle::rational_first_contact(point, triangle, start);
  require(answer == truth, oracle::text_of(point) + ", " + oracle::text_of(triangle), answer,
          truth);
  const EdgePath edge_a{point, triangle.a}, edge_b{triangle.b, triangle.c};
  const auto edges = first_contact(edge_a, edge_b, {.start = start});
  const auto edges_truth = oracle::rational_first_contact(edge_a, edge_b, start);
  require(edges == edges_truth, oracle::text_of(edge_a) + ", " + oracle::text_of(edge_b), edges,
          edges_truth);
  return 0;
}
