#include <graze/bvh/error.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/mesh/rigid/motion_checks.h>
#include <graze/engine/world/shape_bounds.h>

namespace graze::cases {
namespace {

bool is_endless(const Shape& shape) {
  return shape.kind() == ShapeKind::HalfSpace || shape.kind() == ShapeKind::Plane;
}

/// Throws what the library throws for such a motion of such a shape.
struct MotionCheck {
  void operator()(const CaseMesh& mesh) const {
    check_coordinates(motion_of(mesh), mesh.mesh.bounds(), "the motion");
  }
  void operator()(const CaseBody& body) const {
    const RigidMotion motion = motion_of(body);
    if (is_endless(body.shape)) return;  // it has no end that could be too far away
    const Pose here = Pose::Identity();
    check_coordinates(motion, bounding_aabb({body.shape, here}), "the motion");
  }
  template <typename Other>
  void operator()(const Other&) const {}
};

bool has_course(const CaseShape& shape) {
  if (const auto* mesh = std::get_if<CaseMesh>(&shape)) return mesh->course.has_value();
  const auto* body = std::get_if<CaseBody>(&shape);
  return body != nullptr && body->course.has_value();
}

bool is_endless(const CaseShape& shape) {
  const auto* body = std::get_if<CaseBody>(&shape);
  return body != nullptr && is_endless(body->shape);
}

bool turns(const CaseShape& shape) {
  const auto* body = std::get_if<CaseBody>(&shape);
  return body != nullptr && body->course && body->course->angle != 0;
}

void check_motion(const JsonCursor& at, const CaseShape& shape, Ask ask) {
  if (!is_about_motion(ask)) {
    if (has_course(shape))
      at.member("motion").fail("only \"first_contact\" and \"free\" are about motions");
    return;
  }
  const JsonCursor place = at.has("motion") ? at.member("motion") : at;
  at_place(place, [&] { std::visit(MotionCheck{}, shape); });
}

}  // namespace

RigidCourse read_course(const JsonCursor& at) {
  at.require_keys({"centre", "shift", "axis", "angle"});
  RigidCourse course;
  if (at.has("shift")) course.shift = at.member("shift").point();
  // Without a turn any point of a body goes as straight as another.
  if (!at.has("centre") && !at.has("axis") && !at.has("angle")) return course;
  course.centre = at.member("centre").point();
  course.axis = at.member("axis").point();
  course.angle = at.member("angle").number();
  return course;
}

void check_motions(const JsonCursor& root, const Case& query) {
  check_motion(root.member("a"), query.a, query.ask);
  if (!query.b) return;
  check_motion(root.member("b"), *query.b, query.ask);
  const bool are_planes = is_endless(query.a) && is_endless(*query.b);
  if (is_about_motion(query.ask) && are_planes && (turns(query.a) || turns(*query.b)))
    root.member("question").fail("of two half-spaces or planes none may turn: they meet far away");
}

}  // namespace graze::cases
