#include <graze/engine/compare/referee.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>
#include <tests/fuzz/byte_shapes.h>
#include <tests/oracle/case_text.h>

#include <cstdio>
#include <cstdlib>

// Laws 3, 4 and 6 with the referee as oracle. A crash prints a case for data/regressions.

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes shapes(data, size);
  const Triangle t = shapes.triangle();
  const Aabb box = shapes.box();
  const bool truth = compare::referee_intersects(t, box);
  const auto wrong = truth ? narrowphase::Verdict::No : narrowphase::Verdict::Yes;
  const bool is_right = intersects(t, box) == truth && intersects({t.c, t.b, t.a}, box) == truth &&
                        narrowphase::intersects_exactly(t, box) == truth &&
                        narrowphase::triage(t, box) != wrong;
  if (is_right) return 0;
  std::fputs(oracle::to_text(oracle::TriangleAndBox{t, box}, truth).c_str(), stderr);
  std::abort();
}
