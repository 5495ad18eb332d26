#include <graze/engine/compare/peers/fcl_motions.h>

namespace graze::compare {
namespace {

RigidMotion motion_from(const Pose& pose, const std::optional<RigidCourse>& course) {
  return course ? RigidMotion(pose, *course) : RigidMotion(pose);
}

}  // namespace

std::optional<CaseAnswer> FclMotions::answer(const Question& question, const PlacedShape& a,
                                             const PlacedShape& b) const {
  const bool is_asked = question.ask == Ask::FirstContact || question.ask == Ask::Free;
  if (!is_asked || question.settings.clearance != 0) return std::nullopt;
  for (std::size_t i = movers_.size(); i < shapes_.size(); ++i)
    movers_.emplace_back(shapes_[i]);
  const std::optional<FclFirstContact> found =
      first_contact(movers_[a.shape], motion_from(a.pose, question.course_a), movers_[b.shape],
                    motion_from(b.pose, question.course_b), how_);
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
