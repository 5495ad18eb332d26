#include <graze/engine/mesh/sweep/earliest_meeting.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_triangle.h>

namespace graze {
namespace {

using narrowphase::Meeting;
using narrowphase::MeetingTime;
using narrowphase::TimeQuotient;
using narrowphase::TranslatedPair;

std::uint32_t place(int at) {
  return static_cast<std::uint32_t>(at);
}

/// Corners that meet an edge, or a corner, are named as meeting the triangle.
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

void EarliestMeeting::ask_from_start(TrianglePair pair, const Triangle& a, const Triangle& b,
                                     Work& work) {
  const bool is_found_at_start = found_ && !found_->meeting;
  if (is_found_at_start && found_->pair < pair) return;
  const narrowphase::Decision decision = narrowphase::decide(a, b);
  work.exact_tests += decision.stage == narrowphase::Stage::Exact;
  if (!decision.is_hit) return ask_later(pair, a, b);
  if (start_ == StartContact::IsLeft && !crosses_from_start(translated(a, b))) return;
  take({pair, a, b, std::nullopt}, 0);
}

void EarliestMeeting::ask_later(TrianglePair pair, const Triangle& a, const Triangle& b) {
  if (found_ && !found_->meeting) return;
  const TranslatedPair translated_pair = translated(a, b);
  const std::optional<Meeting> meeting = first_meeting(translated_pair);
  if (!meeting) return;
  const MeetingTime time(TimeQuotient(translated_pair, *meeting));
  if (found_) {
    const TranslatedPair other = translated(found_->a, found_->b);
    const narrowphase::Sign order =
        compare(time, MeetingTime(TimeQuotient(other, *found_->meeting)));
    if (order == narrowphase::Sign::Positive) return;
    if (order == narrowphase::Sign::Zero && found_->pair < pair) return;
  }
  take({pair, a, b, meeting}, std::min(time.bounds.high, limit_));
}

void EarliestMeeting::take(const Found& found, double limit) {
  found_ = found;
  limit_ = limit;
}

std::optional<MeshCast> EarliestMeeting::result() const {
  if (!found_) return std::nullopt;
  const TranslatedPair pair = translated(found_->a, found_->b);
  MeshCast cast{0, true, found_->pair, MeetingFeatures::Crossing, 0, 0, {}, {}};
  if (!found_->meeting) {
    cast.point = intersection(found_->a, found_->b).corner[0];
    cast.normal = normal_at_start(pair);
    return cast;
  }
  cast.time = rounded_down(TimeQuotient(pair, *found_->meeting));
  cast.is_at_start = false;
  name_features(*found_->meeting, cast);
  cast.point = point_of(pair, *found_->meeting);
  cast.normal = normal_of(pair, *found_->meeting);
  return cast;
}

}  // namespace graze
