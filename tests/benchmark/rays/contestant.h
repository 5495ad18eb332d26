#pragma once

#include <graze/bvh/ray.h>
#include <graze/engine/mesh/mesh.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace graze::benchmark {

/// What is asked of a mesh and many rays.
enum class Question {
  First,  ///< the first hit, a call for each ray
  Any,    ///< does it hit at all, a call for each ray
  Batch,  ///< the first hit, of as many rays a call as the library takes at once
};
inline constexpr std::array kQuestions{Question::First, Question::Any, Question::Batch};

/// A library that answers questions about rays at one mesh.
class RayContestant {
 public:
  explicit RayContestant(std::string name) : name_(std::move(name)) {}
  virtual ~RayContestant() = default;

  const std::string& name() const { return name_; }

  /// Makes all that queries need, for this mesh and no other.
  virtual void build(const Mesh& mesh) = 0;

  /// Takes over the rays in the library's own numbers.
  virtual void take(std::span<const Ray> rays) = 0;

  /// Answers for all of the rays, and returns how many hit.
  virtual std::size_t ask(Question question) = 0;

 private:
  std::string name_;
};

std::unique_ptr<RayContestant> make_graze();

#ifdef GRAZE_HAS_EMBREE
std::unique_ptr<RayContestant> make_embree();
#endif

}  // namespace graze::benchmark
