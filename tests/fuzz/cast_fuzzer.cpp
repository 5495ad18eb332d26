#include <graze/narrowphase/cast.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/byte_shapes.h"
#include "tests/narrowphase/translation/rational_ball.h"
#include "tests/narrowphase/translation/rational_cast.h"

// Law 13 for two triangles, with duality in integers as oracle, and for a triangle and a ball, with
// a walk through time. A crash prints both and the way.

using namespace graze;

namespace {

void compare(const std::optional<FirstContact>& answer, const std::optional<FirstContact>& truth,
             const char* what, const std::string& text) {
  if (answer == truth) return;
  std::fprintf(stderr, "%s %s: %a for %a\n", what, text.c_str(), answer ? answer->time : -1,
               truth ? truth->time : -1);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes shapes(data, size);
  const StartContact start = shapes.byte() % 2 != 0 ? StartContact::IsLeft : StartContact::Counts;
  const Triangle a = shapes.triangle(), b = shapes.triangle();
  const Eigen::Vector3d displacement = shapes.triangle().a;
  const std::string text =
      oracle::text_of(a) + ", " + oracle::text_of(b) + ", " + oracle::text_of(displacement);
  compare(cast(a, b, displacement, {.start = start}),
          oracle::rational_cast(a, b, displacement, start).contact, "triangles", text);
  const Sphere ball{b.a, std::abs(b.b.x())};
  compare(cast(a, ball, displacement, {.start = start}),
          oracle::rational_cast(a, ball, displacement, start).contact, "ball at the first corner",
          text);
  return 0;
}
