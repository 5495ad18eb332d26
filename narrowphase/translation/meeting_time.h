#pragma once

// The time of a meeting is a quotient of two determinants of degree three: with w from a point of B
// to one of A, and a vector p x q for which both points may be any of the features that meet,
// (p x q) . w = t (p x q) . d.

#include <graze/narrowphase/translation/translation.h>

namespace graze::narrowphase {

/// The time ((p x q) . w) / ((p x q) . d), whose divisor is not zero.
struct TimeQuotient {
  Step p;
  Step q;
  Step w;
  Step d;
  bool is_of_edges;  ///< true if p and q are the edges that meet

  TimeQuotient(const TranslatedPair& pair, const Meeting& meeting);
};

TimeBounds bounds_of(const TimeQuotient& time);

/// A time that is not negative, for comparisons. The pair that it was made of must outlive it.
struct MeetingTime {
  TimeQuotient quotient;
  TimeBounds bounds;

  explicit MeetingTime(const TimeQuotient& time) : quotient(time), bounds(bounds_of(time)) {}
  MeetingTime(const TranslatedPair& pair, const TimedMeeting& timed)
      : quotient(pair, timed.meeting), bounds(timed.bounds) {}
};

/// Return the sign of a time, and of s - t. Exact.
Sign sign_of(const TimeQuotient& time);
Sign compare(const MeetingTime& s, const MeetingTime& t);

/// True if a time is above 1. Exact.
bool is_above_one(const MeetingTime& time);

/// Returns the largest double that is not above a time, in [0, 1].
double rounded_down(const TimeQuotient& time);

/// Returns the point where features meet, each coordinate off by at most 0.51 ulp of itself.
Eigen::Vector3d point_of(const TranslatedPair& pair, const Meeting& meeting);

/// Returns a unit vector across both features, from A to B, right to a few ulp: the normal of the
/// triangle, or across both edges; against d where corners meet; against d and across the edge
/// where a corner and an edge meet.
Eigen::Vector3d normal_of(const TranslatedPair& pair, const Meeting& meeting);

/// Returns the normal of A's triangle, of B's if that has none, or else the direction against d,
/// right to a few ulp; zero if d is, too.
Eigen::Vector3d normal_at_start(const TranslatedPair& pair);

}  // namespace graze::narrowphase
