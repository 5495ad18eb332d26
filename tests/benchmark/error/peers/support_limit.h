#pragma once

#include <stdexcept>

namespace graze::benchmark {

/// libccd's MPR has no end on some shapes that nearly touch, whatever limit of iterations it is
/// given. A support function that counts its calls can end it: an exception passes through libccd,
/// which holds nothing, and the element counts as not answered.
class SupportLimit {
 public:
  static void begin() { calls_ = 0; }
  static void count() {
    if (++calls_ > kMost) throw std::runtime_error("no end in sight");
  }

 private:
  static constexpr int kMost = 10000;
  inline static int calls_ = 0;
};

}  // namespace graze::benchmark
