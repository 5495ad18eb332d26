#include <graze/bvh/error.h>
#include <graze/engine/compare/judge/bodies/distance_bounds.h>
#include <graze/engine/compare/judge/bodies/shape_bodies.h>
#include <graze/engine/compare/judge/rational/in_metres.h>
#include <graze/engine/compare/judge/rational/volume_error.h>
#include <graze/engine/compare/judge/shape_judge.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>
#include <graze/narrowphase/triangle_box.h>
#include <graze/narrowphase/triangle_box/box_frame.h>
#include <graze/narrowphase/triangle_box/triangle_box_stages.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

/// Returns a body as cases know shapes: boxes and balls lie where their poses put them, by laws 1
/// and 3.
std::optional<CaseShape> case_shape(const PlacedBody& body) {
  if (const Mesh* mesh = body.shape.as<Mesh>()) return CaseMesh(*mesh, body.pose);
  if (const auto* box = body.shape.as<Box>()) return Obb{body.pose, box->half_extents};
  if (const auto* ball = body.shape.as<Sphere>())
    return Sphere{place(body.pose, ball->centre), ball->radius};
  return std::nullopt;
}

std::optional<Case> case_of(const PlacedBody& body_a, const PlacedBody& body_b) {
  const bool is_swapped = body_b.shape.kind() == ShapeKind::Mesh;  // the mesh comes first
  std::optional<CaseShape> a = case_shape(is_swapped ? body_b : body_a);
  std::optional<CaseShape> b = case_shape(is_swapped ? body_a : body_b);
  if (!a || !b) return std::nullopt;
  const bool has_mesh = std::holds_alternative<CaseMesh>(*a);
  const bool are_balls = std::holds_alternative<Sphere>(*a) && std::holds_alternative<Sphere>(*b);
  if (!has_mesh && !are_balls) return std::nullopt;
  return Case{.note = "",
              .ask = Ask::Any,
              .settings = {},
              .a = *std::move(a),
              .b = std::move(b),
              .answer = std::nullopt,
              .answered_by = {}};
}

/// Decides about a ball and a box, in the box's frame after law 3's rounding.
std::optional<bool> ball_meets_box(const PlacedBody& body_a, const PlacedBody& body_b) {
  const PlacedBody& ball_body = body_a.shape.kind() == ShapeKind::Sphere ? body_a : body_b;
  const PlacedBody& box_body = &ball_body == &body_a ? body_b : body_a;
  const auto* ball = ball_body.shape.as<Sphere>();
  const auto* box = box_body.shape.as<Box>();
  if (ball == nullptr || box == nullptr) return std::nullopt;
  const Eigen::Vector3d centre =
      narrowphase::point_into_frame(place(ball_body.pose, ball->centre), box_body.pose);
  return referee_overlaps(Sphere{centre, ball->radius},
                          Aabb{-box->half_extents, box->half_extents});
}

/// Finds the error of two boxes, in rational numbers, where both readings of their poses agree.
std::optional<VolumeError> error_of_boxes(const PlacedBody& body_a, const PlacedBody& body_b) {
  const auto* box_a = body_a.shape.as<Box>();
  const auto* box_b = body_b.shape.as<Box>();
  if (box_a == nullptr || box_b == nullptr) return std::nullopt;
  return volume_error(Obb{body_a.pose, box_a->half_extents}, Obb{body_b.pose, box_b->half_extents});
}

/// Returns the largest side of the box around both, half-spaces and planes left out.
double scale_of(const PlacedBody& body_a, const PlacedBody& body_b) {
  std::optional<Aabb> all;
  for (const PlacedBody* body : {&body_a, &body_b}) {
    if (flat_of(body->shape)) continue;
    const Aabb box = bounding_aabb({body->shape, body->pose});
    all = all ? Aabb{all->min.cwiseMin(box.min), all->max.cwiseMax(box.max)} : box;
  }
  return all ? (all->max - all->min).maxCoeff() : 1;
}

/// Returns the largest coordinate that a proof computes with.
double largest_coordinate(const PlacedBody& body_a, const PlacedBody& body_b) {
  double largest = 0;
  for (const PlacedBody* body : {&body_a, &body_b}) {
    largest = std::max(largest, body->pose.translation().cwiseAbs().maxCoeff());
    if (const auto plane = flat_of(body->shape)) {
      largest = std::max(largest, std::abs(plane->offset));
    } else {
      const Aabb box = bounding_aabb({body->shape, body->pose});
      largest = std::max({largest, box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff()});
    }
  }
  return largest;
}

bool is_exact(const PlacedBody& a, const PlacedBody& b) {
  switch (pair_method(a.shape.kind(), b.shape.kind())) {
    case PairMethod::ExactSpheres:
    case PairMethod::ExactSphereBox:
    case PairMethod::MeshVolume:
    case PairMethod::Meshes:
      return true;
    default:
      return false;
  }
}

}  // namespace

struct ShapeJudge::Truth {
  Truth(const PlacedBody& the_a, const PlacedBody& the_b) : a(the_a), b(the_b) {
    query = case_of(a, b);
    if (query) judge.emplace(*query);
    ulp = std::nextafter(largest_coordinate(a, b), std::numeric_limits<double>::infinity()) -
          largest_coordinate(a, b);
    if (is_of_meshes()) return;
    scale = scale_of(a, b);
    if (query) {
      CaseAnswer yes;
      yes.says = true;
      is_hit = judge->judge(yes, {"referee", ""}).verdict == Verdict::Right;
    } else {
      is_hit = ball_meets_box(a, b);
    }
    const std::optional<VolumeError> boxes = error_of_boxes(a, b);
    if (boxes) is_hit = boxes->is_hit;
    measure();
    if (boxes) size = boxes->error;
  }

  bool is_of_meshes() const {
    return a.shape.kind() == ShapeKind::Mesh && b.shape.kind() == ShapeKind::Mesh;
  }

  /// Measures what may be overlooked and, where no referee has spoken, finds a proof.
  void measure() {
    const ShapeDistance found = distance({a.shape, a.pose}, {b.shape, b.pose});
    const double slack = kTouchUlps * ulp;
    const double gap = best_proved_gap(a, b, found.normal);
    const bool is_proved_apart = gap > slack;
    const double outside = std::max(outside_by(a.shape, a.pose, found.point_a),
                                    outside_by(b.shape, b.pose, found.point_b));
    Work work;
    intersects({a.shape, a.pose}, {b.shape, b.pose}, &work);
    has_ended = work.convex_failures == 0;
    // A plane that parts them by less than it is sure of leaves both possible.
    const bool is_proved_hit =
        found.distance == 0 && outside <= kTouchTolerance * scale + slack && gap <= 0;
    if (!is_hit && is_proved_apart) is_hit = false;
    if (!is_hit && is_proved_hit) is_hit = true;
    if (!is_hit) return;
    size = *is_hit ? 0 : std::max(is_proved_apart ? gap : 0.0, found.lower_bound);
    if (!*is_hit || (flat_of(a.shape) && flat_of(b.shape))) return;
    const Manifold manifold = find_contacts({a.shape, a.pose}, {b.shape, b.pose});
    if (!manifold.empty()) size = manifold[0].depth;
  }

  PlacedBody a;
  PlacedBody b;
  std::optional<Case> query;
  std::optional<Judge> judge;
  std::optional<bool> is_hit;  ///< none if it is not proved
  double size = 0;             ///< metres, the gap or the depth
  bool has_ended = true;       ///< true if the library's search for the answer has ended
  double scale = 1;
  double ulp = 1;
};

ShapeJudge::ShapeJudge(const PlacedBody& a, const PlacedBody& b)
    : truth_(std::make_unique<Truth>(a, b)) {}
ShapeJudge::~ShapeJudge() = default;

double ShapeJudge::ulp() const {
  return truth_->ulp;
}

std::optional<bool> ShapeJudge::is_hit() const {
  return truth_->is_hit;
}

ErrorClass ShapeJudge::class_of(double error) const {
  const bool is_small = !truth_->is_of_meshes() && error <= kShapeTolerance * truth_->scale;
  return is_small ? ErrorClass::Touching : ErrorClass::Real;
}

const std::optional<Case>& ShapeJudge::as_case() const {
  return truth_->query;
}

Judgement ShapeJudge::judge(bool says, const CaseWitness& witness) const {
  const Truth& truth = *truth_;
  if (truth.is_of_meshes()) {
    CaseAnswer answer;
    answer.says = says;
    return truth.judge->judge(answer, witness);
  }
  Judgement judgement;
  judgement.truth = "not proved";
  if (!truth.is_hit) return judgement;
  judgement.truth =
      *truth.is_hit ? in_metres("hit, deep by", truth.size) : in_metres("apart by", truth.size);
  const bool is_promised = says && witness.engine == "graze" && !is_exact(truth.a, truth.b) &&
                           (truth.size <= kTouchTolerance * truth.scale || !truth.has_ended);
  judgement.verdict = says == *truth.is_hit || is_promised ? Verdict::Right : Verdict::Wrong;
  if (judgement.verdict == Verdict::Right) return judgement;
  judgement.error = truth.size;
  judgement.ulps = truth.size / truth.ulp;
  judgement.error_class = class_of(truth.size);
  return judgement;
}

}  // namespace graze::compare
