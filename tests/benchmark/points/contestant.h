#pragma once

#include <graze/engine/mesh/mesh.h>

#include <Eigen/Core>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <utility>

namespace graze::benchmark {

/// What is asked about many points and a closed mesh.
enum class PointQuestion {
  Inside,   ///< is each enclosed, a call for each
  Nearest,  ///< the nearest point of the surface, a call for each
  Signed,   ///< both in one, a call for each
  Batch,    ///< the same in one call, with the caller's thread
};
inline constexpr std::array kPointQuestions{PointQuestion::Inside, PointQuestion::Nearest,
                                            PointQuestion::Signed, PointQuestion::Batch};

/// A library that answers them.
class PointContestant {
 public:
  explicit PointContestant(std::string name) : name_(std::move(name)) {}
  virtual ~PointContestant() = default;

  const std::string& name() const { return name_; }

  /// Makes all that queries need, for this mesh and no other.
  virtual void build(const Mesh& mesh) = 0;

  /// Answers for all points. Returns how many are inside, or the sum of the distances: what shows
  /// that the same was found.
  virtual double ask(PointQuestion question, std::span<const Eigen::Vector3d> points) = 0;

 private:
  std::string name_;
};

std::unique_ptr<PointContestant> make_graze_points();

#ifdef GRAZE_HAS_CGAL
std::unique_ptr<PointContestant> make_cgal_points();
#endif

}  // namespace graze::benchmark
