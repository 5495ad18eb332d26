#include <graze/bvh/error.h>
#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/motion_case.h>

#include <utility>

namespace graze {
namespace {

RigidCourse course_of(const RigidMotion& motion) {
  return {.centre = motion.centre(),
          .shift = motion.shift(),
          .axis = motion.axis(),
          .angle = motion.angle()};
}

template <typename Placed>
RigidMotion motion_from_pose(const Placed& placed) {
  return placed.course ? RigidMotion(placed.pose, *placed.course) : RigidMotion(placed.pose);
}

Case motion_case(Ask ask, CaseShape a, CaseShape b, CaseAnswer answer,
                 const RigidContactSettings& settings) {
  return {.note = "",
          .ask = ask,
          .settings = {.clearance = settings.clearance, .tolerance = settings.tolerance},
          .a = std::move(a),
          .b = std::move(b),
          .answer = std::move(answer),
          .answered_by = this_library()};
}

[[noreturn]] void refuse_budget() {
  throw InputError("to_case: an answer of another budget than the default one may be another");
}

template <typename Placed>
Case contact_case(const Placed& a, const Placed& b, const RigidContact& contact,
                  const RigidContactSettings& settings) {
  const std::uint64_t usual = RigidContactSettings{}.budget;
  const bool is_for_sure =
      settings.budget == usual || (settings.budget < usual && !contact.is_out_of_budget);
  if (!is_for_sure) refuse_budget();
  return motion_case(Ask::FirstContact, a, b, answer_of(contact), settings);
}

template <typename Placed>
Case free_case(const Placed& a, const Placed& b, bool is_free,
               const RigidContactSettings& settings) {
  if (settings.budget != RigidContactSettings{}.budget) refuse_budget();
  CaseAnswer answer;
  answer.says = is_free;
  return motion_case(Ask::Free, a, b, answer, settings);
}

}  // namespace

RigidMotion motion_of(const CaseMesh& mesh) {
  return motion_from_pose(mesh);
}

RigidMotion motion_of(const CaseBody& body) {
  return motion_from_pose(body);
}

CaseMesh case_mesh(const Mesh& mesh, const RigidMotion& motion) {
  CaseMesh placed(mesh, motion.start());
  placed.course = course_of(motion);
  return placed;
}

CaseBody case_body(const Shape& shape, const RigidMotion& motion) {
  CaseBody placed(shape, motion.start());
  placed.course = course_of(motion);
  return placed;
}

RigidContactSettings contact_settings(const CaseSettings& settings) {
  return {.clearance = settings.clearance, .tolerance = settings.tolerance};
}

Case to_case(const CaseMesh& a, const CaseMesh& b, const RigidContact& contact,
             const RigidContactSettings& settings) {
  return contact_case(a, b, contact, settings);
}

Case to_case(const CaseBody& a, const CaseBody& b, const RigidContact& contact,
             const RigidContactSettings& settings) {
  return contact_case(a, b, contact, settings);
}

Case to_case_free(const CaseMesh& a, const CaseMesh& b, bool is_free,
                  const RigidContactSettings& settings) {
  return free_case(a, b, is_free, settings);
}

Case to_case_free(const CaseBody& a, const CaseBody& b, bool is_free,
                  const RigidContactSettings& settings) {
  return free_case(a, b, is_free, settings);
}

CaseAnswer answer_of(const RigidContact& contact) {
  CaseAnswer answer;
  answer.status = contact.status;
  answer.low = contact.low;
  answer.high = contact.high;
  return answer;
}

}  // namespace graze
