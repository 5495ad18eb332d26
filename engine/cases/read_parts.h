#pragma once

// How the parts of a case are read. Private to engine/cases.

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

#include <graze/engine/cases/case.h>
#include <graze/engine/cases/json_cursor.h>

namespace graze::cases {

/// The two shapes of a case, of which one may say that its mesh is the other's.
struct CaseShapes {
  CaseShape a;
  std::optional<CaseShape> b;
};

CaseShapes read_shapes(const JsonCursor& root, bool has_b, const std::filesystem::path& folder);

/// Requires the parts that the question asks for, and refuses others.
CaseAnswer read_answer(const JsonCursor& at, Ask ask, bool has_volume_b);

Pose read_pose(const JsonCursor& at);

/// How the shape of a body is read: a scene has units, and meshes in files.
struct BodyShapeReader {
  std::function<double(const JsonCursor&)> length;
  std::function<Mesh(const JsonCursor&)> mesh;
};

/// The one shape, of any kind that bodies have, that the object `at` describes by a member of that
/// kind's name. Its other members are the caller's.
Shape read_body_shape(const JsonCursor& at, const BodyShapeReader& reader);

/// A mesh by its vertices and triangles.
Mesh read_inline_mesh(const JsonCursor& at);

}  // namespace graze::cases
