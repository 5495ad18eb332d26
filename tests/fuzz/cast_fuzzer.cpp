#include <graze/narrowphase/cast.h>

#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/byte_shapes.h"
#include "tests/narrowphase/translation/rational_cast.h"

// Law 13 for two triangles, with duality in integers as oracle. A crash prints both and the way.

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes shapes(data, size);
  const StartContact start = shapes.byte() % 2 != 0 ? StartContact::IsLeft : StartContact::Counts;
  const Triangle a = shapes.triangle(), b = shapes.triangle();
  const Eigen::Vector3d displacement = shapes.triangle().a;
  const auto answer = cast(a, b, displacement, {.start = start});
  const auto truth = oracle::rational_cast(a, b, displacement, start).contact;
  if (answer == truth) return 0;
  std::fprintf(stderr, "%s, %s, %s: %a for %a\n", oracle::text_of(a).c_str(),
               oracle::text_of(b).c_str(), oracle::text_of(displacement).c_str(),
               answer ? answer->time : -1, truth ? truth->time : -1);
  std::abort();
}
