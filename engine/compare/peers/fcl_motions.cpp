#include <graze/engine/compare/peers/fcl_motions.h>

namespace graze::compare {
namespace {

RigidMotion motion_from(const Pose& pose, const std::optional<RigidCourse>& course) {
  return course ? RigidMotion(pose, *course) : RigidMotion(pose);
}

}  // namespace

std::optional<CaseAnswer> FclMotions::answer(const Question& question, const Pose& pose_a,
                                             const Pose& pose_b) const {
  const bool is_asked = question.ask == Ask::FirstContact || question.ask == Ask::Free;
  if (!is_asked || question.settings.clearance != 0) return std::nullopt;
  const std::optional<FclFirstContact> found =
      first_contact(mover_a_, motion_from(pose_a, question.course_a), mover_b_,
                    motion_from(pose_b, question.course_b), how_);
  if (!found) return std::nullopt;
  CaseAnswer answer;
  if (question.ask == Ask::Free) {
    answer.says = !found->is_hit;
    return answer;
  }
  answer.status = found->is_hit ? RigidStatus::Hit : RigidStatus::Free;
  answer.low = found->time;
  answer.high = found->time;
  return answer;
}

}  // namespace graze::compare
