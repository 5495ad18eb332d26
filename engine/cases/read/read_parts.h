#pragma once

// Reads the parts of a case. Private to engine/cases.

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/cases/read_case.h>
#include <graze/engine/cases/text/json_cursor.h>

namespace graze::cases {

/// The two shapes of a case, of which one may say that its mesh is the other's.
struct CaseShapes {
  CaseShape a;
  std::optional<CaseShape> b;
};

CaseShapes read_shapes(const JsonCursor& root, bool has_b, const ReadCaseSettings& settings);

/// Requires the settings that the question needs, and refuses those of other questions.
CaseSettings read_settings(const JsonCursor& root, Ask ask);

/// Refuses settings that the query does not have with such shapes: they would be ignored.
void check_settings(const JsonCursor& root, const Case& query);

/// Reads where a body goes: any of its members may be missing, but those of a turn come together.
RigidCourse read_course(const JsonCursor& at);

/// Refuses motions of questions that ask for none, and those that the library refuses.
void check_motions(const JsonCursor& root, const Case& query);

/// Requires the parts that the question asks for about these shapes, and refuses others.
CaseAnswer read_answer(const JsonCursor& at, const Case& query);

/// Reads the answer of Ask::Intersection about two meshes. Refuses indices of points that are not
/// there.
CaseIntersection read_intersection(const JsonCursor& at);

/// Reads a number that is not negative.
double read_length(const JsonCursor& at);

/// Read two indices of triangles, and a list of such pairs that ascends.
TrianglePair read_pair(const JsonCursor& at);
std::vector<TrianglePair> read_pairs(const JsonCursor& at);

/// Calls `on_pairs` with each list of pairs.
template <typename OnPairs>
void for_each_pairs(const CaseIntersection& intersection, OnPairs&& on_pairs) {
  for (const CaseIntersection::Curve& curve : intersection.curves) {
    for (const CaseIntersection::Segment& segment : curve.segments)
      on_pairs(segment.pairs);
  }
  for (const std::vector<CaseIntersection::Polygon>& patch : intersection.patches) {
    for (const CaseIntersection::Polygon& polygon : patch)
      on_pairs(polygon.pairs);
  }
  for (const CaseIntersection::Touch& touch : intersection.touching_points)
    on_pairs(touch.pairs);
}

Pose read_pose(const JsonCursor& at);

/// Says how the shape of a body is read: a scene has units, and meshes in files.
struct BodyShapeReader {
  std::function<double(const JsonCursor&)> length;
  std::function<Mesh(const JsonCursor&)> mesh;
};

/// Reads the one shape, of any kind that bodies have, that the object `at` describes by a member of
/// that kind's name. Its other members are the caller's.
Shape read_body_shape(const JsonCursor& at, const BodyShapeReader& reader);

/// Reads a mesh by its vertices and triangles.
Mesh read_inline_mesh(const JsonCursor& at);

}  // namespace graze::cases
