#pragma once

// This is about how a thread computes with floating-point numbers: the word by which it tells its
// CPU, and calls of functions with the word that the library needs.

#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#if defined(__x86_64__)
#include <xmmintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace graze::bvh {

/// Returns the bits of the control word that can change a result or raise a signal, as the thread
/// has them now. Which exceptions have been met so far is no part of it.
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

// C++ knows of the direction of rounding alone.
inline constexpr std::uint64_t kStandardControlWord = FE_TONEAREST;

inline std::uint64_t read_control_word() {
  return static_cast<std::uint64_t>(std::fegetround());
}

inline void write_control_word(std::uint64_t word) {
  std::fesetround(static_cast<int>(word));
}

#endif

/// A call of some function, of which the one who makes the call knows no more.
struct OpaqueCall {
  void (*call)(const void* context);
  const void* context;
};

/// Makes the call with kStandardControlWord set, and sets the word of before at its end, whether by
/// a result or by an exception. Exceptions that the arithmetic met stay on record.
void call_in_standard_arithmetic(OpaqueCall call);

/// Makes the call in the same way with the user's word.
void call_with_users_word(std::uint64_t users_word, OpaqueCall call);

/// Returns how the user of the library computes on this thread: what is set, unless
/// call_in_standard_arithmetic() has put it aside.
std::uint64_t users_control_word();

/// Hands `function` to `caller`, which calls it by its address, and returns what it returned. No
/// compiler sees through that, so that none moves arithmetic of the function out of the call.
template <typename Function, typename Caller>
[[gnu::cold]] std::invoke_result_t<const Function&> call_by_address(const Function& function,
                                                                    const Caller& caller) {
  using Result = std::invoke_result_t<const Function&>;
  if constexpr (std::is_void_v<Result>) {
    caller({[](const void* context) { (*static_cast<const Function*>(context))(); }, &function});
  } else if constexpr (std::is_reference_v<Result>) {
    std::remove_reference_t<Result>* result = nullptr;
    const auto keep = [&] { result = std::addressof(function()); };
    call_by_address(keep, caller);
    return static_cast<Result>(*result);
  } else {
    std::optional<std::remove_cv_t<Result>> result;
    const auto keep = [&] { result.emplace(function()); };
    call_by_address(keep, caller);
    return *std::move(result);
  }
}

/// Returns what `function()` returns, computed as every bound of the library takes for granted:
/// rounded to nearest, denormal numbers kept, no exception trapped.
///
/// Every function that users call wraps its work so, and every task that another thread may take.
/// Where the control word is right, which two to five nanoseconds tell, the function is called as
/// any other and can be inlined. Where it is wrong the call goes by the function's address through
/// another source: a compiler knows of no tie between the word and arithmetic, and would else move
/// one past the other.
template <typename Function>
[[gnu::always_inline]] inline std::invoke_result_t<const Function&> in_standard_arithmetic(
    const Function& function) {
  if (read_control_word() == kStandardControlWord) [[likely]]
    return function();
  return call_by_address(function, call_in_standard_arithmetic);
}

/// Returns what `function()` returns, computed as the user of the library does: for functions that
/// are his own, called in in_standard_arithmetic(). What such a function sets anew is gone when it
/// ends. With a word it is computed as on that thread from whose call this one computes.
template <typename Function>
std::invoke_result_t<const Function&> in_users_arithmetic(std::uint64_t users_word,
                                                          const Function& function) {
  return call_by_address(function,
                         [users_word](OpaqueCall call) { call_with_users_word(users_word, call); });
}

template <typename Function>
std::invoke_result_t<const Function&> in_users_arithmetic(const Function& function) {
  return in_users_arithmetic(users_control_word(), function);
}

}  // namespace graze::bvh
