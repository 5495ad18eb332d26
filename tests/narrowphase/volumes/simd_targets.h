#pragma once

#include <hwy/targets.h>

#include <cstdint>
#include <vector>

namespace graze {

/// The SIMD targets that this CPU has.
inline std::vector<std::int64_t> simd_targets() {
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::int64_t> single;
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1)
    single.push_back(left & -left);
  return single;
}

/// Forces one of them, or any with 0.
inline void force_simd_target(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace graze
