#include <graze/engine/python/binding/arguments/placed.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/values/motions.h>

#include <graze/bvh/error.h>

#include <string>
#include <utility>

namespace graze::python {
namespace {

/// Counts how many elements arguments have, each of which may be one for all.
class CommonCount {
 public:
  void add(bool are_many, std::size_t count, const char* name) {
    if (!are_many) return;
    if (first_ != nullptr && count != count_) {
      throw InputError(std::string(name) + ": are " + std::to_string(count) + ", and there are " +
                       std::to_string(count_) + " of " + first_);
    }
    if (first_ == nullptr) first_ = name;
    count_ = count;
  }
  std::size_t count() const { return count_; }

 private:
  const char* first_ = nullptr;
  std::size_t count_ = 1;
};

/// Holds a number for all, or one for each.
class NumberOrMany {
 public:
  NumberOrMany(py::handle argument, const char* name) : array_(doubles(argument, name)) {
    if (array_.ndim() > 1)
      throw InputError(std::string(name) + ": is neither a number nor of the shape (n,)");
  }
  bool is_many() const { return array_.ndim() == 1; }
  std::size_t size() const { return is_many() ? static_cast<std::size_t>(array_.shape(0)) : 1; }
  double operator[](std::size_t i) const {
    const char* at = static_cast<const char*>(array_.data());
    return *reinterpret_cast<const double*>(
        is_many() ? at + static_cast<py::ssize_t>(i) * array_.strides(0) : at);
  }

 private:
  py::array array_;
};

template <typename Elements>
auto own_or_common(const Elements& elements, std::size_t i) {
  return elements[elements.is_many() ? i : 0];
}

/// Calls `make(i)` for each motion; what it throws names the motion.
template <typename Make>
MotionArray make_motions(std::size_t count, const Make& make) {
  const py::gil_scoped_release released;
  MotionArray made;
  made.all.reserve(count);
  const auto words = [&](const Error& error) {
    return "motion " + std::to_string(made.all.size()) + ": " + error.what();
  };
  const auto place = [&] { return ErrorPlace{.element = "motion", .index = made.all.size()}; };
  try {
    while (made.all.size() < count)
      made.all.push_back(make(made.all.size()));
  } catch (const PoseError& error) {
    throw PoseError(words(error), place());
  } catch (const InputError& error) {
    throw InputError(words(error), place());
  }
  return made;
}

MotionArray make_courses(py::handle start, py::handle centre, py::handle shift, py::handle axis,
                         py::handle angle) {
  const Poses starts(start, "start");
  const Points centres(centre, "centre"), shifts(shift, "shift"), axes(axis, "axis");
  const NumberOrMany angles(angle, "angle");
  CommonCount common;
  common.add(starts.is_many(), starts.size(), "start");
  common.add(centres.is_many(), centres.size(), "centre");
  common.add(shifts.is_many(), shifts.size(), "shift");
  common.add(axes.is_many(), axes.size(), "axis");
  common.add(angles.is_many(), angles.size(), "angle");
  return make_motions(common.count(), [&](std::size_t i) {
    return RigidMotion(own_or_common(starts, i), RigidCourse{.centre = own_or_common(centres, i),
                                                             .shift = own_or_common(shifts, i),
                                                             .axis = own_or_common(axes, i),
                                                             .angle = own_or_common(angles, i)});
  });
}

MotionArray make_between(py::handle start, py::handle end, py::handle body_centre) {
  const Poses starts(start, "start"), ends(end, "end");
  const Points centres(body_centre, "body_centre");
  CommonCount common;
  common.add(starts.is_many(), starts.size(), "start");
  common.add(ends.is_many(), ends.size(), "end");
  common.add(centres.is_many(), centres.size(), "body_centre");
  return make_motions(common.count(), [&](std::size_t i) {
    return RigidMotion::between(own_or_common(starts, i), own_or_common(ends, i),
                                own_or_common(centres, i));
  });
}

MotionArray make_screws_between(py::handle start, py::handle end) {
  const Poses starts(start, "start"), ends(end, "end");
  CommonCount common;
  common.add(starts.is_many(), starts.size(), "start");
  common.add(ends.is_many(), ends.size(), "end");
  return make_motions(common.count(), [&](std::size_t i) {
    return RigidMotion::screw_between(own_or_common(starts, i), own_or_common(ends, i));
  });
}

/// Writes a pose row by row.
double* write_rows(const Pose& pose, double* at) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      *at++ = pose.matrix()(row, column);
  }
  return at;
}

template <typename Pose_of>
py::object pose_array_of(const MotionArray& motions, const Pose_of& pose_of) {
  auto poses = new_array<double>({static_cast<py::ssize_t>(motions.all.size()), 4, 4});
  double* at = poses.mutable_data();
  for (std::size_t i = 0; i < motions.all.size(); ++i)
    at = write_rows(pose_of(motions.all[i], i), at);
  return poses;
}

template <typename Member>
py::object vectors_of(const MotionArray& motions, const Member& member) {
  auto rows = new_array<double>({static_cast<py::ssize_t>(motions.all.size()), 3});
  double* at = rows.mutable_data();
  for (const RigidMotion& motion : motions.all) {
    write(member(motion), at);
    at += 3;
  }
  return rows;
}

py::object starts_of(const MotionArray& motions) {
  return pose_array_of(motions,
                       [](const RigidMotion& motion, std::size_t) { return motion.start(); });
}
py::object centres_of(const MotionArray& motions) {
  return vectors_of(motions, [](const RigidMotion& motion) { return motion.centre(); });
}
py::object shifts_of(const MotionArray& motions) {
  return vectors_of(motions, [](const RigidMotion& motion) { return motion.shift(); });
}
py::object axes_of(const MotionArray& motions) {
  return vectors_of(motions, [](const RigidMotion& motion) { return motion.axis(); });
}
py::object angles_of(const MotionArray& motions) {
  auto angles = new_array<double>({static_cast<py::ssize_t>(motions.all.size())});
  double* at = angles.mutable_data();
  for (const RigidMotion& motion : motions.all)
    *at++ = motion.angle();
  return angles;
}

py::object poses_of_all_at(const MotionArray& motions, py::handle t) {
  const NumberOrMany times(t, "t");
  if (times.is_many() && times.size() != motions.all.size()) {
    throw InputError("t: are " + std::to_string(times.size()) + ", and there are " +
                     std::to_string(motions.all.size()) + " motions");
  }
  return pose_array_of(motions, [&](const RigidMotion& motion, std::size_t i) {
    return motion.at(own_or_common(times, i));
  });
}

RigidMotion motion_at(const MotionArray& motions, py::handle argument) {
  const auto count = static_cast<py::ssize_t>(motions.all.size());
  const py::ssize_t index = PyNumber_AsSsize_t(argument.ptr(), PyExc_IndexError);
  if (index == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
  if (index < -count || index >= count)
    throw py::index_error("motion " + std::to_string(index) + " of " + std::to_string(count));
  return motions.all[static_cast<std::size_t>(index < 0 ? index + count : index)];
}

constexpr const char* kMotionArrayText =
    R"(Many rigid motions, made of arrays at once: what takes a list of motions takes these.

    RigidMotions(start, centre=(0, 0, 0), shift=(0, 0, 0), axis=(0, 0, 1), angle=0)

The arguments are those of RigidMotion(), each one for all or n: poses of the shape (n, 4, 4) or (n, 3, 4), vectors of
(n, 3), angles of (n,). `shift` alone makes translations. An item is a RigidMotion. Can be pickled.

Raises PoseError and InputError, with the index of the motion.

>>> motions = graze.RigidMotions(raised, shift=[[0, 0, -1], [0, 0, -2]])
>>> motions.at(1)[:, 2, 3]
array([ 0.5, -0.5])
>>> [motion.shift[2] for motion in motions]
[-1.0, -2.0]
)";

}  // namespace

const std::vector<RigidMotion>* motions_in(py::handle argument) {
  if (!py::isinstance<MotionArray>(argument)) return nullptr;
  return &argument.cast<const MotionArray&>().all;
}

void add_motion_arrays(py::module_& module) {
  const auto origin = py::make_tuple(0, 0, 0);
  py::class_<MotionArray>(module, "RigidMotions", kMotionArrayText)
      .def(py::init(&make_courses),
           "__init__(self, start, centre=(0, 0, 0), shift=(0, 0, 0), axis=(0, 0, 1), angle=0)",
           py::arg("start"), py::arg("centre") = origin, py::arg("shift") = origin,
           py::arg("axis") = py::make_tuple(0, 0, 1), py::arg("angle") = 0)
      .def_static("between", &make_between,
                  "between(start, end, body_centre=(0, 0, 0))\n--\n\nFrom poses to others, as "
                  "RigidMotion.between(); each argument one for all, or n.",
                  py::arg("start"), py::arg("end"), py::arg("body_centre") = origin)
      .def_static("screw_between", &make_screws_between,
                  "screw_between(start, end)\n--\n\nFrom poses to others along and about one line "
                  "each; each argument one for all, or n.",
                  py::arg("start"), py::arg("end"))
      .def("at", &poses_of_all_at,
           "at(self, t)\n--\n\nThe poses at t, from 0 to 1, one time for all or one for each: of "
           "the shape (n, 4, 4). Raises InputError for another t.",
           py::arg("t"))
      .def("__len__", [](const MotionArray& motions) { return motions.all.size(); })
      .def("__getitem__", &motion_at, py::arg("index"))
      .def("__eq__",
           [](const MotionArray& motions, py::handle other) {
             const auto* others = motions_in(other);
             return others != nullptr && motions.all == *others;
           })
      .def_property_readonly("start", &starts_of, "The poses at t = 0, (n, 4, 4).")
      .def_property_readonly("centre", &centres_of,
                             "The points that go straight, at t = 0, common frame, metres, (n, 3).")
      .def_property_readonly("shift", &shifts_of, "Of those points, metres, (n, 3).")
      .def_property_readonly("axis", &axes_of, "Unit, (n, 3).")
      .def_property_readonly("angle", &angles_of, "Radians, (n,).")
      .def("__reduce__", [](const py::object& self) {
        const auto& motions = self.cast<const MotionArray&>();
        return py::make_tuple(
            py::type::of(self),
            py::make_tuple(starts_of(motions), centres_of(motions), shifts_of(motions),
                           axes_of(motions), angles_of(motions)));
      });
}

}  // namespace graze::python
