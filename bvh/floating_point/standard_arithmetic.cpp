#include <graze/bvh/floating_point/standard_arithmetic.h>

#include <utility>

namespace graze::bvh {
namespace {

/// The innermost one on this thread that has put the user's way of computing aside.
thread_local const StandardArithmetic* innermost = nullptr;

}  // namespace

void StandardArithmetic::begin() noexcept {
  users_word_ = read_control_word();
  outer_ = std::exchange(innermost, this);
  is_begun_ = true;
  write_control_word(kStandardControlWord);
}

void StandardArithmetic::end() noexcept {
  innermost = outer_;
  write_control_word(users_word_);
}

std::uint64_t users_control_word() {
  return innermost != nullptr ? innermost->users_word_ : read_control_word();
}

UserArithmetic::UserArithmetic(std::uint64_t users_word) noexcept
    : outer_(std::exchange(innermost, nullptr)) {
  if (users_word != read_control_word()) write_control_word(users_word);
}

UserArithmetic::~UserArithmetic() {
  innermost = outer_;
  if (read_control_word() != kStandardControlWord) write_control_word(kStandardControlWord);
}

}  // namespace graze::bvh
