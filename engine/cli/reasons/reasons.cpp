#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/cli/reasons/reasons.h>
#include <graze/engine/compare/peers/engine.h>

#include <fmt/format.h>

namespace graze::cli {

std::optional<Reasons> reasons_of(const Case& query, const compare::Judgement& judgement) {
  if (!query.b) return std::nullopt;
  if (cases::is_about_motion(query.ask)) return motion_reasons(query, judgement);
  if (query.ask == Ask::Ray || query.ask == Ask::RayAll) return ray_reasons(query, judgement);
  if (query.ask == Ask::Contains) return inside_reasons(query);
  if (compare::as_bodies(query)) return body_reasons(query, judgement);
  if (query.ask == Ask::Separation && compare::as_meshes(query))
    return separation_reasons(query, judgement);
  return std::nullopt;
}

std::string words_of(const Eigen::Vector3d& point) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", point.x() + 0.0, point.y() + 0.0, point.z() + 0.0);
}

std::string words_of_error(const compare::Judgement& judgement) {
  return fmt::format("The answer is off by {:.3g} m.", judgement.error);
}

}  // namespace graze::cli
