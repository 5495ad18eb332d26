// FCL for Python, as thin as a binding can be: what its C++ library takes in a loop of Python, with
// no objects made for each pose. pairs = graze_benchmark_fcl.Pair("bolt.obj", "nut.stl").

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <graze/engine/mesh/load_mesh.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "tests/benchmark/common/fcl_models.h"

namespace {

namespace py = pybind11;

using Poses = py::array_t<double, py::array::c_style>;

/// Two meshes under FCL's trees of OBBRSS, the first of which stands where it is.
class FclPair {
 public:
  FclPair(const std::string& file_a, const std::string& file_b)
      : mesh_a_(graze::benchmark::to_fcl<fcl::OBBRSSd>(graze::load_mesh(file_a))),
        mesh_b_(graze::benchmark::to_fcl<fcl::OBBRSSd>(graze::load_mesh(file_b))) {}

  /// collide() with its defaults: one contact, and no geometry of it.
  bool collide(const Poses& pose) const {
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    fcl::collide(mesh_a_.get(), fcl::Transform3d::Identity(), mesh_b_.get(), placed(pose), request,
                 result);
    return result.isCollision();
  }

  /// distance(), 0 where they intersect.
  double distance(const Poses& pose) const {
    const fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    fcl::distance(mesh_a_.get(), fcl::Transform3d::Identity(), mesh_b_.get(), placed(pose), request,
                  result);
    return std::max(result.min_distance, 0.0);
  }

 private:
  static fcl::Transform3d placed(const Poses& pose) {
    if (pose.ndim() != 2 || pose.shape(0) != 4 || pose.shape(1) != 4)
      throw std::invalid_argument("pose: not of the shape (4, 4)");
    using Rows = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
    fcl::Transform3d transform;
    transform.matrix() = Eigen::Map<const Rows>(pose.data());
    return transform;
  }

  std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> mesh_a_;
  std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> mesh_b_;
};

}  // namespace

PYBIND11_MODULE(graze_benchmark_fcl, module) {
  py::class_<FclPair>(module, "Pair")
      .def(py::init<std::string, std::string>())
      .def("collide", &FclPair::collide)
      .def("distance", &FclPair::distance);
}
