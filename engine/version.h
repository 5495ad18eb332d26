#pragma once

namespace graze {

/// The first number of the version that these headers are of. Until 1.0 a new second number may
/// break sources.
inline constexpr int kVersionMajor = 0;
inline constexpr int kVersionMinor = 2;  ///< the second number
inline constexpr int kVersionPatch = 0;  ///< the third number

/// Returns "0.2.0": the version of the library that runs, which may be another than the headers'
/// where it is shared.
const char* library_version();

}  // namespace graze
