#pragma once

#include <cstdint>
#include <span>

namespace graze::tests {

/// A way to compute that a program may have set before it calls the library.
struct Environment {
  const char* name;
  std::uint32_t
      control;  ///< on x86-64 MXCSR without the exceptions met, else as fesetround() takes
};

/// The first one is as C++ programs begin.
std::span<const Environment> all_environments();

/// What the thread has set now.
std::uint32_t current_control();

/// The thread computes so while one lives.
class InEnvironment {
 public:
  explicit InEnvironment(const Environment& environment);
  ~InEnvironment();
  InEnvironment(const InEnvironment&) = delete;
  InEnvironment& operator=(const InEnvironment&) = delete;

 private:
  std::uint32_t before_;
};

}  // namespace graze::tests
