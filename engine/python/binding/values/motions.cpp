#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/values/motions.h>

#include <graze/bvh/error.h>

namespace graze::python {
namespace {

RigidMotion make_motion(py::handle start, py::handle centre, py::handle shift, py::handle axis,
                        py::handle angle) {
  return {pose_from(start, "start"), RigidCourse{.centre = vector_from(centre, "centre"),
                                                 .shift = vector_from(shift, "shift"),
                                                 .axis = vector_from(axis, "axis"),
                                                 .angle = number_from(angle, "angle")}};
}

py::object poses_at(const RigidMotion& motion, py::handle times) {
  const py::array all = doubles(times, "t");
  if (all.ndim() == 0) return array_of(motion.at(*static_cast<const double*>(all.data())));
  if (all.ndim() != 1) throw InputError("t: is neither a number nor of the shape (n,)");
  auto poses = new_array<double>({all.shape(0), 4, 4});
  double* at = poses.mutable_data();
  for (py::ssize_t i = 0; i < all.shape(0); ++i) {
    const Pose pose = motion.at(*static_cast<const double*>(all.data(i)));
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column)
        *at++ = pose.matrix()(row, column);
    }
  }
  return poses;
}

py::tuple state_of(const RigidMotion& motion) {
  return py::make_tuple(array_of(motion.start()), array_of(motion.centre()),
                        array_of(motion.shift()), array_of(motion.axis()), motion.angle());
}

}  // namespace

RigidMotion motion_from(py::handle argument, const char* name) {
  if (py::isinstance<RigidMotion>(argument)) return argument.cast<const RigidMotion&>();
  return RigidMotion(pose_from(argument, name));
}

const char* word_of(RigidStatus status) {
  return status == RigidStatus::Free ? "free" : status == RigidStatus::Hit ? "hit" : "close";
}

RigidContactSettings contact_settings(py::handle clearance, py::handle tolerance,
                                      py::handle budget) {
  return {.clearance = number_from(clearance, "clearance"),
          .tolerance = number_from(tolerance, "tolerance"),
          .budget = count_from(budget, "budget")};
}

py::object result_of(const RigidContact& contact) {
  static const ResultType kType("RigidContact");
  return kType(word_of(contact.status), contact.low, contact.high, contact.is_out_of_budget);
}

namespace {

/// Adds other ways to say which motion is meant.
void add_makers(py::class_<RigidMotion>& type) {
  type.def_static(
          "between",
          [](py::handle start, py::handle end, py::handle centre) {
            return RigidMotion::between(pose_from(start, "start"), pose_from(end, "end"),
                                        vector_from(centre, "body_centre"));
          },
          "between(start, end, body_centre=(0, 0, 0))\n--\n\nFrom one pose to another: a point in "
          "the body's frame goes straight, "
          "and the body turns the short way round.",
          py::arg("start"), py::arg("end"), py::arg("body_centre") = py::make_tuple(0, 0, 0))
      .def_static(
          "screw_between",
          [](py::handle start, py::handle end) {
            return RigidMotion::screw_between(pose_from(start, "start"), pose_from(end, "end"));
          },
          "screw_between(start, end)\n--\n\nFrom one pose to another along and about one line.",
          py::arg("start"), py::arg("end"))
      .def_static(
          "screw",
          [](py::handle start, py::handle point, py::handle axis, double angle, double pitch) {
            return RigidMotion::screw(pose_from(start, "start"),
                                      {.point = vector_from(point, "point"),
                                       .axis = vector_from(axis, "axis"),
                                       .angle = angle,
                                       .pitch = pitch});
          },
          "screw(start, point, axis, angle, pitch)\n--\n\nFrom a pose along and about a line: "
          "radians, and metres for each turn.",
          py::arg("start"), py::arg("point"), py::arg("axis"), py::arg("angle"), py::arg("pitch"))
      .def_static(
          "from_velocities",
          [](py::handle start, py::handle linear, py::handle angular, py::handle centre,
             py::handle duration) {
            return RigidMotion::from_velocities(pose_from(start, "start"),
                                                {.linear = vector_from(linear, "linear"),
                                                 .angular = vector_from(angular, "angular"),
                                                 .body_centre = vector_from(centre, "body_centre"),
                                                 .duration = number_from(duration, "duration")});
          },
          "from_velocities(start, linear, angular=(0, 0, 0), body_centre=(0, 0, 0), "
          "duration=1.0)\n--\n\nFrom a pose with velocities that stay: metres and radians per "
          "second, in the common frame, for so many seconds; the point of the body's frame has the "
          "linear one.",
          py::arg("start"), py::arg("linear"), py::arg("angular") = py::make_tuple(0, 0, 0),
          py::arg("body_centre") = py::make_tuple(0, 0, 0), py::arg("duration") = 1.0);
}

/// Adds what is known of one motion.
void add_values(py::class_<RigidMotion>& type) {
  type.def("at", &poses_at,
           "at(self, t)\n--\n\nThe pose at t, from 0 to 1, or the poses at many, of the shape (n, "
           "4, 4). Raises InputError for "
           "another t.",
           py::arg("t"))
      .def("__eq__",
           [](const RigidMotion& motion, py::handle other) {
             return py::isinstance<RigidMotion>(other) &&
                    motion == other.cast<const RigidMotion&>();
           })
      .def_property_readonly(
          "start", [](const RigidMotion& motion) { return array_of(motion.start()); },
          "The pose at t = 0, of the shape (4, 4).")
      .def_property_readonly(
          "centre", [](const RigidMotion& motion) { return array_of(motion.centre()); },
          "The point that goes straight, at t = 0, common frame, metres, (3,).")
      .def_property_readonly(
          "shift", [](const RigidMotion& motion) { return array_of(motion.shift()); },
          "Of that point, metres, (3,).")
      .def_property_readonly(
          "axis", [](const RigidMotion& motion) { return array_of(motion.axis()); }, "Unit, (3,).")
      .def_property_readonly(
          "angle", [](const RigidMotion& motion) { return motion.angle(); }, "Radians.")
      .def("__reduce__", [](const py::object& self) {
        return py::make_tuple(py::type::of(self), state_of(self.cast<const RigidMotion&>()));
      });
}

}  // namespace

void add_rigid_motions(py::module_& module) {
  py::class_<RigidMotion> type(
      module, "RigidMotion",
      R"(A rigid motion while t goes from 0 to 1: a pose, and a course that it takes.

    RigidMotion(start, centre=(0, 0, 0), shift=(0, 0, 0), axis=(0, 0, 1), angle=0)

The point `centre`, in the common frame, goes straight by `shift`, metres, and the body turns about it by `angle`,
radians, around `axis`. With a start alone it rests. Can be pickled.

Raises PoseError and InputError.

>>> motion = graze.RigidMotion.between(np.eye(4), raised)
>>> motion.at([0, 0.5, 1])[:, 2, 3]
array([0.  , 0.75, 1.5 ])
)");
  type.def(py::init(&make_motion),
           "__init__(self, start, centre=(0, 0, 0), shift=(0, 0, 0), axis=(0, 0, 1), "
           "angle=0)\n--\n\nSee the class.",
           py::arg("start"), py::arg("centre") = py::make_tuple(0, 0, 0),
           py::arg("shift") = py::make_tuple(0, 0, 0), py::arg("axis") = py::make_tuple(0, 0, 1),
           py::arg("angle") = 0);
  add_makers(type);
  add_values(type);
}

}  // namespace graze::python
