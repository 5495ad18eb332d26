#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/compare/peers/fcl_motions.h>
#include <graze/engine/compare/peers/shape_answers.h>

namespace graze::compare {
namespace {

RigidMotion motion_from(const Pose& pose, const std::optional<RigidCourse>& course) {
  return course ? RigidMotion(pose, *course) : RigidMotion(pose);
}

}  // namespace

std::optional<CaseAnswer> FclMotions::answer(const Question& question, const PlacedShape& a,
                                             const PlacedShape& b) const {
  if (!cases::is_about_motion(question.ask) || question.settings.clearance != 0)
    return std::nullopt;
  for (std::size_t i = movers_.size(); i < shapes_.size(); ++i)
    movers_.emplace_back(shapes_[i]);
  const std::optional<FclFirstContact> found =
      first_contact(movers_[a.shape], motion_from(a.pose, question.course_a), movers_[b.shape],
                    motion_from(b.pose, question.course_b), settings_);
  if (!found) return std::nullopt;
  return answer_of_motion(question.ask, found->is_hit ? std::optional(found->time) : std::nullopt);
}

}  // namespace graze::compare
