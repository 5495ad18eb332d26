// ODE behind the page that every engine has: dCollide() of two trimeshes, in double. ODE keeps
// caches in its geoms, so that one thread at a time may ask.

#include <graze/engine/compare/peers/engine.h>

#include <ode/ode.h>
#include <algorithm>
#include <cstdarg>
#include <mutex>

namespace graze::compare {
namespace {

constexpr int kMaxContacts = 0x7fff;  // what the flags of dCollide() have room for

/// What ODE would print of its hash tables: nothing that changes an answer.
void be_silent(int, const char*, va_list) {}

void start_ode() {
  static const bool kIsStarted = [] {
    dInitODE2(0);
    dSetMessageHandler(be_silent);
    return true;
  }();
  static_cast<void>(kIsStarted);
  thread_local const bool kHasThreadData = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
  static_cast<void>(kHasThreadData);
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

  dGeomID place(const Pose& pose) const {
    dMatrix3 rotation;  // rows of four
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column)
        rotation[4 * row + column] = column == 3 ? 0 : pose(row, column);
    }
    dGeomSetPosition(geom_, pose(0, 3), pose(1, 3), pose(2, 3));
    dGeomSetRotation(geom_, rotation);
    return geom_;
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
    if (question.settings.touch == Touch::Exclude) return std::nullopt;
    if (question.settings.interior == Interior::Solid) return std::nullopt;
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
    const std::lock_guard lock(mutex_);
    start_ode();
    std::vector<dContactGeom> contacts(static_cast<std::size_t>(flags & 0xffff));
    const int count = dCollide(mesh_a_.place(pose_a), mesh_b_.place(pose_b), flags, contacts.data(),
                               sizeof(dContactGeom));
    contacts.resize(static_cast<std::size_t>(std::max(count, 0)));
    return contacts;
  }

  mutable std::mutex mutex_;
  OdeMesh mesh_a_;
  OdeMesh mesh_b_;
};

class OdeEngine : public Engine {
 public:
  CaseWitness name() const override { return {"ode", ""}; }
  std::unique_ptr<LoadedPair> load(const Mesh& mesh_a, const Mesh& mesh_b) const override {
    start_ode();
    return std::make_unique<OdePair>(mesh_a, mesh_b);
  }
};

}  // namespace

std::unique_ptr<Engine> make_ode_engine() {
  return std::make_unique<OdeEngine>();
}

}  // namespace graze::compare
