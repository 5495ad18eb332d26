#include <graze/engine/cli/output/simd_target.h>

#include <hwy/targets.h>
#include <cstdint>

namespace graze::cli {

const char* simd_target() {
  const std::int64_t usable = hwy::SupportedTargets() & static_cast<std::int64_t>(HWY_TARGETS);
  return hwy::TargetName(usable & -usable);  // the lowest bit is the best
}

}  // namespace graze::cli
