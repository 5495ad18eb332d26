#include <graze/engine/cli/reports/explanation.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_distance.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <fmt/format.h>
#include <cmath>

namespace graze::cli {
namespace {

const char* name_of(narrowphase::Stage stage) {
  return stage == narrowphase::Stage::Triage ? "the rounded stage, whose error bound sufficed"
                                             : "the exact stage: rounding left it unsure";
}

const char* name_of(Decider decider) {
  switch (decider) {
    case Decider::MeshBoxes:
      return "boxes of the meshes";
    case Decider::Volumes:
      return "volumes";
    case Decider::Leaves:
      return "leaves";
    case Decider::Triangles:
      return "triangles";
    case Decider::Exact:
      return "exact";
  }
  return "";
}

/// Returns the last stage that had to be asked.
Decider decider_of(const Work& work) {
  if (work.exact_tests > 0) return Decider::Exact;
  if (work.triangle_tests > 0) return Decider::Triangles;
  if (work.filter_tests > 0) return Decider::Leaves;
  return work.volume_tests > 1 ? Decider::Volumes : Decider::MeshBoxes;
}

std::string miss_text(Decider decider, const Work& work) {
  switch (decider) {
    case Decider::MeshBoxes:
      return "the boxes around the meshes alone, which are apart";
    case Decider::Volumes:
      return "bounding volumes alone: no pair of triangles was looked at";
    case Decider::Leaves:
      return fmt::format(
          "bounding volumes, and bounds of the gaps of {} pairs of triangles in leaves",
          work.filter_tests);
    case Decider::Triangles:
      return fmt::format(
          "bounding volumes, and tests of {} pairs of triangles, all sure in rounded arithmetic",
          work.triangle_tests);
    case Decider::Exact:
      return fmt::format(
          "bounding volumes, and tests of {} pairs of triangles, {} of them exact: rounding "
          "left these unsure",
          work.triangle_tests, work.exact_tests);
  }
  return "";
}

std::string point_text(const Eigen::Vector3d& p) {
  return fmt::format("({:.17g}, {:.17g}, {:.17g})", p.x(), p.y(), p.z());
}

std::string point_json(const Eigen::Vector3d& p) {
  return fmt::format("[{},{},{}]", p.x(), p.y(), p.z());
}

std::string work_json(const Work& work) {
  return fmt::format(
      "{{\"volume_tests\":{},\"volume_rejections\":{},\"filter_tests\":{},\"triangle_tests\":{},"
      "\"exact_tests\":{},\"trees_built\":{}}}",
      work.volume_tests, work.volume_rejections, work.filter_tests, work.triangle_tests,
      work.exact_tests, work.trees_built);
}

std::string decision_text(const Explanation& e) {
  if (e.intersects) {
    return fmt::format(
        "  decided by       triangle {} of A and {} of B\n"
        "  at               {}\n"
        "  witness point    {} m\n",
        e.pair.a, e.pair.b, name_of(e.stage), point_text(e.point_a));
  }
  std::string text =
      fmt::format("  decided by       {}\n", miss_text(e.decider, e.volumes.front().work));
  text += fmt::format("  came closest     triangle {} of A and {} of B, {:.6g} m apart\n", e.pair.a,
                      e.pair.b, e.gap);
  if (e.boxes) {
    text += fmt::format(
        "  apart already    the boxes with these among {} triangles of A and {} of B,\n"
        "                   along {}, by {:.6g} m\n",
        e.boxes->triangles_a, e.boxes->triangles_b, e.boxes->axis.name, e.boxes->axis.gap);
  } else {
    text += "  apart already    no boxes that hold these: those of the leaves overlap\n";
  }
  text += fmt::format(
      "  a test of them   is sure at {}\n"
      "  nearest points   {} m\n"
      "                   {} m\n"
      "  separating axis  {}\n",
      name_of(e.stage), point_text(e.point_a), point_text(e.point_b), point_text(*e.axis));
  if (e.solids) {
    text += *e.solids == Solids::Meet
                ? "  as solids        they intersect: a part of one lies inside the other\n"
                : "  as solids        they do not intersect either\n";
  }
  return text;
}

}  // namespace

Explanation explain(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b) {
  Explanation result;
  result.intersects = intersects(mesh_a, mesh_b, &result.first);
  if (result.intersects) {
    result.pair = find_triangle_pairs(mesh_a, mesh_b, {.limit = 1})[0];
  } else {
    result.pair = distance(mesh_a, mesh_b).pair;
  }
  const Triangle a = place(mesh_a.pose, mesh_a.mesh.triangle(result.pair.a));
  const Triangle b = place(mesh_b.pose, mesh_b.mesh.triangle(result.pair.b));
  result.stage = narrowphase::decide(a, b).stage;
  const TriangleDistance nearest = distance(a, b);
  result.point_a = nearest.point_a;
  result.point_b = nearest.point_b;
  result.gap = nearest.distance;
  if (!result.intersects) {
    // It is scaled first, so that a gap near the smallest double still has a direction.
    const Eigen::Vector3d offset = nearest.point_b - nearest.point_a;
    const double largest = offset.cwiseAbs().maxCoeff();
    result.axis = largest > 0 ? Eigen::Vector3d((offset / largest).normalized())
                              : widest_axis(mesh_a, mesh_b).direction;
  }
  if (!result.intersects) {
    result.boxes = separated_boxes(mesh_a, mesh_b, result.pair);
    if (mesh_a.mesh.topology().is_closed && mesh_b.mesh.topology().is_closed) {
      result.solids =
          intersects(mesh_a, mesh_b, {.hit = Hit::Solid}) ? Solids::Meet : Solids::Apart;
    }
  }
  result.widest = widest_axis(mesh_a, mesh_b);
  result.all_pairs = static_cast<double>(mesh_a.mesh.triangles().size()) *
                     static_cast<double>(mesh_b.mesh.triangles().size());
  for (const PairVolume volume : kPairVolumes) {
    intersects(mesh_a, mesh_b, {.volume = volume});  // this fits the volumes that it needs
    Work work;
    intersects(mesh_a, mesh_b, {.volume = volume}, &work);
    result.volumes.push_back({volume, work});
  }
  result.decider = decider_of(result.volumes.front().work);
  return result;
}

std::string to_text(const Explanation& e) {
  std::string text = e.intersects ? "they intersect\n" : "they do not intersect\n";
  text += decision_text(e);
  text += fmt::format("  whole boxes      {} along {}, by {:.6g} m\n",
                      e.widest.gap > 0 ? "apart" : "overlap least", e.widest.name,
                      std::abs(e.widest.gap));
  text += fmt::format("  pairs there are  {:.0f}, of triangles\n", e.all_pairs);
  text += fmt::format("\n{:<14}{:>14}{:>14}{:>14}{:>16}{:>14}\n", "volume", "volume tests",
                      "found apart", "leaf bounds", "triangle tests", "exact tests");
  for (const VolumeWork& each : e.volumes) {
    text += fmt::format("{:<14}{:>14}{:>14}{:>14}{:>16}{:>14}\n", graze::name_of(each.volume),
                        each.work.volume_tests, each.work.volume_rejections, each.work.filter_tests,
                        each.work.triangle_tests, each.work.exact_tests);
  }
  text +=
      e.intersects
          ? "Below volumes found apart nothing is looked at; the search stops at the first hit.\n"
          : "Below volumes found apart nothing is looked at.\n";
  return text;
}

std::string to_json(const Explanation& e) {
  std::string out = fmt::format(
      "{{\"intersects\":{},\"pair\":[{},{}],\"stage\":\"{}\",\"point_a\":{},\"point_b\":{},\"gap\":"
      "{}",
      e.intersects, e.pair.a, e.pair.b, e.stage == narrowphase::Stage::Triage ? "rounded" : "exact",
      point_json(e.point_a), point_json(e.point_b), e.gap);
  if (e.axis) out += fmt::format(",\"axis\":{}", point_json(*e.axis));
  if (!e.intersects) out += fmt::format(",\"decided_by\":\"{}\"", name_of(e.decider));
  if (e.boxes) {
    out += fmt::format(
        ",\"boxes_apart\":{{\"triangles\":[{},{}],\"axis\":\"{}\",\"direction\":{},\"gap\":{}}}",
        e.boxes->triangles_a, e.boxes->triangles_b, e.boxes->axis.name,
        point_json(e.boxes->axis.direction), e.boxes->axis.gap);
  }
  if (e.solids) out += fmt::format(",\"solids_intersect\":{}", *e.solids == Solids::Meet);
  out += fmt::format(",\"boxes\":{{\"axis\":\"{}\",\"direction\":{},\"gap\":{}}},\"pairs\":{:.0f}",
                     e.widest.name, point_json(e.widest.direction), e.widest.gap, e.all_pairs);
  out += ",\"first_query\":" + work_json(e.first) + ",\"volumes\":{";
  const char* separator = "";
  for (const VolumeWork& each : e.volumes) {
    out += fmt::format("{}\"{}\":{}", separator, graze::name_of(each.volume), work_json(each.work));
    separator = ",";
  }
  return out + "}}\n";
}

}  // namespace graze::cli
