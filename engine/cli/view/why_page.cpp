#include <graze/engine/cli/reports/why_page.h>

#include <graze/engine/cli/view/case_pictures.h>
#include <graze/engine/cli/view/shown_pair.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

namespace graze::cli {
namespace {

/// Returns an extent as large as the larger of two triangles.
double extent_of(const Triangle& a, const Triangle& b) {
  double longest = 0;
  for (const Triangle* triangle : {&a, &b}) {
    const std::array<Eigen::Vector3d, 3> sides = {
        triangle->b - triangle->a, triangle->c - triangle->b, triangle->a - triangle->c};
    for (const Eigen::Vector3d& side : sides)
      longest = std::max(longest, side.stableNorm());
  }
  return longest;
}

/// Shows the two triangles that decide, and what proves it.
void show_deciding(const PlacedMeshView& a, const PlacedMeshView& b, const ShownBodies& bodies,
                   const Explanation& why, ShownPage& page) {
  View& view = page.view;
  view.begin_frame({.label = fmt::format("triangles {} and {} decide", why.pair.a, why.pair.b),
                    .state = why.intersects ? ViewState::Touching : ViewState::Clear,
                    .facts = {{"gap of these two", why.gap, true}},
                    .note = why.intersects
                                ? "The point is in both triangles, which is proved."
                                : "No two triangles are nearer: the plane parts these."});
  ++page.frames;
  view.place(bodies.a, a.pose);
  view.place(bodies.b, b.pose);
  const std::array<std::uint32_t, 1> of_a = {why.pair.a}, of_b = {why.pair.b};
  view.mark_triangles(bodies.a, of_a);
  view.mark_triangles(bodies.b, of_b);
  if (why.intersects) {
    view.add_point(why.point_a);
    view.add_label(why.point_a, "in both");
    return;
  }
  view.add_gap(why.point_a, why.point_b, why.gap);
  const double extent = extent_of(a.mesh.triangle(why.pair.a), b.mesh.triangle(why.pair.b));
  if (why.axis && extent > 0)
    view.add_plane(
        {.point = why.point_a / 2 + why.point_b / 2, .normal = *why.axis, .half_extent = extent});
}

}  // namespace

std::string why_page(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b,
                     const std::string& name_a, const std::string& name_b,
                     const Explanation& explanation) {
  ShownPage page({.title = name_a + ", " + name_b});
  const ShownBodies bodies = {page.view.add(mesh_a.mesh, {.name = name_a}),
                              page.view.add(mesh_b.mesh, {.name = name_b})};
  show_pair(mesh_a, mesh_b, bodies, {.label = "all triangles"}, page);
  show_deciding(mesh_a, mesh_b, bodies, explanation, page);
  return page.view.page();
}

std::string why_page(const Case& query, const std::string& name,
                     const CaseExplanation& explanation) {
  ShownPage page({.title = name});
  ListedCase listed = {.name = name, .query = query};
  listed.query.note = fmt::format("{} says {}, the truth is {}. {}", explanation.engine,
                                  explanation.says, explanation.judgement.truth, explanation.why);
  show_case(listed, page);
  for (const std::string& reason : explanation.reasons.value_or(Reasons()))
    page.view.add_note(reason);
  return page.view.page();
}

}  // namespace graze::cli
