#pragma once

#include <cstdint>

namespace graze::bvh {

/// Two separations in a row: the first is cheap, the second is asked about what the first lets
/// through.
template <typename First, typename Second>
class Cascade {
 public:
  Cascade(const First& first, const Second& second) : first_(first), second_(second) {}

  bool are_apart(std::uint32_t a, std::uint32_t b) const {
    return first_.are_apart(a, b) || second_.are_apart(a, b);
  }
  bool is_first_larger(std::uint32_t a, std::uint32_t b) const {
    return first_.is_first_larger(a, b);
  }

 private:
  First first_;
  Second second_;
};

}  // namespace graze::bvh
