// Which pairs of a front are due in a pass: those whose budget is spent and that no plane keeps out
// any more. Included once for each SIMD target.

#if defined(GRAZE_BVH_FRONT_DUE) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_FRONT_DUE
#undef GRAZE_BVH_FRONT_DUE
#else
#define GRAZE_BVH_FRONT_DUE
#endif

#include <graze/bvh/wide/front/front_outlook-inl.h>
#include <graze/bvh/wide/front/front_pass.h>
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

inline constexpr float kAtOnce = -std::numeric_limits<float>::infinity();
inline constexpr float kNever = std::numeric_limits<float>::infinity();

/// How many leaves, and planes, are fetched ahead of the one that is looked at.
inline constexpr std::size_t kAhead = 6;
inline constexpr std::size_t kPlanesAhead = 16;

/// The first if `is_first` is 1, the second if it is 0, without a branch.
HWY_INLINE float chosen(std::uint32_t is_first, float first, float second) {
  const auto other = std::bit_cast<std::uint32_t>(second);
  const std::uint32_t change = std::bit_cast<std::uint32_t>(first) ^ other;
  return std::bit_cast<float>(other ^ (change & (0 - is_first)));
}

HWY_INLINE WideFront::Planes<FrontBounds::Meeting>& planes_of(
    WideFront::State& state, std::integral_constant<FrontBounds, FrontBounds::Meeting> /*of*/) {
  return state.meeting;
}
HWY_INLINE WideFront::Planes<FrontBounds::Distance>& planes_of(
    WideFront::State& state, std::integral_constant<FrontBounds, FrontBounds::Distance> /*of*/) {
  return state.distance;
}

/// Which pairs of a front are due in a pass, and how long what keeps the others out lasts.
template <FrontBounds bounds>
class FrontDue {
 protected:
  using VisitPlanes = FrontPlanes<WideNode::kWidth, bounds>;
  using LeafPlanes = FrontPlanes<kLeafPairs, bounds>;
  using Outlook = FrontOutlook<bounds>;

  FrontDue(WideFront::State& state, const WideFront::Pass& pass, const FrontTask& task)
      : state_(state),
        planes_(planes_of(state, std::integral_constant<FrontBounds, bounds>())),
        pass_(pass),
        must_(task.must),
        look_ahead_(task.look_ahead),
        moved_(static_cast<float>(pass.moved) * kRoundDown) {
    for (int side = 0; side < 2; ++side)
      outlook_[side].set(pass, side);
  }

  /// Lists at the front of state_.due what has to be looked at again, and returns how many these
  /// are: what is due by its budget, but not what its planes still keep out, which gets a later
  /// budget. There are no branches but the loops, because nothing of it can be predicted.
  template <typename Planes>
  HWY_NOINLINE std::size_t find_due(const std::vector<Planes>& planes,
                                    std::vector<float>& budgets) const {
    const std::size_t size = list_due(budgets);
    std::uint32_t* const due = state_.due.data();
    std::size_t open = 0;
    for (std::size_t i = 0; i < size; ++i) {
      fetch(planes[due[std::min(i + kPlanesAhead, size - 1)]]);
      const std::uint32_t index = due[i];
      const float later =
          budget_after(outlook_[planes[index].query.tested_side].lasts(planes[index]));
      // NaN compares false, so that it is due. A budget beyond `due` implies a gap above `limit`.
      const std::uint32_t kept = later > look_ahead_.due;
      budgets[index] = chosen(kept, later, budgets[index]);
      due[open] = index;
      open += 1 - kept;
    }
    return open;
  }

  template <typename Object>
  HWY_INLINE static void fetch(const Object& object) {
    constexpr std::size_t kLine = 64;
    for (std::size_t i = 0; i < sizeof(Object); i += kLine)
      hwy::Prefetch(reinterpret_cast<const char*>(&object) + i);
  }

  /// Lists the indices of all budgets that are spent.
  HWY_NOINLINE std::size_t list_due(const std::vector<float>& budgets) const {
    const hn::ScalableTag<float> tag;
    const hn::RebindToUnsigned<decltype(tag)> indices;
    const std::size_t lanes = hn::Lanes(tag);
    const std::size_t size = budgets.size();
    if (state_.due.size() < size + lanes) state_.due.resize(2 * size + lanes);
    std::uint32_t* const list = state_.due.data();
    std::size_t count = 0;
    std::size_t i = 0;
    for (; i + lanes <= size; i += lanes) {
      const auto is_due = hn::Le(hn::LoadU(tag, budgets.data() + i), hn::Set(tag, look_ahead_.due));
      count += hn::CompressStore(hn::Iota(indices, static_cast<std::uint32_t>(i)),
                                 hn::RebindMask(indices, is_due), indices, list + count);
    }
    for (; i < size; ++i) {
      list[count] = static_cast<std::uint32_t>(i);
      count += budgets[i] <= look_ahead_.due;
    }
    return count;
  }

  float budget_after(float lasts) const {
    // Rounded down: the sum is not negative where it matters.
    return (moved_ + lasts) * kRoundDown;
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
  WideFront::Planes<bounds>& planes_;
  const WideFront::Pass& pass_;
  FrontHorizon must_;
  FrontHorizon look_ahead_;
  float moved_;         ///< the motion spent, rounded down
  Outlook outlook_[2];  ///< by the side of the tested node
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
