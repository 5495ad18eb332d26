// The times at which the hulls are no further apart than s are a closed set. Where a part of it
// begins after 0 the hulls are s apart, their distance is that of the pair of features that have
// the two nearest points inside of them, and it was larger before: so the gap of that pair, unless
// it is always zero, has a root there. If it is always zero the pair is always s apart, while its
// feet are inside: they come in through a feature that bounds one of the two, which is s away then,
// too. In the end it is two corners that are always s apart, and have been so at 0.

#include <graze/narrowphase/motion/long_roots.h>
#include <graze/narrowphase/motion/near_contact.h>
#include <graze/narrowphase/motion/near_features.h>

namespace graze::narrowphase {
namespace {

/// True if the feet are inside; `sign_of(f)` is the sign of a polynomial at the time in question.
template <typename SignOf>
bool has_feet_inside(const NearFeature& feature, const SignOf& sign_of) {
  if (sign_of(feature.size) != Sign::Positive) return false;
  for (const LongPolynomial& inside : feature.inside) {
    if (sign_of(inside) == Sign::Negative) return false;
  }
  return true;
}

template <typename SignOf>
bool are_any_near(const std::vector<NearFeature>& features, const SignOf& sign_of) {
  for (const NearFeature& feature : features) {
    if (sign_of(feature.gap) != Sign::Positive && has_feet_inside(feature, sign_of)) return true;
  }
  return false;
}

}  // namespace

std::optional<FirstContact> near_contact_exactly(const FourPaths& paths,
                                                 const FirstContactSettings& settings) {
  const std::vector<NearFeature> features = near_features_of(paths, settings.clearance);
  const bool are_near_at_start =
      are_any_near(features, [](const LongPolynomial& f) { return f.sign_at_start(); });
  if (are_near_at_start && settings.start == StartContact::Counts) return FirstContact{0, true};
  std::optional<FirstContact> first;
  for (const NearFeature& feature : features) {
    LongPolynomial simple;
    for (LongRoot& root : long_roots_of(feature.gap, simple)) {
      const double time = root.rounded_down();
      if (first && first->time <= time) break;
      if (!has_feet_inside(feature, [&](const LongPolynomial& f) { return root.sign_of(f); }))
        continue;
      // The part of the times that holds 0 is left out: all that was near just before is in it, or
      // what begins here would have begun there.
      const auto sign_before = [&](const LongPolynomial& f) { return root.sign_before(f); };
      if (are_near_at_start && are_any_near(features, sign_before)) continue;
      first = FirstContact{time, false};
      break;
    }
  }
  return first;
}

std::optional<FirstContact> near_contact(const FourPaths& paths,
                                         const FirstContactSettings& settings, double until) {
  if (are_surely_further(paths, settings.clearance, until)) return std::nullopt;
  return near_contact_exactly(paths, settings);
}

}  // namespace graze::narrowphase
