#pragma once

namespace graze::cli {

/// The SIMD instructions that this program uses on this machine: "AVX2". No answer depends on it.
const char* simd_target();

}  // namespace graze::cli
