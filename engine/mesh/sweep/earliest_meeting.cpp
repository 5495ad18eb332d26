#include <graze/engine/mesh/sweep/earliest_meeting.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

using narrowphase::Meeting;
using narrowphase::MeetingTime;
using narrowphase::Sign;
using narrowphase::TimedMeeting;
using narrowphase::TimeQuotient;
using narrowphase::TranslatedPair;

std::uint32_t place(int at) {
  return static_cast<std::uint32_t>(at);
}

/// Names the features that meet. Corners that meet an edge, or a corner, are named as meeting the
/// triangle.
void name_features(const Meeting& meeting, MeshCast& cast) {
  switch (meeting.kind) {
    case Meeting::Kind::VertexFace:
    case Meeting::Kind::VertexOnEdge:
    case Meeting::Kind::VertexVertex:
      cast.features = MeetingFeatures::VertexFace;
      cast.place_a = place(meeting.a);
      return;
    case Meeting::Kind::FaceVertex:
    case Meeting::Kind::EdgeWithVertex:
      cast.features = MeetingFeatures::FaceVertex;
      cast.place_b = place(meeting.b);
      return;
    case Meeting::Kind::EdgeEdge:
      cast.features = MeetingFeatures::EdgeEdge;
      cast.place_a = place(meeting.a);
      cast.place_b = place(meeting.b);
  }
}

}  // namespace

void EarliestMeeting::ask_at_start(TrianglePair pair, const Triangle& a, const Triangle& b) {
  if (is_at_start() && found_->pair < pair) return;
  if (start_ == StartContact::IsLeft && !crosses_from_start(translated(a, b))) return;
  take({pair, a, b, std::nullopt}, 0);
}

bool EarliestMeeting::ask_later(TrianglePair pair, const Triangle& a, const Triangle& b) {
  if (is_at_start()) return false;
  const TranslatedPair translated_pair = translated(a, b);
  const std::optional<TimedMeeting> first = first_meeting(translated_pair);
  if (!first || first->bounds.low > limit_) return false;
  if (found_) {
    const MeetingTime other(translated(found_->a, found_->b), *found_->first);
    const Sign order = compare(MeetingTime(translated_pair, *first), other);
    if (order == Sign::Positive || (order == Sign::Zero && found_->pair < pair)) return false;
  }
  take({pair, a, b, first}, std::min(first->bounds.high, limit_));
  return true;
}

void EarliestMeeting::rough_normal(double (&normal)[3]) const {
  normal[0] = normal[1] = normal[2] = 0;
  if (!found_ || !found_->first) return;
  const TimeQuotient time(translated(found_->a, found_->b), found_->first->meeting);
  double p[3], q[3], largest_p = 0, largest_q = 0;
  for (int k = 0; k < 3; ++k) {
    p[k] = time.p.to[k] - time.p.from[k];
    q[k] = time.q.to[k] - time.q.from[k];
    largest_p = std::max(largest_p, std::abs(p[k]));
    largest_q = std::max(largest_q, std::abs(q[k]));
  }
  if (largest_p == 0 || largest_q == 0) return;
  for (int k = 0; k < 3; ++k) {
    p[k] /= largest_p;
    q[k] /= largest_q;
  }
  for (int k = 0; k < 3; ++k)
    normal[k] = p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
}

void EarliestMeeting::take(const Found& found, double limit) {
  found_ = found;
  limit_ = limit;
}

std::optional<MeshCast> EarliestMeeting::result() const {
  if (!found_) return std::nullopt;
  const TranslatedPair pair = translated(found_->a, found_->b);
  MeshCast cast{0, true, found_->pair, MeetingFeatures::AtStart, 0, 0, {0, 0, 0}, {}};
  if (!found_->first) {
    cast.normal = normal_at_start(pair);
    return cast;
  }
  cast.time = rounded_down(TimeQuotient(pair, found_->first->meeting));
  cast.is_at_start = false;
  name_features(found_->first->meeting, cast);
  cast.point = point_of(pair, found_->first->meeting);
  cast.normal = normal_of(pair, found_->first->meeting);
  return cast;
}

}  // namespace graze
