#pragma once

// The word by which a thread says how its CPU computes with floating-point numbers.

#include <cstdint>

#if defined(__x86_64__)
#include <xmmintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace graze::bvh {

/// What of it can change a result or raise a signal, as the thread has it now. Which exceptions
/// have been met so far is no part of it.
std::uint64_t read_control_word();

/// Sets these bits. Which exceptions have been met is left as it is.
void write_control_word(std::uint64_t word);

#if defined(__x86_64__)

// MXCSR (Intel SDM, volume 1, 10.2.3). Bits 0 to 5 tell which exceptions have been met; 6 takes
// denormal operands for zero, 7 to 12 mask the exceptions, 13 and 14 round, 15 flushes results.
inline constexpr std::uint64_t kControlBits = 0xffc0;
inline constexpr std::uint64_t kStandardControlWord = 0x1f80;

inline std::uint64_t read_control_word() {
  return _mm_getcsr() & kControlBits;
}

inline void write_control_word(std::uint64_t word) {
  _mm_setcsr(static_cast<std::uint32_t>((_mm_getcsr() & ~kControlBits) | word));
}

#elif defined(__aarch64__)

// FPCR (Arm Architecture Reference Manual). Which exceptions have been met stands elsewhere, in
// FPSR. Bits 0 to 2 and 24 are about denormal numbers, 8 to 12 and 15 trap exceptions, 22 and 23
// round, 25 makes every NaN the same, which no result depends on.
inline constexpr std::uint64_t kControlBits = 0x01c09f07;
inline constexpr std::uint64_t kStandardControlWord = 0;

inline std::uint64_t read_whole_control_word() {
  std::uint64_t word;
  asm volatile("mrs %0, fpcr" : "=r"(word));
  return word;
}

inline std::uint64_t read_control_word() {
  return read_whole_control_word() & kControlBits;
}

inline void write_control_word(std::uint64_t word) {
  const std::uint64_t whole = (read_whole_control_word() & ~kControlBits) | word;
  asm volatile("msr fpcr, %0" : : "r"(whole));
}

#else

// What C++ knows of: the direction of rounding.
inline constexpr std::uint64_t kStandardControlWord = FE_TONEAREST;

inline std::uint64_t read_control_word() {
  return static_cast<std::uint64_t>(std::fegetround());
}

inline void write_control_word(std::uint64_t word) {
  std::fesetround(static_cast<int>(word));
}

#endif

}  // namespace graze::bvh
