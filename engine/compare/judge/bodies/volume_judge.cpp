#include <graze/engine/compare/judge/meshes/mesh_judges.h>
#include <graze/engine/compare/judge/meshes/pair_error.h>
#include <graze/engine/compare/judge/rational/box_tree.h>
#include <graze/engine/compare/judge/rational/in_metres.h>
#include <graze/engine/compare/judge/rational/least_translation.h>
#include <graze/engine/compare/judge/rational/rational_box.h>
#include <graze/engine/compare/judge/rational/volume_error.h>
#include <graze/engine/compare/judge/shape_judge.h>
#include <graze/engine/mesh/placement.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace graze::compare {
namespace {

/// So many triangles are looked at for the worst.
constexpr std::size_t kMaxExamined = 64;

double ulp_at(double value) {
  return std::nextafter(value, std::numeric_limits<double>::infinity()) - value;
}

bool meets(const Triangle& triangle, const CaseShape& volume) {
  if (const auto* box = std::get_if<Aabb>(&volume)) return referee_meets(triangle, *box);
  if (const auto* box = std::get_if<Obb>(&volume)) return referee_meets(triangle, *box);
  return referee_meets(triangle, std::get<Sphere>(volume));
}

/// Holds A with the triangles that it is made of, and a volume.
class SurfaceAndVolume {
 public:
  explicit SurfaceAndVolume(const Case& query) : query_(query), volume_(*query.b) {
    if (const auto* t = std::get_if<Triangle>(&query.a)) triangles_ = {*t};
    if (const auto* mesh = std::get_if<CaseMesh>(&query.a)) {
      for (std::size_t i = 0; i < mesh->mesh.triangles().size(); ++i)
        triangles_.push_back(place(mesh->pose, mesh->mesh.triangle(i)));
    }
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      if (meets(triangles_[i], volume_)) hits_.push_back(i);
    }
  }

  const std::vector<std::uint32_t>& hits() const { return hits_; }

  /// Adds the gap of the triangle that is nearest, exactly.
  void add_gap(Judgement& judgement) const {
    const auto gap = [&](std::uint32_t i) { return volume_error(triangles_[i], volume_).error; };
    std::uint32_t nearest = 0;
    double least = gap(0);
    std::vector<Triangle> framed;
    std::transform(triangles_.begin(), triangles_.end(), std::back_inserter(framed),
                   [&](const Triangle& t) { return in_frame(t); });
    BoxTree::for_each_nearer(BoxTree(framed), BoxTree(box_of_volume()), least * (1 + 0x1p-50),
                             [&](std::uint32_t i, std::uint32_t) {
                               const double found = gap(i);
                               if (found < least) nearest = i;
                               least = std::min(least, found);
                               return least * (1 + 0x1p-50);
                             });
    judgement.truth = in_metres("apart by", least);
    add_error(judgement, nearest);
    if (judgement.error_class == ErrorClass::Real && is_volume_enclosed().value_or(false))
      judgement.error_class = ErrorClass::Containment;
  }

  /// Returns, where no triangle meets the volume, whether a closed mesh encloses it.
  std::optional<bool> is_volume_enclosed() const {
    const auto* mesh = std::get_if<CaseMesh>(&query_.a);
    return mesh == nullptr ? std::nullopt : is_volume_inside(*mesh, volume_);
  }

  /// Adds the depth of the triangle that shows it worst: it is at least that. All triangles of a
  /// box may merely touch though the mesh reaches into it, as with meshes.
  void add_depth(Judgement& judgement) const {
    for (std::size_t i = 0; i < std::min(hits_.size(), kMaxExamined); ++i)
      add_error(judgement, hits_[i]);
    if (judgement.error_class != ErrorClass::Touching || triangles_.size() == 1) return;
    const std::optional<Mesh> box = box_mesh();
    if (!box) return;
    std::vector<Eigen::Vector3d> corners;
    std::vector<TriangleIndices> indices;
    for (const Triangle& placed : triangles_) {
      const Triangle t = in_frame(placed);
      const auto first = static_cast<std::uint32_t>(corners.size());
      corners.insert(corners.end(), {t.a, t.b, t.c});
      indices.push_back({first, first + 1, first + 2});
    }
    const Mesh surface(corners, indices);
    const MeshReferee referee({surface}, {*box});
    const std::vector<TrianglePair> pairs = referee.find_hits();
    if (pairs.empty()) return;
    LeastTranslation separating_translation(referee, pairs);
    const double ulp = judgement_ulp(triangles_[hits_.front()]);
    if (separating_translation.find_within(kTouchUlps * ulp)) return;
    judgement.error_class = ErrorClass::Real;
    judgement.error = separating_translation.find();
    judgement.ulps = judgement.error / ulp;
  }

  /// Keeps the worst class, and of one class the largest error.
  void add_error(Judgement& judgement, std::uint32_t triangle) const {
    const Triangle& t = triangles_[triangle];
    const double error = volume_error(t, volume_).error;
    const double ulps = error / judgement_ulp(t);
    const ErrorClass error_class = has_no_area(compare::exactly(t)) ? ErrorClass::Degenerate
                                   : ulps <= kTouchUlps             ? ErrorClass::Touching
                                                                    : ErrorClass::Real;
    const bool is_worse = !judgement.culprit || error_class > judgement.error_class ||
                          (error_class == judgement.error_class && error > judgement.error);
    if (!is_worse) return;
    judgement.error_class = error_class;
    judgement.error = error;
    judgement.ulps = ulps;
    judgement.culprit = {triangle, 0};
  }

 private:
  Triangle in_frame(const Triangle& t) const {
    const auto* box = std::get_if<Obb>(&volume_);
    return box == nullptr ? t : narrowphase::into_frame(t, box->pose);
  }

  /// Returns the volume as a triangle whose box is that of the volume, in its frame, a little
  /// larger.
  std::array<Triangle, 1> box_of_volume() const {
    Aabb box;
    if (const auto* aligned = std::get_if<Aabb>(&volume_)) box = *aligned;
    if (const auto* oriented = std::get_if<Obb>(&volume_))
      box = {-oriented->half_extents, oriented->half_extents};
    if (const auto* ball = std::get_if<Sphere>(&volume_)) {
      const double slack = ulp_at(largest_coordinate(volume_));
      box = {ball->centre.array() - (ball->radius + slack),
             ball->centre.array() + (ball->radius + slack)};
    }
    return {Triangle{box.min, box.max, box.max}};
  }

  /// Returns the surface of a box in its frame, whose corners are doubles.
  std::optional<Mesh> box_mesh() const {
    if (std::holds_alternative<Sphere>(volume_)) return std::nullopt;
    const Triangle ends = box_of_volume()[0];
    std::vector<Eigen::Vector3d> corners;
    for (unsigned mask = 0; mask < 8; ++mask) {
      Eigen::Vector3d corner;
      for (int axis = 0; axis < 3; ++axis)
        corner[axis] = (mask >> axis & 1U) == 0 ? ends.a[axis] : ends.b[axis];
      corners.push_back(corner);
    }
    const std::vector<TriangleIndices> triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6},
                                                    {0, 1, 5}, {0, 5, 4}, {2, 3, 7}, {2, 7, 6},
                                                    {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
    return Mesh(corners, triangles);
  }

  double judgement_ulp(const Triangle& t) const {
    return std::max(ulp_of(t, t), ulp_at(largest_coordinate(volume_)));
  }

  const Case& query_;
  const CaseShape& volume_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> hits_;
};

Judgement judge_list(const SurfaceAndVolume& shapes, const std::vector<std::uint32_t>& triangles) {
  const std::vector<std::uint32_t>& hits = shapes.hits();
  std::vector<std::uint32_t> wrong;
  std::set_symmetric_difference(triangles.begin(), triangles.end(), hits.begin(), hits.end(),
                                std::back_inserter(wrong));
  Judgement judgement;
  judgement.truth = std::to_string(hits.size()) + (hits.size() == 1 ? " triangle" : " triangles");
  judgement.verdict = wrong.empty() ? Verdict::Right : Verdict::Wrong;
  judgement.wrong_pairs = wrong.size();
  if (triangles.empty() && !hits.empty()) {  // that is to say that they are apart
    shapes.add_depth(judgement);
    return judgement;
  }
  for (std::size_t i = 0; i < std::min(wrong.size(), kMaxExamined); ++i)
    shapes.add_error(judgement, wrong[i]);
  return judgement;
}

/// Judges a list that was cut: any triangles do, if they meet the volume and are as many as the
/// limit lets pass.
Judgement judge_cut_list(const SurfaceAndVolume& shapes,
                         const std::vector<std::uint32_t>& triangles, std::size_t limit) {
  const std::vector<std::uint32_t>& hits = shapes.hits();
  const std::size_t count = std::min(limit, hits.size());
  std::vector<std::uint32_t> wrong;
  std::set_difference(triangles.begin(), triangles.end(), hits.begin(), hits.end(),
                      std::back_inserter(wrong));
  if (wrong.empty() && triangles.size() != count) {
    std::set_difference(hits.begin(), hits.end(), triangles.begin(), triangles.end(),
                        std::back_inserter(wrong));
  }
  Judgement judgement;
  judgement.truth = std::to_string(count) + " of " + std::to_string(hits.size()) +
                    (hits.size() == 1 ? " triangle" : " triangles");
  const bool is_right = wrong.empty() && triangles.size() == count;
  judgement.verdict = is_right ? Verdict::Right : Verdict::Wrong;
  judgement.wrong_pairs = wrong.size();
  for (std::size_t i = 0; i < std::min(wrong.size(), kMaxExamined); ++i)
    shapes.add_error(judgement, wrong[i]);
  return judgement;
}

Judgement judge_surface(const Case& query, const CaseAnswer& answer) {
  const SurfaceAndVolume shapes(query);
  if (query.ask == Ask::Pairs && answer.triangles) {
    return query.settings.limit ? judge_cut_list(shapes, *answer.triangles, *query.settings.limit)
                                : judge_list(shapes, *answer.triangles);
  }
  Judgement judgement;
  if (query.ask != Ask::Any || !answer.says) return judgement;
  const bool is_hit = !shapes.hits().empty();
  if (!is_hit && query.settings.hit == Hit::Solid) {
    const std::optional<bool> is_inside = shapes.is_volume_enclosed();
    if (!is_inside) return judgement;
    if (*is_inside) {
      shapes.add_gap(judgement);
      judgement.truth = "inside, " + judgement.truth;
      judgement.verdict = *answer.says ? Verdict::Right : Verdict::Wrong;
      return judgement;
    }
  }
  judgement.truth = is_hit ? "hit" : "apart";
  judgement.verdict = is_hit == *answer.says ? Verdict::Right : Verdict::Wrong;
  if (judgement.verdict == Verdict::Right) return judgement;
  if (is_hit) {
    shapes.add_depth(judgement);
  } else {
    shapes.add_gap(judgement);
  }
  return judgement;
}

}  // namespace

Judgement judge_volumes(const Case& query, const CaseAnswer& answer, bool is_graze) {
  const auto is_volume = [](const CaseShape& shape) {
    return std::holds_alternative<Aabb>(shape) || std::holds_alternative<Obb>(shape) ||
           std::holds_alternative<Sphere>(shape);
  };
  if (!is_volume(*query.b)) return {};
  if (!is_volume(query.a)) return judge_surface(query, answer);
  Judgement judgement;
  if (query.ask != Ask::Any || !answer.says) return judgement;
  const std::optional<VolumeError> error = volume_error(query.a, *query.b);
  if (!error) {
    judgement.truth = "boxes of poses that are not quite rotations";
    return judgement;
  }
  const double ulp = ulp_at(std::max(largest_coordinate(query.a), largest_coordinate(*query.b)));
  judgement.truth = in_metres(error->is_hit ? "hit, deep by" : "apart by", error->error);
  judgement.verdict = error->is_hit == *answer.says ? Verdict::Right : Verdict::Wrong;
  if (judgement.verdict == Verdict::Right) return judgement;
  const bool is_touching = error->error <= kTouchUlps * ulp;
  if (is_graze && *answer.says && is_conservative(query.a, *query.b)) {
    judgement.verdict = is_touching ? Verdict::Right : Verdict::NotJudged;
    return judgement;
  }
  judgement.error = error->error;
  judgement.ulps = error->error / ulp;
  judgement.error_class = is_touching ? ErrorClass::Touching : ErrorClass::Real;
  return judgement;
}

}  // namespace graze::compare
