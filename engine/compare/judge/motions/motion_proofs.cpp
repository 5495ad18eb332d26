#include <graze/engine/cases/motion_case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/motions/motion_proofs.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/rigid_certificate.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/engine/world/shape_bounds.h>
#include <graze/engine/world/shape_pairs.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

/// So many moments are looked at for the worst in the time in which something is overlooked: evenly
/// spread, and ever nearer to its beginning, for a contact may be short.
constexpr int kMoments = 16;
constexpr int kEarlyMoments = 20;

/// After so many steps from one gap to the next nothing is proved.
constexpr int kMostSteps = 2000;

/// Answers by this name are judged without what graze is granted: a proof has no tolerance.
const CaseWitness kNobody = {"", ""};

struct MovingMesh {
  const Mesh& mesh;
  RigidMotion motion;
};

/// Returns a mesh in motion, also where it is the shape of a body.
std::optional<MovingMesh> as_moving_mesh(const CaseShape& shape) {
  if (const auto* mesh = std::get_if<CaseMesh>(&shape))
    return MovingMesh{mesh->mesh, motion_of(*mesh)};
  const auto* body = std::get_if<CaseBody>(&shape);
  const Mesh* mesh = body != nullptr ? body->shape.as<Mesh>() : nullptr;
  if (mesh == nullptr) return std::nullopt;
  return MovingMesh{*mesh, motion_of(*body)};
}

/// Returns the motion up to a time, which takes the place of 1.
RigidMotion first_part(const RigidMotion& motion, double time) {
  return {motion.start(),
          {.centre = motion.centre(),
           .shift = motion.shift() * time,
           .axis = motion.axis(),
           .angle = motion.angle() * time}};
}

/// Returns what cutting off a part of a motion can move a point by, and rounding its poses: half an
/// ulp of the shift; half an ulp of the angle on an arm of all lengths; and what law 14 says of
/// at().
double rounding_of_parts(const MovingMesh& moving) {
  const RigidMotion& m = moving.motion;
  const Aabb& bounds = moving.mesh.bounds();
  const Eigen::Vector3d corner = bounds.min.cwiseAbs().cwiseMax(bounds.max.cwiseAbs());
  const double lengths = m.start().translation().cwiseAbs().sum() + m.centre().cwiseAbs().sum() +
                         m.shift().cwiseAbs().sum() + corner.sum();
  return lengths * (0x1p-42 + 0x1p-50 * std::abs(m.angle()));
}

CaseShape placed(const CaseShape& shape, double time) {
  if (const auto* mesh = std::get_if<CaseMesh>(&shape))
    return CaseMesh(mesh->mesh, motion_of(*mesh).at(time));
  const auto& body = std::get<CaseBody>(shape);
  return CaseBody(body.shape, motion_of(body).at(time));
}

/// Returns a body that is a mesh as a mesh: two of these can be asked what meshes can.
CaseShape as_mesh_if_one(CaseShape shape) {
  const auto* body = std::get_if<CaseBody>(&shape);
  const Mesh* mesh = body != nullptr ? body->shape.as<Mesh>() : nullptr;
  if (mesh == nullptr) return shape;
  return CaseMesh(*mesh, body->pose);
}

RigidContact ask_library(const Case& query) {
  const RigidContactSettings settings = contact_settings(query.settings);
  if (const auto* a = std::get_if<CaseMesh>(&query.a)) {
    const auto& b = std::get<CaseMesh>(*query.b);
    return first_contact({a->mesh, motion_of(*a)}, {b.mesh, motion_of(b)}, settings);
  }
  const auto& a = std::get<CaseBody>(query.a);
  const auto& b = std::get<CaseBody>(*query.b);
  return first_contact({a.shape, motion_of(a)}, {b.shape, motion_of(b)}, settings);
}

/// Returns the most that any point of a body goes from t = 0 to 1.
double fastest_point(const CaseShape& shape) {
  const auto& body = std::get<CaseBody>(shape);
  if (!body.course) return 0;
  const RigidMotion motion = motion_of(body);
  double travel = motion.shift().norm();
  if (motion.angle() != 0) {
    const Aabb bounds = bounding_aabb({body.shape, motion.start()});
    const Eigen::Vector3d farthest = (bounds.min - motion.centre())
                                         .cwiseAbs()
                                         .cwiseMax((bounds.max - motion.centre()).cwiseAbs());
    travel += std::abs(motion.angle()) * farthest.norm();
  }
  return travel * (1 + 0x1p-20);
}

}  // namespace

MotionProofs::MotionProofs(const Case& query) : query_(query), proposed_(ask_library(query)) {}

Case MotionProofs::at(double time, double clearance) const {
  CaseShape a = placed(query_.a, time), b = placed(*query_.b, time);
  if (as_moving_mesh(query_.a) && as_moving_mesh(*query_.b)) {
    a = as_mesh_if_one(std::move(a));
    b = as_mesh_if_one(std::move(b));
  }
  return {.note = "",
          .ask = clearance == 0 ? Ask::Any : Ask::Within,
          .settings = {.clearance = clearance},
          .a = std::move(a),
          .b = std::move(b),
          .answer = std::nullopt,
          .answered_by = {}};
}

bool MotionProofs::proves_free_until(double time) const {
  const std::optional<MovingMesh> a = as_moving_mesh(query_.a), b = as_moving_mesh(*query_.b);
  if (!a || !b) return advances_to(time);
  RigidContactSettings settings = contact_settings(query_.settings);
  RigidMotion motion_a = a->motion, motion_b = b->motion;
  if (time < 1) {
    motion_a = first_part(motion_a, time);
    motion_b = first_part(motion_b, time);
    settings.clearance += rounding_of_parts(*a) + rounding_of_parts(*b);
    // Up to the time at which the gap is the tolerance it is half of that for sure.
    settings.tolerance /= 2;
  }
  const auto proof = certify_free({a->mesh, motion_a}, {b->mesh, motion_b}, settings);
  return proof && proof->clearance >= settings.clearance &&
         proves_freedom(*proof, {a->mesh, motion_a}, {b->mesh, motion_b});
}

/// Returns a gap that is proved at a time, or 0.
double MotionProofs::proved_gap(double time) const {
  Case query = at(time, 0);
  const auto& a = std::get<CaseBody>(query.a);
  const auto& b = std::get<CaseBody>(*query.b);
  const ShapeDistance gap = distance({a.shape, a.pose}, {b.shape, b.pose});
  query.ask = Ask::Distance;
  if (Judge(query).judge(answer_of(gap), kNobody).verdict != Verdict::Right) return 0;
  return std::min(gap.distance, gap.lower_bound);
}

/// True if gaps lead on to `end`. A gap lasts as long as the fastest points of both need for it,
/// less what proofs round.
bool MotionProofs::advances_to(double end) const {
  const double speed = fastest_point(query_.a) + fastest_point(*query_.b);
  if (!std::isfinite(speed)) return false;
  const double kept = query_.settings.clearance + (end < 1 ? 0 : query_.settings.tolerance);
  double time = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    const double room = proved_gap(time) * (1 - 0x1p-20) - kept;
    if (!(room > 0)) return false;
    const double next = time + room / speed * (1 - 0x1p-20);
    if (!(next < end)) return true;
    if (!(next > time)) return false;
    time = next;
  }
  return false;
}

bool MotionProofs::is_free_until(double time) {
  const std::lock_guard lock(mutex_);
  const auto later = known_free_.lower_bound(time);
  if (later != known_free_.end() && later->second) return true;
  const auto [at, is_new] = known_free_.try_emplace(time, false);
  if (is_new) at->second = proves_free_until(time);
  return at->second;
}

std::optional<double> MotionProofs::contact() {
  if (proposed_.status != RigidStatus::Hit) return std::nullopt;
  const std::lock_guard lock(mutex_);
  if (!is_contact_known_) is_contact_known_ = is_contact(proposed_.high);
  return *is_contact_known_ ? std::optional(proposed_.high) : std::nullopt;
}

Judgement MotionProofs::judge_at(double time, bool says) const {
  const Case query = at(time, query_.settings.clearance);
  // Within a clearance only meshes are asked about.
  if (query.ask == Ask::Within && std::holds_alternative<CaseBody>(query.a)) return {};
  CaseAnswer answer;
  answer.says = says;
  return Judge(query).judge(answer, kNobody);
}

bool MotionProofs::is_contact(double time) const {
  return judge_at(time, true).verdict == Verdict::Right;
}

bool MotionProofs::is_apart(double time) const {
  return judge_at(time, true).verdict == Verdict::Wrong;
}

bool MotionProofs::is_near(double time) const {
  const Case query = at(time, query_.settings.clearance + query_.settings.tolerance);
  if (query.ask == Ask::Within && std::holds_alternative<CaseBody>(query.a)) return false;
  CaseAnswer answer;
  answer.says = true;
  return Judge(query).judge(answer, kNobody).verdict == Verdict::Right;
}

/// Returns how deep the library says that they are, which only chooses the moment; below 0 if they
/// are apart.
double MotionProofs::depth_at(double time) const {
  const Case query = at(time, query_.settings.clearance);
  if (const auto* a = std::get_if<CaseMesh>(&query.a)) {
    const auto& b = std::get<CaseMesh>(*query.b);
    const PlacedMeshView placed_a{a->mesh, a->pose}, placed_b{b.mesh, b.pose};
    if (query.ask == Ask::Within && !intersects(placed_a, placed_b))
      return query_.settings.clearance - distance(placed_a, placed_b).distance;
    if (!intersects(placed_a, placed_b)) return -1;
    return query_.settings.clearance + separating_translation(placed_a, placed_b).distance;
  }
  const auto& a = std::get<CaseBody>(query.a);
  const auto& b = std::get<CaseBody>(*query.b);
  if (!intersects({a.shape, a.pose}, {b.shape, b.pose})) return -1;
  double deepest = 0;
  for (const ShapeContact& contact : find_contacts({a.shape, a.pose}, {b.shape, b.pose}))
    deepest = std::max(deepest, contact.depth);
  return deepest;
}

double MotionProofs::nearest_time() const {
  double nearest = 0, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kMoments; ++i) {
    const double time = static_cast<double>(i) / kMoments;
    const Case query = at(time, 0);
    double gap = 0;
    if (const auto* a = std::get_if<CaseMesh>(&query.a)) {
      const auto& b = std::get<CaseMesh>(*query.b);
      gap = distance(PlacedMeshView{a->mesh, a->pose}, PlacedMeshView{b.mesh, b.pose}).distance;
    } else {
      const auto& body_a = std::get<CaseBody>(query.a);
      const auto& body_b = std::get<CaseBody>(*query.b);
      gap = distance({body_a.shape, body_a.pose}, {body_b.shape, body_b.pose}).distance;
    }
    if (!(gap < least)) continue;
    least = gap;
    nearest = time;
  }
  return nearest;
}

std::optional<Judgement> MotionProofs::judge_missed(double from, double to) const {
  double worst = from, deepest = -1;
  const auto look_at = [&](double part) {
    const double time = std::min(from + (to - from) * part, 1.0);
    const double depth = depth_at(time);
    if (!(depth > deepest)) return;
    deepest = depth;
    worst = time;
  };
  for (int i = 0; i <= kMoments; ++i)
    look_at(static_cast<double>(i) / kMoments);
  for (int i = 1; i <= kEarlyMoments; ++i)
    look_at(std::ldexp(1.0 / kMoments, -i));
  const Judgement judgement = judge_at(worst, false);
  if (judgement.verdict != Verdict::Wrong) return std::nullopt;
  return judgement;
}

}  // namespace graze::compare
