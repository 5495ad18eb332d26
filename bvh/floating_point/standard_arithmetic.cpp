#include <graze/bvh/floating_point/standard_arithmetic.h>

#include <utility>

namespace graze::bvh {
namespace {

/// The user's word that the innermost call of call_in_standard_arithmetic() on this thread has put
/// aside; null outside one, and in functions of the user's.
thread_local const std::uint64_t* word_put_aside = nullptr;

/// Sets a control word and which word is put aside, and restores both at its end. What happens
/// between is a call by address, which no arithmetic leaves.
class Scope {
 public:
  Scope(std::uint64_t word, const std::uint64_t* aside)
      : word_before_(read_control_word()), aside_before_(std::exchange(word_put_aside, aside)) {
    if (word != word_before_) write_control_word(word);
  }

  ~Scope() {
    if (read_control_word() != word_before_) write_control_word(word_before_);
    word_put_aside = aside_before_;
  }

  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;

 private:
  std::uint64_t word_before_;
  const std::uint64_t* aside_before_;
};

/// The address is read from memory, so that it is unknown also to an optimiser that sees all
/// sources at once.
void make(OpaqueCall call) {
  void (*const volatile address)(const void*) = call.call;
  address(call.context);
}

}  // namespace

void call_in_standard_arithmetic(OpaqueCall call) {
  const std::uint64_t users_word = read_control_word();
  const Scope scope(kStandardControlWord, &users_word);
  make(call);
}

void call_with_users_word(std::uint64_t users_word, OpaqueCall call) {
  const Scope scope(users_word, nullptr);
  make(call);
}

std::uint64_t users_control_word() {
  return word_put_aside != nullptr ? *word_put_aside : read_control_word();
}

}  // namespace graze::bvh
