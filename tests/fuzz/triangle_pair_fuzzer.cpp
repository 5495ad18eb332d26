#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <tests/fuzz/byte_shapes.h>
#include <tests/oracle/case_text.h>

#include <cstdio>
#include <cstdlib>

// Laws 2, 4 and 6 with the referee as oracle. A crash prints a case for data/regressions.

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes shapes(data, size);
  const Triangle a = shapes.triangle();
  const Triangle b = shapes.triangle();
  const bool truth = compare::referee_intersects(a, b);
  const auto wrong = truth ? narrowphase::Verdict::No : narrowphase::Verdict::Yes;
  const bool is_right =
      intersects(a, b) == truth && intersects({b.b, b.a, b.c}, {a.c, a.a, a.b}) == truth &&
      narrowphase::intersects_exactly(a, b) == truth && narrowphase::triage(a, b) != wrong;
  if (is_right) return 0;
  std::fputs(oracle::to_text(oracle::TrianglePair{a, b}, truth).c_str(), stderr);
  std::abort();
}
