// This tells which pairs of a front are due in a pass: those whose budget is spent and that no
// plane keeps out any more. It also computes how much motion the planes of the others outlast. It
// is included once for each SIMD target.

#if defined(GRAZE_BVH_FRONT_DUE) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_FRONT_DUE
#undef GRAZE_BVH_FRONT_DUE
#else
#define GRAZE_BVH_FRONT_DUE
#endif

#include <graze/bvh/wide/front/plane_store-inl.h>
#include <graze/bvh/wide/front/wide_front.h>
#include <graze/bvh/wide/lanes/pair_lanes-inl.h>
#include <hwy/cache_control.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// A number that was rounded to float up to four times and is multiplied by this is no less than it
/// was.
inline constexpr float kRoundUp = 1 + 0x1p-20f;

/// Quotients are multiplied by this, which covers errors of estimated reciprocals on any target.
inline constexpr float kReciprocalError = 1 - kEstimateError;

/// A displacement that is linear in the point, column by column.
struct alignas(16) DisplacementColumns {
  float column[4][4];  ///< three columns for the change of the rotation, one for the translation's;
                       ///< the rest is 0

  HWY_INLINE void set(const QueryDisplacement& displacement, float scale) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        column[j][i] = displacement.rotation_change[i][j] * scale;
      column[3][i] = displacement.translation_change[i] * scale;
    }
    for (auto& c : column)
      c[3] = 0;
  }

  /// Computes the displacement of a point.
  HWY_INLINE void move(const float (&point)[3], float (&displaced)[4]) const {
    const FourTag tag;
    for (std::size_t part = 0; part < 4; part += hn::Lanes(tag)) {
      auto sum = hn::Load(tag, column[3] + part);
      for (int j = 0; j < 3; ++j)
        sum = hn::MulAdd(hn::Load(tag, column[j] + part), hn::Set(tag, point[j]), sum);
      hn::StoreU(sum, tag, displaced + part);
    }
  }
};

/// The outlook of one pass for one side: it computes what the planes of a front prove in its poses,
/// of the query boxes that are tested against the nodes of one side, and how much motion these
/// proofs outlast.
template <FrontKind kind>
class FrontOutlook {
 public:
  template <std::size_t lanes>
  using Planes = FrontPlanes<lanes, kind>;

  HWY_INLINE void set(const WideFront::Pass& pass, int tested_side) {
    const QueryDisplacement& since = pass.since[tested_side];
    since_.set(since, Planes<1>::kUnit);
    rotation_sum_ = since.rotation_sum;
    error_ = since.error;
    is_predicted_ = pass.deviation < 1;
    const QueryDisplacement& prediction = pass.predicted[tested_side];
    prediction_.set(prediction, -pass.per_distance * Planes<1>::kUnit);
    deviation_ = pass.deviation;
    rate_by_radius_ = prediction.rotation_sum * pass.per_distance * kRoundUp;
    rate_of_errors_ = 2 * prediction.error * pass.per_distance * kRoundUp + pass.deviation;
  }

  /// Returns the least of the gaps that planes prove now.
  template <std::size_t lanes>
  HWY_INLINE float gap(const Planes<lanes>& planes) const {
    const hn::CappedTag<float, lanes> tag;
    auto least = hn::Set(tag, std::numeric_limits<float>::infinity());
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(tag)) {
      hn::Vec<decltype(tag)> normal[3];
      least = hn::Min(least, gaps(tag, planes, lane, normal));
    }
    return hn::GetLane(hn::MinOfLanes(tag, least)) * kRoundPlanes;
  }

  /// Returns how much motion may still be spent while all of these gaps stay above 0
  /// (front_planes.h).
  template <std::size_t lanes>
  HWY_INLINE float motion_left(const Planes<lanes>& planes) const {
    if (!is_predicted_) return gap(planes);
    const hn::CappedTag<float, lanes> tag;
    const auto closing_rate = closing_rate_of(tag, planes.ball);
    auto least = hn::Set(tag, std::numeric_limits<float>::infinity());
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(tag)) {
      hn::Vec<decltype(tag)> normal[3];
      const auto gap = gaps(tag, planes, lane, normal);
      least = hn::Min(least, closing_rate.motion_left(gap, normal));
    }
    return hn::GetLane(hn::MinOfLanes(tag, least)) * kRoundPlanes;
  }

  struct Nearness {
    std::uint32_t near;  ///< the lanes that are within the limit
    float motion_left;   ///< the motion that the gaps of the other lanes outlast
  };

  /// Stores the gaps of the planes that were found for these lanes, as of the pose at begin().
  /// Their normals are stored already.
  template <std::size_t lanes>
  HWY_INLINE Nearness keep(Planes<lanes>& planes, const FoundPlanes<lanes>& found,
                           std::uint32_t asked, float limit) const {
    const hn::CappedTag<float, lanes> tag;
    float displaced[4] = {};
    since_.move(planes.ball.centre, displaced);
    const auto gained = hn::Set(tag, planes.ball.radius() * rotation_sum_ * kRoundPlanes - error_);
    const auto closing_rate = closing_rate_of(tag, planes.ball);
    std::uint32_t near = 0;
    auto least = hn::Set(tag, std::numeric_limits<float>::infinity());
    for (std::size_t lane = 0; lane < lanes; lane += hn::Lanes(tag)) {
      const std::uint8_t bits[8] = {static_cast<std::uint8_t>(asked >> lane),
                                    static_cast<std::uint8_t>(asked >> lane >> 8)};
      const auto is_asked = hn::LoadMaskBits(tag, bits);
      const auto gap = hn::Load(tag, found.gap + lane);
      const auto is_far = hn::Gt(gap, hn::Set(tag, limit));
      const auto is_kept = hn::And(is_far, is_asked);
      hn::Vec<decltype(tag)> normal[3];
      const auto stored_gap = hn::Load(tag, found.stored_gap + lane);
      auto stored = hn::Mul(stored_gap, hn::Set(tag, kRoundPlanes));
      for (int i = 0; i < 3; ++i) {
        normal[i] = hn::Load(tag, found.normal[i] + lane);
        stored = hn::NegMulAdd(normal[i], hn::Set(tag, displaced[i]), stored);
      }
      const auto motion_left = is_predicted_ ? closing_rate.motion_left(stored_gap, normal) : gap;
      least = hn::Min(least, hn::IfThenElse(is_kept, motion_left, least));
      near |= bits_of(tag, hn::AndNot(is_far, is_asked)) << lane;
      const auto never = hn::Set(tag, std::numeric_limits<float>::infinity());
      hn::Store(hn::IfThenElse(is_kept, hn::Add(stored, gained), never), tag, planes.gap + lane);
    }
    return {near, hn::GetLane(hn::MinOfLanes(tag, least))};
  }

 private:
  /// Says how fast gaps of a query box close on its predicted motion: by so much at most for each
  /// unit of the motion spent.
  template <typename AnyTag>
  struct ClosingRate {
    using Values = hn::Vec<AnyTag>;

    Values back[3];  ///< the rate of the query box's middle, against each axis
    Values all;      ///< the rate of rotation and of rounding, along any direction
    Values least;    ///< the rate of the deviation from the predicted motion

    HWY_INLINE Values motion_left(Values gap, const Values (&normal)[3]) const {
      auto rate = hn::MulAdd(normal[0], back[0], all);
      rate = hn::MulAdd(normal[1], back[1], rate);
      rate = hn::MulAdd(normal[2], back[2], rate);
      rate = hn::Min(hn::Max(rate, least), hn::Set(AnyTag(), 1.0f));
      return hn::Mul(gap,
                     hn::Mul(hn::ApproximateReciprocal(rate), hn::Set(AnyTag(), kReciprocalError)));
    }
  };

  template <typename AnyTag>
  HWY_INLINE ClosingRate<AnyTag> closing_rate_of(AnyTag tag, const QueryBall& query) const {
    float displaced[4] = {};
    prediction_.move(query.centre, displaced);
    ClosingRate<AnyTag> closing_rate;
    for (int i = 0; i < 3; ++i)
      closing_rate.back[i] = hn::Set(tag, displaced[i]);
    closing_rate.all = hn::Set(tag, query.radius() * rate_by_radius_ + rate_of_errors_);
    closing_rate.least = hn::Set(tag, deviation_);
    return closing_rate;
  }

  /// Returns the gaps that planes prove now, and reads their normals.
  template <typename AnyTag, std::size_t lanes>
  HWY_INLINE hn::Vec<AnyTag> gaps(AnyTag tag, const Planes<lanes>& planes, std::size_t lane,
                                  hn::Vec<AnyTag> (&normal)[3]) const {
    float displaced[4] = {};
    since_.move(planes.ball.centre, displaced);
    const float lost = planes.ball.radius() * rotation_sum_ * (1 / kRoundPlanes) + error_;
    auto gap = hn::Sub(PlaneStore<kind>::read(tag, planes, lane, normal), hn::Set(tag, lost));
    for (int i = 0; i < 3; ++i)
      gap = hn::MulAdd(normal[i], hn::Set(tag, displaced[i]), gap);
    return gap;
  }

  DisplacementColumns since_;
  DisplacementColumns prediction_;
  float rotation_sum_;
  float error_;
  float deviation_;
  float rate_by_radius_;  ///< the rate of closing by rotation, for each unit of a query box's
                          ///< radius
  float rate_of_errors_;  ///< the rate of closing by what the prediction is off by
  bool is_predicted_;
};

/// The budgets of a pair that a pass must look at, and of one that no motion makes due.
inline constexpr float kDueNow = -std::numeric_limits<float>::infinity();
inline constexpr float kNever = std::numeric_limits<float>::infinity();

/// The numbers of leaves, and of planes, that are fetched ahead of the one that is looked at.
inline constexpr std::size_t kAhead = 6;
inline constexpr std::size_t kPlanesAhead = 16;

/// Returns the first value if `is_first` is 1, the second if it is 0, without a branch.
HWY_INLINE float chosen(std::uint32_t is_first, float first, float second) {
  const auto other = std::bit_cast<std::uint32_t>(second);
  const std::uint32_t change = std::bit_cast<std::uint32_t>(first) ^ other;
  return std::bit_cast<float>(other ^ (change & (0 - is_first)));
}

HWY_INLINE WideFront::Planes<FrontKind::Intersection>& planes_of(
    WideFront::State& state, std::integral_constant<FrontKind, FrontKind::Intersection> /*of*/) {
  return state.intersection;
}
HWY_INLINE WideFront::Planes<FrontKind::Distance>& planes_of(
    WideFront::State& state, std::integral_constant<FrontKind, FrontKind::Distance> /*of*/) {
  return state.distance;
}

/// Finds which pairs of a front are due in a pass, and renews the budgets of the others.
template <FrontKind kind>
class FrontDue {
 protected:
  using VisitPlanes = FrontPlanes<WideNode::kWidth, kind>;
  using LeafPlanes = FrontPlanes<kLeafPairs, kind>;
  using Outlook = FrontOutlook<kind>;

  FrontDue(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task)
      : state_(state),
        planes_(planes_of(state, std::integral_constant<FrontKind, kind>())),
        pass_(pass),
        required_(task.required),
        look_ahead_(task.look_ahead),
        spent_(static_cast<float>(pass.spent) * kRoundDown) {
    for (int side = 0; side < 2; ++side)
      outlook_[side].set(pass, side);
  }

  /// Gives later budgets to pairs whose budget is spent but that their planes still keep out. The
  /// others whose budget is spent are due: lists these at the front of state_.due, and returns how
  /// many they are. There are no branches but the loops, because nothing of it can be predicted.
  template <typename Planes>
  HWY_NOINLINE std::size_t renew_budgets(const std::vector<Planes>& planes,
                                         std::vector<float>& budgets) const {
    const std::size_t size = list_spent(budgets);
    std::uint32_t* const due = state_.due.data();
    std::size_t due_count = 0;
    for (std::size_t i = 0; i < size; ++i) {
      prefetch(planes[due[std::min(i + kPlanesAhead, size - 1)]]);
      const std::uint32_t index = due[i];
      const float later =
          budget_after(outlook_[planes[index].ball.tested_side].motion_left(planes[index]));
      // NaN compares false, so that it is due. A budget beyond that implies a gap above `limit`.
      const std::uint32_t kept = later > look_ahead_.spent_budget;
      budgets[index] = chosen(kept, later, budgets[index]);
      due[due_count] = index;
      due_count += 1 - kept;
    }
    return due_count;
  }

  template <typename Object>
  HWY_INLINE static void prefetch(const Object& object) {
    constexpr std::size_t kLine = 64;
    for (std::size_t i = 0; i < sizeof(Object); i += kLine)
      hwy::Prefetch(reinterpret_cast<const char*>(&object) + i);
  }

  /// Lists the indices of all budgets that are spent.
  HWY_NOINLINE std::size_t list_spent(const std::vector<float>& budgets) const {
    const hn::ScalableTag<float> tag;
    const hn::RebindToUnsigned<decltype(tag)> indices;
    const std::size_t lanes = hn::Lanes(tag);
    const std::size_t size = budgets.size();
    if (state_.due.size() < size + lanes) state_.due.resize(2 * size + lanes);
    std::uint32_t* const list = state_.due.data();
    std::size_t count = 0;
    std::size_t i = 0;
    for (; i + lanes <= size; i += lanes) {
      const auto is_spent =
          hn::Le(hn::LoadU(tag, budgets.data() + i), hn::Set(tag, look_ahead_.spent_budget));
      count += hn::CompressStore(hn::Iota(indices, static_cast<std::uint32_t>(i)),
                                 hn::RebindMask(indices, is_spent), indices, list + count);
    }
    for (; i < size; ++i) {
      list[count] = static_cast<std::uint32_t>(i);
      count += budgets[i] <= look_ahead_.spent_budget;
    }
    return count;
  }

  float budget_after(float motion_left) const {
    // The sum is rounded down: it is not negative where it matters.
    return (spent_ + motion_left) * kRoundDown;
  }

  HWY_INLINE static float least_of(const std::vector<float>& budgets) {
    const hn::ScalableTag<float> tag;
    const std::size_t lanes = hn::Lanes(tag);
    auto least = hn::Set(tag, kNever);
    std::size_t i = 0;
    for (; i + lanes <= budgets.size(); i += lanes)
      least = hn::Min(least, hn::LoadU(tag, budgets.data() + i));
    float found = hn::GetLane(hn::MinOfLanes(tag, least));
    for (; i < budgets.size(); ++i)
      found = std::min(found, budgets[i]);
    return found;
  }

  WideFront::State& state_;
  WideFront::Planes<kind>& planes_;
  const WideFront::Pass& pass_;
  FrontHorizon required_;
  FrontHorizon look_ahead_;
  float spent_;         ///< the motion spent, rounded down
  Outlook outlook_[2];  ///< the outlook for each side of the tested node
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
