#pragma once

#include <graze/bvh/floating_point/control_word.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace graze::bvh {

/// A call of some function, of which the one who makes the call knows no more.
struct OpaqueCall {
  void (*call)(const void* context);
  const void* context;
};

/// Makes the call with kStandardControlWord set, and sets the word of before at its end, whether by
/// a result or by an exception. Exceptions that the arithmetic met stay on record.
void call_in_standard_arithmetic(OpaqueCall call);

/// Likewise with the user's word.
void call_with_users_word(std::uint64_t users_word, OpaqueCall call);

/// How the user of the library computes on this thread: what is set, unless
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

/// What `function()` returns, computed as every bound of the library takes for granted: rounded to
/// nearest, denormal numbers kept, no exception trapped.
///
/// Every function that users call wraps its work so, and every task that another thread may take.
/// Where the control word is right, which two to five nanoseconds tell, the function is called as
/// any other and can be inlined. Where it is wrong the call goes by the
/// function's address through another source: a compiler knows of no tie between the word and
/// arithmetic, and would else move one past the other.
template <typename Function>
[[gnu::always_inline]] inline std::invoke_result_t<const Function&> in_standard_arithmetic(
    const Function& function) {
  if (read_control_word() == kStandardControlWord) [[likely]]
    return function();
  return call_by_address(function, call_in_standard_arithmetic);
}

/// What `function()` returns, computed as the user of the library does: for functions that are his
/// own, called in in_standard_arithmetic(). What such a function sets anew is gone when it ends.
/// With a word: as on that thread from whose call this one computes.
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
