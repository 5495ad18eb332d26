#pragma once

#include <graze/narrowphase/first_contact.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace graze::benchmark {

/// A point and a triangle, or two edges, of four points on straight paths.
struct MotionQuery {
  bool is_edges = false;
  PointPath point = {};
  TrianglePath triangle = {};
  EdgePath edge_a = {};
  EdgePath edge_b = {};
  std::optional<bool> is_hit = {};  ///< as a file says

  static MotionQuery of(const PointPath (&path)[4], bool is_edges);

  std::optional<FirstContact> first_contact() const {
    return is_edges ? graze::first_contact(edge_a, edge_b) : graze::first_contact(point, triangle);
  }
};

struct MotionSet {
  std::string name;
  std::vector<MotionQuery> queries;
};

/// Queries made here: never in one plane, like those of two meshes in a step, and hard ones.
std::vector<MotionSet> made_sets(int count);

/// Every folder of `root` with files edge-edge/*.csv or vertex-face/*.csv: eight rows a query, the
/// four points at the start and then at the end, in rows of three pairs of numerators and
/// denominators and whether the query is a hit. Coordinates that are no doubles are rounded, and
/// what the file says of such a query is dropped.
std::vector<MotionSet> sets_of_folder(const std::filesystem::path& root);

}  // namespace graze::benchmark
