#include <tests/fuzz/byte_shapes.h>
#include <tests/narrowphase/derived/value_faults.h>

#include <cstdio>
#include <cstdlib>

// Laws 4 and 7 for the distance and the intersection of two triangles, with rational arithmetic as
// oracle. A crash prints the case.

using namespace graze;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes shapes(data, size);
  const Triangle a = shapes.triangle();
  const oracle::TrianglePair pair{a, shapes.triangle()};
  const std::string fault = oracle::distance_fault(pair) + oracle::intersection_fault(pair);
  if (fault.empty()) return 0;
  std::fputs(fault.c_str(), stderr);
  std::abort();
}
