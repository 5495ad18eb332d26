// Which children a walk looks at next. Included once for each SIMD target.

#if defined(GRAZE_BVH_CHILD_REFS) == defined(HWY_TARGET_TOGGLE)
#ifdef GRAZE_BVH_CHILD_REFS
#undef GRAZE_BVH_CHILD_REFS
#else
#define GRAZE_BVH_CHILD_REFS
#endif

#include <graze/bvh/wide/lanes/query_box-inl.h>
#include <graze/bvh/wide/tree/wide_tree.h>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace graze::bvh::HWY_NAMESPACE {
namespace {

/// Whether the first of two children, which have these links, is the one to open: the larger one
/// is, unless it is a leaf. `scale` is the unit of the second one's tree in that of the first
/// one's.
HWY_INLINE bool is_first_opened(const WideChildRef& first, std::uint32_t first_link,
                                const WideChildRef& second, std::uint32_t second_link,
                                float scale) {
  return ChildLink::is_leaf(second_link) ||
         (!ChildLink::is_leaf(first_link) && size_of(first) >= size_of(second) * scale);
}

/// The first lane of the node that a link leads to.
HWY_INLINE WideChildRef first_below(const WideTree& tree, const WideChildRef& child,
                                    std::uint32_t link, TreeletCounts& counts) {
  const std::uint32_t index = ChildLink::index(link);
  if (!ChildLink::is_treelet(link)) return {child.node + index, 0, child.treelet};
  return {tree.entered(index, counts).nodes.data(), 0, index};
}

/// The one of these lanes that has the largest key: what is pushed first is looked at last.
HWY_INLINE std::uint32_t farthest(std::uint32_t lanes, const float* keys) {
  auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
  for (std::uint32_t rest = lanes & (lanes - 1); rest != 0; rest &= rest - 1) {
    const auto other = static_cast<std::uint32_t>(std::countr_zero(rest));
    if (keys[other] > keys[lane]) lane = other;
  }
  return lane;
}

HWY_INLINE std::uint32_t nearest(std::uint32_t lanes, const float* keys) {
  auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
  for (std::uint32_t rest = lanes & (lanes - 1); rest != 0; rest &= rest - 1) {
    const auto other = static_cast<std::uint32_t>(std::countr_zero(rest));
    if (keys[other] < keys[lane]) lane = other;
  }
  return lane;
}

}  // namespace
}  // namespace graze::bvh::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
