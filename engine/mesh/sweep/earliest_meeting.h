#pragma once

#include <graze/engine/mesh/mesh_cast.h>
#include <graze/narrowphase/translation/meeting_time.h>

#include <optional>

namespace graze {

/// Finds the earliest meeting of the pairs of triangles that it is told of. Times are compared
/// exactly.
class EarliestMeeting {
 public:
  EarliestMeeting(const double* displacement, StartContact start)
      : displacement_(displacement), start_(start) {}

  /// Takes in triangles that meet at t = 0.
  void ask_at_start(TrianglePair pair, const Triangle& a, const Triangle& b);
  /// Takes in triangles that are apart at t = 0. Returns true if they are the earliest so far.
  bool ask_later(TrianglePair pair, const Triangle& a, const Triangle& b);

  bool is_at_start() const { return found_ && !found_->first; }
  /// Returns no less than the earliest time that has been found, or 1.
  double limit() const { return limit_; }

  /// Computes a normal that is roughly across what meets first so far; zero if that is at t = 0.
  void rough_normal(double (&normal)[3]) const;

  /// Returns the earliest meeting. At t = 0 its point is left to others.
  std::optional<MeshCast> result() const;

 private:
  /// The meeting that was found, with the triangles that it is about.
  struct Found {
    TrianglePair pair;
    Triangle a;
    Triangle b;
    std::optional<narrowphase::TimedMeeting> first;  ///< none if it meets at t = 0
  };
  narrowphase::TranslatedPair translated(const Triangle& a, const Triangle& b) const {
    return {a, b, displacement_};
  }
  void take(const Found& found, double limit);

  const double* displacement_;
  StartContact start_;
  std::optional<Found> found_;
  double limit_ = 1;
};

}  // namespace graze
