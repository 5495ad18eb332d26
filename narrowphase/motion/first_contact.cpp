#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/narrowphase/crossing.h>
#include <graze/narrowphase/first_contact.h>
#include <graze/narrowphase/motion/contact_stages.h>
#include <graze/narrowphase/motion/near_contact.h>
#include <graze/narrowphase/motion/path_checks.h>
#include <graze/narrowphase/motion/rounded_contact.h>
#include <graze/narrowphase/triangle_pair/crossing_stages.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

namespace graze {
namespace narrowphase {
namespace {

Triangle at_start(const TrianglePath& path) {
  return {path.a.start, path.b.start, path.c.start};
}

void take_earlier(std::optional<FirstContact>& first, const std::optional<FirstContact>& other) {
  if (!other || (first && first->time < other->time)) return;
  if (first && first->time == other->time && first->is_at_start) return;
  first = other;
}

}  // namespace

namespace {

FirstContact at_root(const FourPaths& paths, const PathLanes& lanes, const RoundedAnswer& answer) {
  const std::optional<double> time = root_rounded_down(lanes, paths.kind, answer);
  return {time ? *time : root_rounded_down_exactly(paths, answer), false};
}

}  // namespace

namespace {

/// Decides what the first look in rounded arithmetic leaves open. It is not inlined, as most
/// queries end before.
[[gnu::noinline]] std::optional<FirstContact> contact_after(const RoundedAnswer& answer,
                                                            const FourPaths& paths,
                                                            const PathLanes& lanes,
                                                            const FirstContactSettings& settings,
                                                            double until) {
  if (answer.kind == RoundedContact::Root) return at_root(paths, lanes, answer);
  if (answer.kind == RoundedContact::Unsure)
    return first_contact_exactly(paths, settings, answer.low);
  const PathLanes scaled = lanes.in_own_units();
  const RoundedAnswer again = rounded_contact(scaled, paths.kind, until);
  if (again.kind == RoundedContact::None) return std::nullopt;
  if (again.kind == RoundedContact::Root) return at_root(paths, scaled, again);
  return first_contact_exactly(paths, settings, again.low);
}

template <typename A, typename B>
std::optional<FirstContact> contact_of(const A& a, const B& b, const PathLanes& lanes,
                                       const FirstContactSettings& settings, double until) {
  const RoundedAnswer answer = rounded_contact(lanes, kind_of(a, b), until);
  if (answer.kind == RoundedContact::None) return std::nullopt;
  return contact_after(answer, FourPaths(a, b), lanes, settings, until);
}

}  // namespace

std::optional<FirstContact> first_contact_of(const PointPath& point, const TrianglePath& triangle,
                                             const FirstContactSettings& settings, double until) {
  if (settings.clearance > 0) return near_contact(FourPaths(point, triangle), settings, until);
  return contact_of(point, triangle, PathLanes(point, triangle), settings, until);
}

std::optional<FirstContact> first_contact_of(const EdgePath& a, const EdgePath& b,
                                             const FirstContactSettings& settings, double until) {
  if (settings.clearance > 0) return near_contact(FourPaths(a, b), settings, until);
  return contact_of(a, b, PathLanes(a, b), settings, until);
}

std::optional<FirstContact> first_contact_of(const TrianglePath& a, const TrianglePath& b,
                                             const FirstContactSettings& settings) {
  const bool is_hit_at_start = settings.start == StartContact::Counts
                                   ? decide(at_start(a), at_start(b)).is_hit
                                   : crosses(at_start(a), at_start(b));
  if (is_hit_at_start) return FirstContact{0, true};
  const PointPath* const corners_a[3] = {&a.a, &a.b, &a.c};
  const PointPath* const corners_b[3] = {&b.a, &b.b, &b.c};
  std::optional<FirstContact> first;
  const auto until = [&] { return first ? first->time : 1; };
  for (int i = 0; i < 3; ++i) {
    take_earlier(first, first_contact_of(*corners_a[i], b, settings, until()));
    take_earlier(first, first_contact_of(*corners_b[i], a, settings, until()));
    for (int k = 0; k < 3; ++k) {
      const EdgePath edge_a{*corners_a[i], *corners_a[(i + 1) % 3]};
      const EdgePath edge_b{*corners_b[k], *corners_b[(k + 1) % 3]};
      take_earlier(first, first_contact_of(edge_a, edge_b, settings, until()));
    }
  }
  return first;
}

namespace {

/// Checks coordinates one by one only where their sum is not finite: it may have overflowed.
template <typename A, typename B>
std::optional<FirstContact> checked_contact(const A& a, const B& b,
                                            const FirstContactSettings& settings,
                                            std::size_t number) {
  const PathLanes lanes(a, b);
  if (!lanes.are_surely_finite()) check_paths(a, b, number);
  if (settings.clearance > 0) return near_contact(FourPaths(a, b), settings);
  return contact_of(a, b, lanes, settings, 1);
}

std::optional<FirstContact> checked_contact(const TrianglePath& a, const TrianglePath& b,
                                            const FirstContactSettings& settings,
                                            std::size_t number) {
  check_paths(a, b, number);
  return first_contact_of(a, b, settings);
}

template <typename A, typename B>
std::optional<FirstContact> door(const A& a, const B& b, const FirstContactSettings& settings) {
  return bvh::in_standard_arithmetic([&]() -> std::optional<FirstContact> {
    check_settings(settings);
    return checked_contact(a, b, settings, kNoNumber);
  });
}

template <typename A, typename B>
void door(std::span<const A> a, std::span<const B> b,
          std::span<std::optional<FirstContact>> contacts, const FirstContactSettings& settings) {
  bvh::in_standard_arithmetic([&] {
    check_settings(settings);
    check_lengths(a.size(), b.size(), contacts.size());
    for (std::size_t i = 0; i < contacts.size(); ++i)
      contacts[i] = checked_contact(a[i], b[i], settings, i);
  });
}

}  // namespace
}  // namespace narrowphase

std::optional<FirstContact> first_contact(const PointPath& point, const TrianglePath& triangle,
                                          const FirstContactSettings& settings) {
  return narrowphase::door(point, triangle, settings);
}

std::optional<FirstContact> first_contact(const EdgePath& edge_a, const EdgePath& edge_b,
                                          const FirstContactSettings& settings) {
  return narrowphase::door(edge_a, edge_b, settings);
}

std::optional<FirstContact> first_contact(const TrianglePath& triangle_a,
                                          const TrianglePath& triangle_b,
                                          const FirstContactSettings& settings) {
  return narrowphase::door(triangle_a, triangle_b, settings);
}

void first_contacts(std::span<const PointPath> points, std::span<const TrianglePath> triangles,
                    std::span<std::optional<FirstContact>> contacts,
                    const FirstContactSettings& settings) {
  narrowphase::door(points, triangles, contacts, settings);
}

void first_contacts(std::span<const EdgePath> edges_a, std::span<const EdgePath> edges_b,
                    std::span<std::optional<FirstContact>> contacts,
                    const FirstContactSettings& settings) {
  narrowphase::door(edges_a, edges_b, contacts, settings);
}

void first_contacts(std::span<const TrianglePath> triangles_a,
                    std::span<const TrianglePath> triangles_b,
                    std::span<std::optional<FirstContact>> contacts,
                    const FirstContactSettings& settings) {
  narrowphase::door(triangles_a, triangles_b, contacts, settings);
}

}  // namespace graze
