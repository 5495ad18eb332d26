// Asks ODE through the interface that every engine has: dCollide() of two trimeshes or shapes, in
// double. ODE keeps caches in its geoms, and its trimesh colliders in globals: one thread of a
// process may ask.

#include <graze/engine/compare/peers/adaptors.h>
#include <graze/engine/compare/peers/shape_answers.h>
#include <graze/engine/world/shapes/hull_data.h>
#include <graze/narrowphase/convex/core/hull.h>

#include <ode/ode.h>
#include <ode/version.h>
#include <algorithm>
#include <array>
#include <cstdarg>
#include <memory>
#include <stdexcept>

namespace graze::compare {
namespace {

constexpr int kMaxContacts = 0x7fff;  // the most that the flags of dCollide() have room for

/// Drops what ODE would print of its hash tables, which changes no answer.
void be_silent(int, const char*, va_list) {}

void start_ode() {
  static const bool kIsStarted = [] {
    dInitODE2(0);
    dSetMessageHandler(be_silent);
    return dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  }();
  if (!kIsStarted) throw std::runtime_error("ODE has no memory for its thread");
}

void place(dGeomID geom, const Pose& pose) {
  dMatrix3 rotation;  // rows of four
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column)
      rotation[4 * row + column] = column == 3 ? 0 : pose(row, column);
  }
  dGeomSetPosition(geom, pose(0, 3), pose(1, 3), pose(2, 3));
  dGeomSetRotation(geom, rotation);
}

class OdeMesh {
 public:
  explicit OdeMesh(const Mesh& mesh) {
    for (const Eigen::Vector3d& v : mesh.vertices())
      vertices_.insert(vertices_.end(), {v.x(), v.y(), v.z()});
    for (const TriangleIndices& t : mesh.triangles())
      indices_.insert(indices_.end(), {t[0], t[1], t[2]});
    // OPCODE makes no tree of one triangle, and crashes; a copy of it changes no yes or no.
    if (indices_.size() == 3)
      indices_.insert(indices_.end(), {indices_[0], indices_[1], indices_[2]});
    data_ = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data_, vertices_.data(), 3 * sizeof(double),
                                static_cast<int>(vertices_.size() / 3), indices_.data(),
                                static_cast<int>(indices_.size()), 3 * sizeof(dTriIndex));
    geom_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
    dGeomTriMeshEnableTC(geom_, dTriMeshClass, 0);
  }
  ~OdeMesh() {
    dGeomDestroy(geom_);
    dGeomTriMeshDataDestroy(data_);
  }
  OdeMesh(const OdeMesh&) = delete;
  OdeMesh& operator=(const OdeMesh&) = delete;

  dGeomID geom() const { return geom_; }

  /// Measures what ODE asks for before hulls may meet the mesh.
  void measure_angles() const {
    dGeomTriMeshDataPreprocess2(data_, 1U << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES, nullptr);
  }

 private:
  std::vector<double> vertices_;
  std::vector<dTriIndex> indices_;
  dTriMeshDataID data_;
  dGeomID geom_;
};

class OdePair : public LoadedPair {
 public:
  OdePair(const Mesh& mesh_a, const Mesh& mesh_b) : mesh_a_(mesh_a), mesh_b_(mesh_b) {}

  std::optional<CaseAnswer> answer(const Question& question, const Pose& pose_a,
                                   const Pose& pose_b) const override {
    if (!question.is_plain()) return std::nullopt;
    CaseAnswer answer;
    if (question.ask == Ask::Any) {
      answer.says = !collide(pose_a, pose_b, 1 | static_cast<int>(CONTACTS_UNIMPORTANT)).empty();
      return answer;
    }
    if (question.ask != Ask::Contacts) return std::nullopt;
    answer.contacts.emplace();
    for (const dContactGeom& c : collide(pose_a, pose_b, kMaxContacts)) {
      const Eigen::Vector3d point(c.pos[0], c.pos[1], c.pos[2]);
      // ODE's normal points into the first geom.
      const Eigen::Vector3d normal(-c.normal[0], -c.normal[1], -c.normal[2]);
      answer.contacts->push_back({point, point, point, normal, c.depth});
    }
    return answer;
  }

 private:
  std::vector<dContactGeom> collide(const Pose& pose_a, const Pose& pose_b, int flags) const {
    std::vector<dContactGeom> contacts(static_cast<std::size_t>(flags & 0xffff));
    place(mesh_a_.geom(), pose_a);
    place(mesh_b_.geom(), pose_b);
    const int count =
        dCollide(mesh_a_.geom(), mesh_b_.geom(), flags, contacts.data(), sizeof(dContactGeom));
    contacts.resize(static_cast<std::size_t>(std::max(count, 0)));
    return contacts;
  }

  OdeMesh mesh_a_;
  OdeMesh mesh_b_;
};

/// Holds a hull as ODE borrows it, around a point inside.
struct OdeHull {
  explicit OdeHull(const narrowphase::Hull& hull) {
    for (const narrowphase::Vec3& c : hull.corners)
      middle += Eigen::Vector3d(c.x, c.y, c.z) / static_cast<double>(hull.corners.size());
    for (const narrowphase::Vec3& c : hull.corners)
      points.insert(points.end(), {c.x - middle.x(), c.y - middle.y(), c.z - middle.z()});
    for (const auto& face : hull.faces) {
      const narrowphase::Vec3& n = face.normal;
      const dReal* p = &points[std::size_t{3} * hull.loops[face.first]];
      planes.insert(planes.end(), {n.x, n.y, n.z, n.x * p[0] + n.y * p[1] + n.z * p[2]});
      polygons.push_back(face.count);
      for (std::uint32_t i = 0; i < face.count; ++i)
        polygons.push_back(hull.loops[face.first + i]);
    }
    middle += Eigen::Vector3d(hull.middle.x, hull.middle.y, hull.middle.z);
  }
  std::vector<dReal> points;
  std::vector<dReal> planes;
  std::vector<unsigned> polygons;
  Eigen::Vector3d middle{0, 0, 0};
};

/// Holds a geom of one shape. ODE has no cones and no ellipsoids.
class OdeShape {
 public:
  explicit OdeShape(const Shape& shape) : kind_(shape.kind()) {
    if (const auto* ball = shape.as<Sphere>()) {
      centre_ = ball->centre;
      geom_ = dCreateSphere(nullptr, ball->radius);
    } else if (const auto* box = shape.as<Box>()) {
      const Eigen::Vector3d sides = 2 * box->half_extents;
      geom_ = dCreateBox(nullptr, sides.x(), sides.y(), sides.z());
    } else if (const auto* pill = shape.as<Capsule>()) {
      geom_ = pill->half_length > 0 ? dCreateCapsule(nullptr, pill->radius, 2 * pill->half_length)
                                    : dCreateSphere(nullptr, pill->radius);
    } else if (const auto* drum = shape.as<Cylinder>()) {
      geom_ = dCreateCylinder(nullptr, drum->radius, 2 * drum->half_height);
    } else if (const auto* plane = shape.as<HalfSpace>()) {
      plane_ = *plane;
      geom_ = dCreatePlane(nullptr, 0, 0, 1, 0);
    } else if (const auto* mesh = shape.as<Mesh>()) {
      mesh_ = std::make_unique<OdeMesh>(*mesh);
      mesh_->measure_angles();
    } else if (const auto* hull = shape.as<ConvexHull>()) {
      hull_ = std::make_unique<OdeHull>(data_of(*hull));
      centre_ = hull_->middle;
      geom_ =
          dCreateConvex(nullptr, hull_->planes.data(),
                        static_cast<unsigned>(hull_->planes.size() / 4), hull_->points.data(),
                        static_cast<unsigned>(hull_->points.size() / 3), hull_->polygons.data());
    }
  }
  ~OdeShape() {
    if (geom_ != nullptr) dGeomDestroy(geom_);
  }
  OdeShape(const OdeShape&) = delete;
  OdeShape& operator=(const OdeShape&) = delete;

  ShapeKind kind() const { return kind_; }
  dGeomID geom() const { return mesh_ ? mesh_->geom() : geom_; }

  dGeomID place(Pose pose) const {
    if (plane_) {
      const Eigen::Vector3d n = pose.linear() * plane_->normal;
      dGeomPlaneSetParams(geom_, n.x(), n.y(), n.z(), plane_->offset + n.dot(pose.translation()));
    } else {
      pose.translation() = pose * centre_;
      compare::place(geom(), pose);
    }
    return geom();
  }

 private:
  ShapeKind kind_;
  Eigen::Vector3d centre_{0, 0, 0};
  std::optional<HalfSpace> plane_;
  std::unique_ptr<OdeMesh> mesh_;
  std::unique_ptr<OdeHull> hull_;
  dGeomID geom_ = nullptr;
};

/// Collides two geoms. ODE loses contacts of boxes if it is asked for fewer than there are.
bool collide(dGeomID a, dGeomID b) {
  std::array<dContactGeom, 16> contacts;
  return dCollide(a, b, static_cast<int>(contacts.size()), contacts.data(), sizeof(dContactGeom)) >
         0;
}

/// True if two shapes of these kinds ever collide: ODE says of two that it has no function for that
/// they are apart.
bool are_collided(ShapeKind kind_a, ShapeKind kind_b) {
  const auto sample = [](ShapeKind kind) -> std::optional<Shape> {
    const std::array<Eigen::Vector3d, 4> corners = {
        {{2, 0, -1}, {-1, 2, -1}, {-1, -2, -1}, {0, 0, 2}}};
    const std::array<TriangleIndices, 4> faces = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    switch (kind) {
      case ShapeKind::Sphere:
        return Sphere{{0, 0, 0}, 1.25};
      case ShapeKind::Box:
        return Box{{1, 1.25, 1.5}};
      case ShapeKind::Capsule:
        return Capsule{0.75, 1};
      case ShapeKind::Cylinder:
        return Cylinder{1, 1.25};
      case ShapeKind::HalfSpace:
        return HalfSpace{{0, 0, 1}, 0};
      case ShapeKind::ConvexHull:
        return ConvexHull(corners);
      case ShapeKind::Mesh:
        return Mesh(corners, faces);
      default:
        return std::nullopt;
    }
  };
  const std::optional<Shape> a = sample(kind_a);
  const std::optional<Shape> b = sample(kind_b);
  if (!a || !b) return false;
  Pose pose = Pose::Identity();
  pose.translation() << 0.5, 0.25, 0.75;  // so that each is half way in the other
  const OdeShape ode_a(*a);
  const OdeShape ode_b(*b);
  return collide(ode_a.place(Pose::Identity()), ode_b.place(pose));
}

class OdeShapes : public LoadedShapes {
 public:
  explicit OdeShapes(std::span<const Shape> shapes) {
    for (const Shape& shape : shapes)
      shapes_.push_back(std::make_unique<OdeShape>(shape));
    for (const ShapeKind a : kShapeKinds) {
      for (const ShapeKind b : kShapeKinds)
        knows_[index_of(a)][index_of(b)] = are_collided(a, b);
    }
    // One geom has one place, so that a shape which meets itself needs two.
    for (const Shape& shape : shapes)
      others_.push_back(std::make_unique<OdeShape>(shape));
  }

  std::optional<bool> intersects(std::size_t shape_a, const Pose& pose_a, std::size_t shape_b,
                                 const Pose& pose_b) const override {
    const OdeShape& a = *shapes_[shape_a];
    const OdeShape& b = *others_[shape_b];
    if (!knows_[index_of(a.kind())][index_of(b.kind())]) return std::nullopt;
    return collide(a.place(pose_a), b.place(pose_b));
  }

  std::optional<CaseAnswer> answer(const Question& question, const PlacedShape& placed_a,
                                   const PlacedShape& placed_b) const override {
    const OdeShape& a = *shapes_[placed_a.shape];
    const OdeShape& b = *others_[placed_b.shape];
    const bool is_known = knows_[index_of(a.kind())][index_of(b.kind())];
    const bool is_asked = question.ask == Ask::Contacts || question.ask == Ask::Separation;
    if (!is_asked || !is_known) return std::nullopt;
    std::vector<dContactGeom> found(kMaxContacts);
    const int count = dCollide(a.place(placed_a.pose), b.place(placed_b.pose), kMaxContacts,
                               found.data(), sizeof(dContactGeom));
    found.resize(static_cast<std::size_t>(std::max(count, 0)));
    CaseAnswer answer;
    answer.manifold.emplace();
    for (const dContactGeom& c : found)
      add_contact({c.pos[0], c.pos[1], c.pos[2]}, {-c.normal[0], -c.normal[1], -c.normal[2]},
                  c.depth, *answer.manifold);
    if (question.ask == Ask::Separation) return answer_of_separation(*answer.manifold);
    return answer;
  }

 private:
  static std::size_t index_of(ShapeKind kind) { return static_cast<std::size_t>(kind); }

  std::array<std::array<bool, kShapeKinds.size()>, kShapeKinds.size()> knows_{};
  std::vector<std::unique_ptr<OdeShape>> shapes_;
  std::vector<std::unique_ptr<OdeShape>> others_;
};

class OdeEngine : public Engine {
 public:
  CaseWitness name() const override { return {"ode", dODE_VERSION}; }
  std::optional<std::vector<Ask>> questions() const override {
    return {{Ask::Any, Ask::Contacts, Ask::Separation}};
  }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    start_ode();
    return std::make_unique<OdePair>(mesh_a, mesh_b);
  }
  std::unique_ptr<LoadedShapes> load_shapes(std::span<const Shape> shapes) const override {
    start_ode();
    return std::make_unique<OdeShapes>(shapes);
  }
};

}  // namespace

std::unique_ptr<Engine> make_ode_engine() {
  return std::make_unique<OdeEngine>();
}

}  // namespace graze::compare
