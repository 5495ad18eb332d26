#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace graze::tests {

/// All bits of an answer, in the order in which they are told: two answers are equal if these are.
class Digest {
 public:
  template <typename Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number> Digest& operator<<(
      Number number) {
    if constexpr (std::is_floating_point_v<Number>) {
      words_.push_back(std::bit_cast<std::uint64_t>(static_cast<double>(number)));
    } else {
      words_.push_back(static_cast<std::uint64_t>(number));
    }
    return *this;
  }
  Digest& operator<<(const Eigen::Vector3d& v) { return *this << v[0] << v[1] << v[2]; }

  std::size_t size() const { return words_.size(); }
  friend bool operator==(const Digest&, const Digest&) = default;

 private:
  std::vector<std::uint64_t> words_;
};

}  // namespace graze::tests
