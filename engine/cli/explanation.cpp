#include <graze/engine/cli/explanation.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/derived/triangle_distance.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <limits>

namespace graze::cli {
namespace {

constexpr std::array kAxisNames = {"x", "y", "z"};

/// The gap of two placed boxes along a direction of length one.
double gap_along(const Eigen::Vector3d& axis, const PlacedMesh& a, const PlacedMesh& b) {
  const auto middle = [](const PlacedMesh& mesh) -> Eigen::Vector3d {
    const Aabb& box = mesh.mesh.bounds();
    return place(mesh.pose, Eigen::Vector3d(box.min / 2 + box.max / 2));
  };
  const auto reach = [&](const PlacedMesh& mesh) {
    const Eigen::Vector3d half = mesh.mesh.bounds().max / 2 - mesh.mesh.bounds().min / 2;
    return (mesh.pose.linear().transpose() * axis).cwiseAbs().dot(half);
  };
  return std::abs(axis.dot(middle(b) - middle(a))) - reach(a) - reach(b);
}

/// Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996: the fifteen directions in which two boxes
/// can be apart. Computed in double, for people to read; no answer comes from here.
BoxAxis widest_axis(const PlacedMesh& a, const PlacedMesh& b) {
  BoxAxis best{"", Eigen::Vector3d::UnitX(), -std::numeric_limits<double>::infinity()};
  const auto offer = [&](const std::string& name, const Eigen::Vector3d& direction) {
    const double length = direction.norm();
    if (length < 1e-6) return;  // parallel edges name no axis of their own
    const Eigen::Vector3d unit = direction / length;
    const double gap = gap_along(unit, a, b);
    if (gap > best.gap) best = {name, unit, gap};
  };
  for (int i = 0; i < 3; ++i)
    offer(fmt::format("{} of A", kAxisNames[static_cast<std::size_t>(i)]), a.pose.linear().col(i));
  for (int j = 0; j < 3; ++j)
    offer(fmt::format("{} of B", kAxisNames[static_cast<std::size_t>(j)]), b.pose.linear().col(j));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      offer(fmt::format("{} of A cross {} of B", kAxisNames[static_cast<std::size_t>(i)],
                        kAxisNames[static_cast<std::size_t>(j)]),
            a.pose.linear().col(i).cross(b.pose.linear().col(j)));
    }
  }
  return best;
}

const char* name_of(narrowphase::Stage stage) {
  return stage == narrowphase::Stage::Triage ? "the rounded stage, whose error bound sufficed"
                                             : "the exact stage: rounding left it unsure";
}

std::string point_text(const Eigen::Vector3d& p) {
  return fmt::format("({:.17g}, {:.17g}, {:.17g})", p.x(), p.y(), p.z());
}

std::string point_json(const Eigen::Vector3d& p) {
  return fmt::format("[{},{},{}]", p.x(), p.y(), p.z());
}

std::string work_json(const Work& work) {
  return fmt::format(
      "{{\"volume_tests\":{},\"volume_rejections\":{},\"triangle_tests\":{},\"exact_tests\":{},"
      "\"trees_built\":{}}}",
      work.volume_tests, work.volume_rejections, work.triangle_tests, work.exact_tests,
      work.trees_built);
}

std::string decision_text(const Explanation& e) {
  if (e.intersects) {
    return fmt::format(
        "  decided by       triangle {} of A and {} of B\n"
        "  at               {}\n"
        "  witness point    {} m\n",
        e.pair.a, e.pair.b, name_of(e.stage), point_text(e.point_a));
  }
  std::string text;
  const Work& work = e.volumes.front().work;
  if (work.triangle_tests == 0) {
    text += "  decided by       bounding volumes alone: no pair of triangles was tested\n";
  } else {
    text += "  decided by       volumes for most, and a triangle test for each pair left over\n";
  }
  return text + fmt::format(
                    "  came closest     triangle {} of A and {} of B, {:.6g} m apart\n"
                    "  at               {}\n"
                    "  nearest points   {} m\n"
                    "                   {} m\n"
                    "  separating axis  {}\n",
                    e.pair.a, e.pair.b, e.gap, name_of(e.stage), point_text(e.point_a),
                    point_text(e.point_b), point_text(*e.axis));
}

}  // namespace

Explanation explain(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b) {
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
    // Scaled first, so that a gap near the smallest double still has a direction.
    const Eigen::Vector3d way = nearest.point_b - nearest.point_a;
    const double largest = way.cwiseAbs().maxCoeff();
    result.axis = largest > 0 ? Eigen::Vector3d((way / largest).normalized())
                              : widest_axis(mesh_a, mesh_b).direction;
  }
  result.widest = widest_axis(mesh_a, mesh_b);
  result.all_pairs = static_cast<double>(mesh_a.mesh.triangles().size()) *
                     static_cast<double>(mesh_b.mesh.triangles().size());
  for (const Volume volume : kVolumes) {
    intersects(mesh_a, mesh_b, {.volume = volume});  // fits what it needs
    Work work;
    intersects(mesh_a, mesh_b, {.volume = volume}, &work);
    result.volumes.push_back({volume, work});
  }
  return result;
}

std::string to_text(const Explanation& e) {
  std::string text = e.intersects ? "they intersect\n" : "they do not intersect\n";
  text += decision_text(e);
  text += fmt::format("  whole boxes      {} along {}, by {:.6g} m\n",
                      e.widest.gap > 0 ? "apart" : "overlap least", e.widest.name,
                      std::abs(e.widest.gap));
  text += fmt::format("  pairs there are  {:.0f}, of triangles\n", e.all_pairs);
  text += fmt::format("\n{:<14}{:>14}{:>14}{:>16}{:>14}\n", "volume", "volume tests", "found apart",
                      "triangle tests", "exact tests");
  for (const VolumeWork& each : e.volumes) {
    text += fmt::format("{:<14}{:>14}{:>14}{:>16}{:>14}\n", graze::name_of(each.volume),
                        each.work.volume_tests, each.work.volume_rejections,
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
