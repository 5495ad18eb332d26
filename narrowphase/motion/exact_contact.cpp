// The times of contact are a closed set, given by signs of polynomials. While the four points are
// not always in one plane, the set is some of the roots of the polynomial of degree three that is
// zero when they are. While they are always in one plane, a stretch of contact begins only when a
// corner comes to lie in an edge: before that, an inner point of a triangle stays one, and so does
// a point that two edges cross in. A corner on the line of an edge is a root of the area that the
// three have; if it is always on the line, it comes to the edge at an end, which is a root of the
// product of its offsets from the ends, axis by axis.

#include <graze/narrowphase/motion/contact_signs.h>
#include <graze/narrowphase/motion/contact_stages.h>
#include <graze/narrowphase/motion/root_sign.h>

namespace graze::narrowphase {
namespace {

template <typename Integer>
class ExactContact {
 public:
  ExactContact(const FourPaths& paths, const FirstContactSettings& settings, double from)
      : kind_(paths.kind),
        paths_(paths),
        is_start_left_(settings.start == StartContact::IsLeft),
        from_(from) {}

  std::optional<FirstContact> first() {
    const Polynomial volume = volume_of(paths_, kind_);
    is_always_flat_ = volume.degree < 0;
    if (from_ == 0 && (is_always_flat_ || volume.coefficient[0].is_zero())) {
      const Dyadic<Integer> start(0);
      does_touch_at_start_ =
          do_meet(paths_, kind_, [&](const Polynomial& f) { return sign_at(f, start); });
      if (does_touch_at_start_ && !is_start_left_) return FirstContact{0, true};
    }
    if (is_always_flat_) {
      for (int i = 0; i < (kind_ == PathPair::PointTriangle ? 3 : 4); ++i)
        try_corner(point_in_edges(kind_)[i]);
    } else {
      try_roots(volume);
    }
    return first_;
  }

 private:
  void try_corner(const PointInEdge& which) {
    for (int axis = 0; axis < 3; ++axis) {
      const Polynomial beside = beside_edge(paths_, which, axis);
      if (beside.degree >= 0) return try_roots(beside);
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Polynomial along = along_edge(paths_, which, axis);
      if (along.degree >= 0) try_roots(along);
    }
  }

  void try_roots(const Polynomial& f) {
    visit_roots<Integer>(f, from_, [&](Root<Integer>& root) { return try_root(root); });
  }

  /// True if contact begins at a root.
  bool try_root(Root<Integer>& root) {
    narrow(root);
    const double time = root.place.low.floor;
    if (first_ && first_->time <= time) return true;
    const bool is_at_start = time == 0 && root.place.is_one_time;
    if (is_at_start && is_start_left_) return false;
    const RootSigns<Integer> sign_of(root);
    if (!do_meet(paths_, kind_, sign_of)) return false;
    const bool may_be_left = is_always_flat_ && is_start_left_ && does_touch_at_start_;
    if (may_be_left &&
        do_meet(paths_, kind_, [&](const Polynomial& f) { return sign_before(f, sign_of); }))
      return false;
    first_ = FirstContact{time, is_at_start};
    return true;
  }

  PathPair kind_;
  ExactPaths paths_;
  bool is_start_left_;
  double from_;
  bool is_always_flat_ = false;
  bool does_touch_at_start_ = false;
  std::optional<FirstContact> first_;
};

/// This is not inlined: the frame of the one is not to hold the integers of the other.
template <typename Integer>
[[gnu::noinline]] std::optional<FirstContact> first_contact_in(const FourPaths& paths,
                                                               const FirstContactSettings& settings,
                                                               double from) {
  return ExactContact<Integer>(paths, settings, from).first();
}

}  // namespace

std::optional<FirstContact> first_contact_exactly(const FourPaths& paths,
                                                  const FirstContactSettings& settings,
                                                  double from) {
  try {
    return first_contact_in<BigInteger>(paths, settings, from);
  } catch (const CapacityExceeded&) {
    return first_contact_in<HugeInteger>(paths, settings, from);
  }
}

}  // namespace graze::narrowphase
