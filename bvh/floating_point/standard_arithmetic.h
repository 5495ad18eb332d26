#pragma once

#include <graze/bvh/floating_point/control_word.h>

#include <atomic>
#include <cstdint>

namespace graze::bvh {

/// While one lives, its thread computes as every bound of the library takes for granted: rounded to
/// nearest, denormal numbers kept, no exception trapped. It ends as it began: the user's way of
/// computing is back, whether a result or an exception is handed out. Exceptions that were met
/// meanwhile stay on record, as after any arithmetic.
///
/// Every door of the library makes one, and every task that another thread may take. Where all is
/// as it should be that is one word read and compared: some two nanoseconds.
class StandardArithmetic {
 public:
  StandardArithmetic() noexcept {
    if (read_control_word() != kStandardControlWord) [[unlikely]]
      begin();
    // The compiler knows of no tie between the control word and arithmetic; but it takes what
    // cannot be seen to write to memory, from which all operands come.
    std::atomic_signal_fence(std::memory_order_seq_cst);
  }

  ~StandardArithmetic() {
    std::atomic_signal_fence(std::memory_order_seq_cst);
    if (is_begun_) [[unlikely]]
      end();
  }

  StandardArithmetic(const StandardArithmetic&) = delete;
  StandardArithmetic& operator=(const StandardArithmetic&) = delete;

 private:
  friend std::uint64_t users_control_word();
  void begin() noexcept;
  void end() noexcept;

  bool is_begun_ = false;
  std::uint64_t users_word_;         // if begun
  const StandardArithmetic* outer_;  // likewise: of this thread, or null
};

/// How the user of the library computes on this thread: what is set, unless a StandardArithmetic
/// has put it aside.
std::uint64_t users_control_word();

/// While one lives, the user's way of computing is back, inside a StandardArithmetic: for calls of
/// functions that are his own. What such a function sets anew is gone when it ends.
class UserArithmetic {
 public:
  UserArithmetic() noexcept : UserArithmetic(users_control_word()) {}

  /// Or that of another thread, from whose call this one computes.
  explicit UserArithmetic(std::uint64_t users_word) noexcept;
  ~UserArithmetic();

  UserArithmetic(const UserArithmetic&) = delete;
  UserArithmetic& operator=(const UserArithmetic&) = delete;

 private:
  const StandardArithmetic* outer_;
};

}  // namespace graze::bvh
