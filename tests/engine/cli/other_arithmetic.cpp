// A library that is loaded into a program and sets how it computes, as one does that was linked
// with -ffast-math: the control word is that of the environment variable GRAZE_CONTROL_WORD.

#include <graze/bvh/floating_point/standard_arithmetic.h>

#include <cstdlib>

namespace {

[[gnu::constructor]] void set_control_word() {
  if (const char* word = std::getenv("GRAZE_CONTROL_WORD"))
    graze::bvh::write_control_word(std::strtoull(word, nullptr, 0));
}

}  // namespace
