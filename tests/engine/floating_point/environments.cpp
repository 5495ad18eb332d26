#include "tests/engine/floating_point/environments.h"

#ifdef __x86_64__
#include <xmmintrin.h>
#else
#include <cfenv>
#endif

namespace graze::tests {
namespace {

#ifdef __x86_64__

constexpr std::uint32_t kMasked = 0x1f80, kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
constexpr std::uint32_t kDown = 0x2000, kUp = 0x4000, kToZero = 0x6000;
// Invalid operations, divisions by zero and overflows alone, as feenableexcept() is mostly called;
// and all that there is.
constexpr std::uint32_t kThreeTrapped = 0x1f80 & ~0x0680u;

constexpr Environment kAll[] = {
    {"as programs begin", kMasked},
    {"flush to zero", kMasked | kFlushToZero},
    {"denormals are zero", kMasked | kDenormalsAreZero},
    {"as -ffast-math begins", kMasked | kFlushToZero | kDenormalsAreZero},
    {"rounding up", kMasked | kUp},
    {"rounding down", kMasked | kDown},
    {"rounding towards zero", kMasked | kToZero},
    {"three exceptions trap", kThreeTrapped},
    {"all exceptions trap", 0},
};

void set(std::uint32_t control) {
  _mm_setcsr(control);
}

#else

constexpr Environment kAll[] = {
    {"as programs begin", FE_TONEAREST},
    {"rounding up", FE_UPWARD},
    {"rounding down", FE_DOWNWARD},
    {"rounding towards zero", FE_TOWARDZERO},
};

void set(std::uint32_t control) {
  std::fesetround(static_cast<int>(control));
}

#endif

}  // namespace

std::span<const Environment> all_environments() {
  return kAll;
}

std::uint32_t current_control() {
#ifdef __x86_64__
  return _mm_getcsr() & 0xffc0;
#else
  return static_cast<std::uint32_t>(std::fegetround());
#endif
}

InEnvironment::InEnvironment(const Environment& environment) : before_(current_control()) {
  set(environment.control);
}

InEnvironment::~InEnvironment() {
  set(before_);
}

}  // namespace graze::tests
