#pragma once

// This is private to engine/mesh/rigid.

#include <graze/bvh/tree/tree.h>
#include <graze/engine/mesh/rigid_certificate.h>

#include <cstdint>
#include <vector>

namespace graze {

/// Records what a walk over two trees proves, step by step: a certificate, if it proves all.
class FreedomRecord {
 public:
  FreedomRecord(const bvh::Tree& tree_a, const bvh::Tree& tree_b)
      : sizes_a_(sizes_of(tree_a)), sizes_b_(sizes_of(tree_b)) {
    certificate_.order_a = order_of(tree_a);
    certificate_.order_b = order_of(tree_b);
  }

  void add_plane(const double (&normal)[3]) {
    add({FreedomStep::Kind::Plane, 0, {normal[0], normal[1], normal[2]}});
  }
  void halve_time() { add({FreedomStep::Kind::HalveTime, 0, {0, 0, 0}}); }

  /// Divide after the triangles of a node.
  void divide_a(std::uint32_t node) { divide_a_after(sizes_a_[node]); }
  void divide_b(std::uint32_t node) { divide_b_after(sizes_b_[node]); }

  void divide_a_after(std::uint32_t count) { add({FreedomStep::Kind::DivideA, count, {0, 0, 0}}); }
  void divide_b_after(std::uint32_t count) { add({FreedomStep::Kind::DivideB, count, {0, 0, 0}}); }

  FreedomCertificate take(double clearance) {
    certificate_.clearance = clearance;
    return std::move(certificate_);
  }

 private:
  void add(const FreedomStep& step) { certificate_.steps.push_back(step); }

  /// Returns how many triangles are below each node.
  static std::vector<std::uint32_t> sizes_of(const bvh::Tree& tree);

  /// Returns the triangles leaf by leaf, as a walk comes by them that takes first children first.
  static std::vector<std::uint32_t> order_of(const bvh::Tree& tree);

  std::vector<std::uint32_t> sizes_a_;
  std::vector<std::uint32_t> sizes_b_;
  FreedomCertificate certificate_;
};

}  // namespace graze
