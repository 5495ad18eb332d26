#include <graze/engine/cli/view/case_pictures.h>

#include <graze/engine/cases/answer_case.h>
#include <graze/engine/cases/motion_case.h>
#include <graze/engine/world/shape_bounds.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace graze::cli {
namespace {

namespace fs = std::filesystem;

/// Holds one of the two things of a case, as it is drawn.
struct Thing {
  std::optional<ViewBody> body = {};       ///< none for a point or a ray
  std::optional<Mesh> mesh = {};           ///< the mesh that is drawn, or else
  std::optional<Shape> shape = {};         ///< the shape that is drawn
  std::optional<RigidMotion> motion = {};  ///< the motion of what can move
  Pose pose = Pose::Identity();            ///< its pose at the beginning
  bool is_queried = false;  ///< true for a mesh or a body: the library is asked about the shape
};

Pose moved_to(const Eigen::Vector3d& place) {
  Pose pose = Pose::Identity();
  pose.translation() = place;
  return pose;
}

/// Draws what stands for it.
struct ToThing {
  Thing operator()(const CaseMesh& mesh) const {
    return {.mesh = mesh.mesh, .motion = motion_of(mesh), .pose = mesh.pose, .is_queried = true};
  }
  Thing operator()(const CaseBody& body) const {
    Thing thing = {.motion = motion_of(body), .pose = body.pose, .is_queried = true};
    if (const auto* mesh = body.shape.as<Mesh>())
      thing.mesh = *mesh;
    else
      thing.shape = body.shape;
    return thing;
  }
  Thing operator()(const Triangle& triangle) const {
    const std::array<Eigen::Vector3d, 3> corners = {triangle.a, triangle.b, triangle.c};
    const std::array<TriangleIndices, 1> one = {{{0, 1, 2}}};
    return {.mesh = Mesh(corners, one)};
  }
  Thing operator()(const Aabb& box) const {
    return of_box(box.max / 2 - box.min / 2, moved_to(box.min / 2 + box.max / 2));
  }
  Thing operator()(const Obb& box) const { return of_box(box.half_extents, box.pose); }
  Thing operator()(const Sphere& ball) const {
    if (ball.radius < kSmallestLength || ball.radius > kLargestLength) return {};
    return {.shape = Sphere{Eigen::Vector3d::Zero(), ball.radius}, .pose = moved_to(ball.centre)};
  }
  Thing operator()(const CasePoint&) const { return {}; }
  Thing operator()(const Ray&) const { return {}; }

  /// Returns a box. One that is no Box, as it is flat or too large, is the mesh of its corners.
  static Thing of_box(const Eigen::Vector3d& half, const Pose& pose) {
    if (half.minCoeff() >= kSmallestLength && half.maxCoeff() <= kLargestLength)
      return {.shape = Box{half}, .pose = pose};
    const std::array<Eigen::Vector3d, 8> corners = {{{-half.x(), -half.y(), -half.z()},
                                                     {half.x(), -half.y(), -half.z()},
                                                     {-half.x(), half.y(), -half.z()},
                                                     {half.x(), half.y(), -half.z()},
                                                     {-half.x(), -half.y(), half.z()},
                                                     {half.x(), -half.y(), half.z()},
                                                     {-half.x(), half.y(), half.z()},
                                                     {half.x(), half.y(), half.z()}}};
    const std::array<TriangleIndices, 12> triangles = {{{0, 2, 3},
                                                        {0, 3, 1},
                                                        {4, 5, 7},
                                                        {4, 7, 6},
                                                        {0, 1, 5},
                                                        {0, 5, 4},
                                                        {2, 6, 7},
                                                        {2, 7, 3},
                                                        {0, 4, 6},
                                                        {0, 6, 2},
                                                        {1, 3, 7},
                                                        {1, 7, 5}}};
    return {.mesh = Mesh(corners, triangles), .pose = pose};
  }
};

/// Returns how long a ray is drawn, and how large the plane of a half-space is: as what stands
/// beside it.
double size_beside(const CaseShape& beside) {
  constexpr double kDefault = 1;
  const Thing thing = std::visit(ToThing{}, beside);
  if (!thing.mesh && (!thing.shape || thing.shape->kind() == ShapeKind::HalfSpace)) return kDefault;
  const Aabb box =
      thing.mesh ? thing.mesh->bounds() : bounding_aabb(PlacedShapeView(*thing.shape, thing.pose));
  const double size = (box.max / 2 - box.min / 2).stableNorm() * 2;
  return std::isfinite(size) && size > 0 ? size : kDefault;
}

/// Returns what the answer says of a case that is drawn as it stands.
ViewState state_of(const CaseAnswer& answer) {
  const auto of = [](bool is_touching) {
    return is_touching ? ViewState::Touching : ViewState::Clear;
  };
  if (answer.says) return of(*answer.says);
  if (answer.pairs) return of(!answer.pairs->empty());
  if (answer.triangles) return of(!answer.triangles->empty());
  if (answer.hits) return of(!answer.hits->empty());
  if (answer.corners) return of(!answer.corners->empty());
  if (answer.distance) return of(*answer.distance <= 0);
  return ViewState::Unsaid;
}

/// Shows cases, one after the other, on one page.
class CasePictures {
 public:
  explicit CasePictures(ShownPage& page) : page_(page) {}

  void show(const ListedCase& listed) {
    const Case& query = listed.query;
    PictureWords words = {
        .label = fs::path(listed.name).filename().string() + ", " + name_of(query.ask),
        .note = query.note,
        .is_apart = page_.frames > 0};
    Thing a = thing_of(query.a, "A", query.b ? &*query.b : nullptr);
    Thing b = query.b ? thing_of(*query.b, "B", &query.a) : Thing{};
    if (a.is_queried && b.is_queried && has_course(query)) return show_motion(a, b, words);
    if (a.is_queried && b.is_queried) return show_placed(a, b, a.pose, b.pose, words);
    show_answer(query, a, b, words);
  }

 private:
  Thing thing_of(const CaseShape& shape, const char* side, const CaseShape* beside) {
    Thing thing = std::visit(ToThing{}, shape);
    if (!thing.mesh && !thing.shape) return thing;
    ViewBodySettings settings = {.name = std::string(side) + ": " + name_of(shape)};
    if (const auto* body = std::get_if<CaseBody>(&shape))
      settings.name = std::string(side) + ": " + name_of(body->shape.kind());
    // The two colours are the same for each case.
    settings.color = *side == 'A' ? std::array<std::uint8_t, 3>{147, 180, 212}
                                  : std::array<std::uint8_t, 3>{230, 197, 131};
    if (beside != nullptr) settings.half_space_extent = 2 * size_beside(*beside);
    thing.body =
        thing.mesh ? page_.view.add(*thing.mesh, settings) : page_.view.add(*thing.shape, settings);
    return thing;
  }

  void show_placed(const Thing& a, const Thing& b, const Pose& pose_a, const Pose& pose_b,
                   const PictureWords& words) {
    const ShownBodies bodies = {*a.body, *b.body};
    if (a.mesh && b.mesh)
      return show_pair(PlacedMeshView(*a.mesh, pose_a), PlacedMeshView(*b.mesh, pose_b), bodies,
                       words, page_);
    const Shape shape_a = a.mesh ? Shape(*a.mesh) : *a.shape;
    const Shape shape_b = b.mesh ? Shape(*b.mesh) : *b.shape;
    show_pair(PlacedShapeView(shape_a, pose_a), PlacedShapeView(shape_b, pose_b), bodies, words,
              page_);
  }

  void show_motion(const Thing& a, const Thing& b, const PictureWords& words) {
    for (std::size_t i = 0; i < kMotionPictures; ++i) {
      const double t = static_cast<double>(i) / (kMotionPictures - 1);
      PictureWords now = words;
      now.is_apart = words.is_apart && i == 0;
      std::array<char, 32> time;
      std::snprintf(time.data(), time.size(), ", t = %.3f", t);
      now.label += time.data();
      show_placed(a, b, a.motion->at(t), b.motion->at(t), now);
    }
  }

  /// Shows a case as it stands, with what the answer says.
  void show_answer(const Case& query, const Thing& a, const Thing& b, const PictureWords& words) {
    const CaseAnswer answer = answer_case(query);
    ViewFrame frame = {.label = words.label,
                       .state = state_of(answer),
                       .note = words.note,
                       .is_apart = words.is_apart};
    if (answer.distance && std::isfinite(*answer.distance))
      frame.facts.push_back({"distance", *answer.distance, true});
    if (answer.hits) frame.facts.push_back({"hits", static_cast<double>(answer.hits->size())});
    page_.view.begin_frame(frame);
    ++page_.frames;
    if (frame.state == ViewState::Touching) ++page_.touching;
    for (const Thing* thing : {&a, &b})
      if (thing->body) page_.view.place(*thing->body, thing->pose);
    mark(answer, a, b);
    for (const CaseShape* shape : {&query.a, query.b ? &*query.b : nullptr}) {
      if (shape == nullptr) continue;
      if (const auto* point = std::get_if<CasePoint>(shape))
        page_.view.add_contact(point->position, Eigen::Vector3d::UnitZ(), 0);
      if (const auto* ball = std::get_if<Sphere>(shape);
          ball && (ball->radius < kSmallestLength || ball->radius > kLargestLength))
        page_.view.add_label(ball->centre, "sphere without a size that can be drawn");
      if (const auto* ray = std::get_if<Ray>(shape)) add_ray(*ray, size_beside(query.a));
    }
  }

  void add_ray(const Ray& ray, double beside) {
    const Eigen::Vector3d direction = ray.direction.stableNormalized();
    const double length = std::min(ray.max_distance, 4 * beside);
    page_.view.add_line(ray.origin, ray.origin + length * direction);
    page_.view.add_label(ray.origin, "ray");
  }

  void mark(const CaseAnswer& answer, const Thing& a, const Thing& b) {
    std::vector<std::uint32_t> of_a, of_b;
    const bool is_self = !b.body;
    if (answer.pairs) {
      for (const TrianglePair& pair : *answer.pairs) {
        of_a.push_back(pair.a);
        (is_self ? of_a : of_b).push_back(pair.b);
      }
    }
    if (answer.triangles) of_a = *answer.triangles;
    if (a.body) page_.view.mark_triangles(*a.body, of_a);
    if (b.body) page_.view.mark_triangles(*b.body, of_b);
    if (answer.hits)
      for (const RayHit& hit : *answer.hits)
        page_.view.add_contact(hit.point, hit.normal, 0);
    if (answer.point_a && answer.point_b && answer.distance && *answer.distance > 0 &&
        std::isfinite(*answer.distance))
      page_.view.add_gap(*answer.point_a, *answer.point_b, *answer.distance);
    if (answer.corners && !answer.corners->empty()) {
      std::vector<Eigen::Vector3d> around = *answer.corners;
      around.push_back(around.front());
      page_.view.add_curve(around);
    }
  }

  ShownPage& page_;
};

}  // namespace

bool has_course(const Case& query) {
  return query.ask == Ask::FirstContact || query.ask == Ask::Free;
}

void show_case(const ListedCase& listed, ShownPage& page) {
  CasePictures(page).show(listed);
}

}  // namespace graze::cli
