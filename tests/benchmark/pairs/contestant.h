#pragma once

#include <graze/bvh/error.h>
#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/work.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace graze::benchmark {

/// What is asked of two meshes in a pose.
enum class Question {
  Any,       ///< does any triangle of one meet any of the other
  Pairs,     ///< which pairs do
  Distance,  ///< metres between the surfaces
  Within,    ///< are they at most a clearance apart
};
inline constexpr std::array kQuestions{Question::Any, Question::Pairs, Question::Distance,
                                       Question::Within};

inline const char* name_of(Question question) {
  constexpr std::array kNames{"any", "pairs", "distance", "within"};
  return kNames.at(static_cast<std::size_t>(question));
}

/// A way to answer questions about two meshes of which the second is moved.
class PairContestant {
 public:
  explicit PairContestant(std::string name) : name_(std::move(name)) {}
  virtual ~PairContestant() = default;

  const std::string& name() const { return name_; }

  /// Empty where it answers; otherwise a word on why it does not.
  virtual std::string refusal(Question question) const = 0;

  /// Makes all that queries need from the meshes' arrays, for each of the two, even if they are the
  /// same: whoever shares a tree between both saves half. The meshes outlive the queries. Throws
  /// Error for meshes that it does not take.
  virtual void build(const Mesh& mesh_a, const Mesh& mesh_b) = 0;
  virtual void release() = 0;

  virtual bool any(const Pose& pose_b) = 0;

  /// All pairs of triangles that intersect, in any order; `pairs` keeps its memory.
  virtual void find(const Pose& /*pose_b*/, std::vector<TrianglePair>& /*pairs*/) { decline(); }
  virtual double distance(const Pose& /*pose_b*/) { return decline(); }
  virtual bool within(const Pose& /*pose_b*/, double /*clearance*/) { return decline() > 0; }

  /// build() and any(), where only this one question will ever be asked.
  virtual bool any_once(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& pose_b) {
    build(mesh_a, mesh_b);
    return any(pose_b);
  }

  /// What a query does, if it says.
  virtual std::optional<Work> work(Question /*question*/, const Pose& /*pose_b*/,
                                   double /*clearance*/) {
    return std::nullopt;
  }

  /// The memory that it keeps, if it is not on the heap, where it is seen.
  virtual std::optional<std::size_t> bytes() const { return std::nullopt; }

 private:
  double decline() const { throw Error(name_ + " is asked what it does not answer"); }

  std::string name_;
};

using PairContestants = std::vector<std::unique_ptr<PairContestant>>;

/// The library: its default first, then other volumes.
void add_graze(PairContestants& contestants);

}  // namespace graze::benchmark
