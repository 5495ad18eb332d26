// This finds the largest gap between a query box and each of some children of a tested node, with
// the direction along which it is, for a front. It is included once for each SIMD target.

#if defined(GRAZE_BVH_BOX_GAPS) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_BOX_GAPS
#undef GRAZE_BVH_BOX_GAPS
#else
#define GRAZE_BVH_BOX_GAPS
#endif

#include <graze/bvh/wide/front/front_planes.h>
#include <graze/bvh/wide/front/plane_store-inl.h>
#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <graze/bvh/wide/lanes/query_gaps-inl.h>
#include <graze/bvh/wide/lanes/slab_lanes-inl.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// The gaps between some children of a tested node and a query box, along the axes of the tested
/// node.
///
/// The 15 axes are those of bvh/value/separating_axes.h, which derives the test of two boxes along
/// them. The code is another one because it asks for more than a yes: the largest gap over all
/// axes, with the direction along which it is, of eight boxes at once and in float.
class BoxGaps {
 public:
  HWY_INLINE BoxGaps(const WideNode& tested, const QueryInNode& query, std::size_t lane)
      : tested_(tested), query_(query) {
    const Tag tag;
    Lanes apart[3], turned[3];
    Lanes square = hn::Zero(tag);
    squared_distance_ = square;
    for (int i = 0; i < 3; ++i) {
      half_[i] = hn::Load(tag, tested.half[i] + lane);
      offset_[i] = hn::Sub(hn::Set(tag, query.offset[i]), hn::Load(tag, tested.centre[i] + lane));
      const Lanes size = hn::Abs(offset_[i]);
      const Lanes gap = known(tag, hn::Sub(size, hn::Add(half_[i], hn::Set(tag, query.radius[i]))));
      apart[i] = hn::CopySign(gap, offset_[i]);
      square = hn::MulAdd(gap, gap, square);
      const Lanes farthest = hn::Add(size, hn::Add(half_[i], hn::Set(tag, query.radius[i])));
      squared_distance_ = hn::MulAdd(farthest, farthest, squared_distance_);
      turned[i] = hn::Zero(tag);
    }
    best_.consider_sum(square, apart);
    square = hn::Zero(tag);
    for (int k = 0; k < 3; ++k) {
      const Lanes distance =
          hn::MulAdd(offset_[0], axis(k, 0),
                     hn::MulAdd(offset_[1], axis(k, 1), hn::Mul(offset_[2], axis(k, 2))));
      const Lanes radii =
          hn::MulAdd(half_[0], size(k, 0),
                     hn::MulAdd(half_[1], size(k, 1),
                                hn::MulAdd(half_[2], size(k, 2), hn::Set(tag, query.half[k]))));
      const Lanes gap = known(tag, hn::Sub(hn::Abs(distance), radii));
      const Lanes along = hn::CopySign(gap, distance);
      square = hn::MulAdd(gap, gap, square);
      for (int i = 0; i < 3; ++i)
        turned[i] = hn::MulAdd(along, axis(k, i), turned[i]);
    }
    best_.consider_sum(square, turned);
  }

  /// Looks along cross products of axes, which are no longer than 1.
  HWY_INLINE void look_across() {
    const Tag tag;
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        const Lanes distance =
            hn::MulSub(offset_[i2], axis(k, i1), hn::Mul(offset_[i1], axis(k, i2)));
        const Lanes radii =
            hn::MulAdd(half_[i1], size(k, i2),
                       hn::MulAdd(half_[i2], size(k, i1), hn::Set(tag, query_.cross_radius[k][i])));
        const Lanes gap = hn::Sub(hn::Abs(distance), radii);
        const auto is_back = hn::Lt(distance, hn::Zero(tag));
        Lanes normal[3];
        normal[i] = hn::Zero(tag);
        normal[i1] = hn::IfThenElse(is_back, axis(k, i2), hn::Neg(axis(k, i2)));
        normal[i2] = hn::IfThenElse(is_back, hn::Neg(axis(k, i1)), axis(k, i1));
        best_.consider(known(tag, gap), hn::Set(tag, 1.0f), normal);
      }
    }
  }

  /// Looks along the normals of the slabs of the tested node's children. A child about which
  /// anything else was proved is left out: where boxes overlap along all their axes no offset of
  /// middles is longer than both boxes.
  HWY_INLINE void look_along_slabs(std::size_t lane, const QuerySlab& slab) {
    const Tag tag;
    const SlabLanes slabs(tested_, lane, half_);
    const SlabGap found(slabs, offset_, OneQuery{query_}, slab);
    const Lanes sign = hn::CopySign(hn::Set(tag, 1.0f), found.distance);
    const Lanes normal[3] = {hn::Mul(sign, slabs.slope[0]), hn::Mul(sign, slabs.slope[1]), sign};
    const Lanes gap = known(tag, hn::Sub(hn::Abs(found.distance), found.radii));
    best_.consider_along(hn::IfThenZeroElse(are_apart(), gap), normal);
  }

  HWY_INLINE hn::Mask<Tag> are_apart() const { return best_.is_any(); }

  HWY_INLINE void look_along(const Aim& aim) {
    const Tag tag;
    Lanes along = hn::Zero(tag);
    Lanes radii = hn::Set(tag, aim.radius);
    for (int i = 0; i < 3; ++i) {
      along = hn::MulAdd(offset_[i], hn::Set(tag, aim.axes[i]), along);
      radii = hn::MulAdd(half_[i], hn::Set(tag, aim.size[i]), radii);
    }
    const Lanes gap = known(tag, hn::Sub(along, radii));
    const Lanes axes[3] = {hn::Set(tag, aim.axes[0]), hn::Set(tag, aim.axes[1]),
                           hn::Set(tag, aim.axes[2])};
    best_.consider(gap, hn::Set(tag, 1.0f), axes);
  }

  /// Stores what was found, in the frame of the tested node's tree, in common units.
  template <FrontKind kind>
  HWY_INLINE void store(FrontPlanes<WideNode::kWidth, kind>& planes,
                        FoundPlanes<WideNode::kWidth>& found, std::size_t lane,
                        float unit_of_tested) const {
    const Tag tag;
    Lanes normal[3];
    Lanes turned[3];
    const Lanes gap = PlaneStore<kind>::best_of(best_, normal);
    for (int i = 0; i < 3; ++i) {
      turned[i] = hn::MulAdd(normal[0], hn::Set(tag, tested_.axes[i][0]),
                             hn::MulAdd(normal[1], hn::Set(tag, tested_.axes[i][1]),
                                        hn::Mul(normal[2], hn::Set(tag, tested_.axes[i][2]))));
    }
    PlaneStore<kind>::write(tag, planes, found, lane, gap, turned, squared_distance_,
                            unit_of_tested);
  }

 private:
  HWY_INLINE Lanes axis(int k, int i) const { return hn::Set(Tag(), query_.axes[k][i]); }
  HWY_INLINE Lanes size(int k, int i) const { return hn::Set(Tag(), query_.size[k][i]); }

  const WideNode& tested_;
  const QueryInNode& query_;
  Lanes half_[3];
  Lanes offset_[3];
  Lanes squared_distance_;  ///< the square of a distance than which no two points of both boxes are
                            ///< further apart
  BestGap<Tag> best_;
};

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
