#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/values/motions.h>

#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_motion.h>

#include <optional>

namespace graze::python {
namespace {

Placed unplaced(py::handle argument, const char* name) {
  if (PyTuple_Check(argument.ptr()))
    throw py::type_error(std::string(name) + ": has no pose; its motion says where it is");
  return {argument, name};
}

/// Two bodies, and one motion of A and one or many of B.
struct MotionQuestion {
  MotionQuestion(py::handle a_argument, py::handle motion_argument_a, py::handle b_argument,
                 py::handle motion_argument_b)
      : a(unplaced(a_argument, "a")),
        b(unplaced(b_argument, "b")),
        motion_a(motion_from(motion_argument_a, "motion_a")) {
    is_many =
        PyList_Check(motion_argument_b.ptr()) != 0 || PyTuple_Check(motion_argument_b.ptr()) != 0;
    if (!is_many) {
      motions_b.push_back(motion_from(motion_argument_b, "motion_b"));
      return;
    }
    motions_b.reserve(py::len(motion_argument_b));
    for (const py::handle motion : motion_argument_b)
      motions_b.push_back(
          motion_from(motion, ("motion_b[" + std::to_string(motions_b.size()) + "]").c_str()));
  }

  template <typename Answer, typename Ask>
  std::vector<Answer> answers(const Batch& batch, Work* work, const Ask& ask) const {
    // Motions differ a thousandfold in what they take, so that each is a part by itself.
    return ask_all<Answer>(
        is_many, motions_b.size(), batch, work,
        [&](std::size_t i, Work* own) { return ask(*this, motions_b[i], own); }, {}, 1);
  }

  bool are_meshes() const { return a.is_mesh() && b.is_mesh(); }

  Placed a;
  Placed b;
  RigidMotion motion_a;
  std::vector<RigidMotion> motions_b;
  bool is_many;
};

py::object first_contact_of(py::handle a, py::handle motion_a, py::handle b, py::handle motion_b,
                            py::handle clearance, py::handle tolerance, py::handle budget,
                            py::handle threads, py::handle progress, py::handle work) {
  static const ResultType kMany("RigidContacts");
  const MotionQuestion question(a, motion_a, b, motion_b);
  static_cast<void>(question.b.shape());  // made once, before threads ask for it
  static_cast<void>(question.a.shape());
  const RigidContactSettings settings = contact_settings(clearance, tolerance, budget);
  const auto answers = question.answers<RigidContact>(
      Batch(threads, progress), work_from(work),
      [&](const MotionQuestion& of, const RigidMotion& motion, Work* own) {
        return of.are_meshes()
                   ? first_contact(of.a.mesh(), of.motion_a, of.b.mesh(), motion, settings, own)
                   : first_contact(of.a.shape(), of.motion_a, of.b.shape(), motion, settings, own);
      });
  if (!question.is_many) return result_of(answers[0]);
  py::list words;
  for (const RigidContact& contact : answers)
    words.append(word_of(contact.status));
  return kMany(
      py::module_::import("numpy").attr("array")(words, "U5"),
      numbers_of<double>(answers, [](const auto& contact) { return contact.low; }),
      numbers_of<double>(answers, [](const auto& contact) { return contact.high; }),
      numbers_of<bool>(answers, [](const auto& contact) { return contact.is_out_of_budget; }));
}

py::object is_free_of(py::handle a, py::handle motion_a, py::handle b, py::handle motion_b,
                      py::handle clearance, py::handle tolerance, py::handle budget,
                      py::handle threads, py::handle progress, py::handle work) {
  const MotionQuestion question(a, motion_a, b, motion_b);
  static_cast<void>(question.b.shape());
  static_cast<void>(question.a.shape());
  const RigidContactSettings settings = contact_settings(clearance, tolerance, budget);
  const auto answers = question.answers<char>(
      Batch(threads, progress), work_from(work),
      [&](const MotionQuestion& of, const RigidMotion& motion, Work* own) {
        return static_cast<char>(
            of.are_meshes()
                ? is_free(of.a.mesh(), of.motion_a, of.b.mesh(), motion, settings, own)
                : is_free(of.a.shape(), of.motion_a, of.b.shape(), motion, settings, own));
      });
  if (!question.is_many) return py::bool_(answers[0] != 0);
  return numbers_of<bool>(answers, [](char says) { return says != 0; });
}

py::object last_free_of(const Mesh& a, py::handle motion_a, const Mesh& b, py::handle motion_b,
                        py::handle clearance, py::handle tolerance, py::handle budget,
                        py::handle work_argument) {
  const RigidMotion course_a = motion_from(motion_a, "motion_a");
  const RigidMotion course_b = motion_from(motion_b, "motion_b");
  const RigidContactSettings settings = contact_settings(clearance, tolerance, budget);
  Work* work = work_from(work_argument);
  std::optional<double> found;
  {
    const py::gil_scoped_release released;
    found = last_free(a, course_a, b, course_b, settings, work);
  }
  return found ? py::object(py::float_(*found)) : py::none();
}

py::object cast_of(py::handle a, py::handle b, py::handle displacement, py::handle start,
                   py::handle work_argument) {
  static const ResultType kMeshType("MeshCast");
  static const ResultType kShapeType("ShapeCast");
  const PlacedPair pair(a, b);
  if (pair.is_many()) throw InputError("cast() takes one pose");
  const Eigen::Vector3d way = vector_from(displacement, "displacement");
  const CastSettings settings{.start = start_from(start)};
  Work* work = work_from(work_argument);
  if (pair.are_meshes()) {
    std::optional<MeshCast> met;
    {
      const py::gil_scoped_release released;
      met = cast(pair.a.mesh_at(0), pair.b.mesh_at(0), way, settings, work);
    }
    if (!met) return py::none();
    return kMeshType(met->time, met->is_at_start, py::make_tuple(met->pair.a, met->pair.b),
                     array_of(met->point), array_of(met->normal));
  }
  if (settings.start != StartContact::Counts) throw InputError("start: is for two meshes");
  std::optional<ShapeCast> met;
  {
    const py::gil_scoped_release released;
    met = cast(pair.a.shape_at(0), pair.b.shape_at(0), way, work);
  }
  if (!met) return py::none();
  return kShapeType(met->time, met->is_at_start, array_of(met->point), array_of(met->normal));
}

constexpr const char* kFirstContactText =
    R"(first_contact(a, motion_a, b, motion_b, *, clearance=0.0, tolerance=1e-06, budget=16777216, threads=0, progress=None, work=None)
--

When two meshes or shapes in rigid motion meet first, never late: a RigidContact. `status` is "free", which is
proved for all times from 0 to 1, "hit", of which `high` is a witness, or "close"; there is no contact before `low`.

Motions are RigidMotions, or poses of what rests. With a list of many for B the answer is RigidContacts: arrays, on
all threads. What is not further apart than `clearance`, metres, counts as a hit; what comes within `tolerance`
beyond it is not called free.

Raises InputError and PoseError.

>>> down = graze.RigidMotion.between(raised, np.eye(4))
>>> met = graze.first_contact(graze.Box([1, 1, 0.5]), np.eye(4), graze.Box([1, 1, 0.5]), down)
>>> met.status, round(met.low, 3)
('hit', 0.333)
)";

constexpr const char* kIsFreeText =
    R"(is_free(a, motion_a, b, motion_b, *, clearance=0.0, tolerance=1e-06, budget=16777216, threads=0, progress=None, work=None)
--

Whether first_contact() says "free": a bool, or with a list of motions of B an array.

>>> graze.is_free(bolt, np.eye(4), nut, far)
True
)";

constexpr const char* kCastText = R"(cast(a, b, displacement, *, start='counts', work=None)
--

When placed B, moved straight by t `displacement`, metres, t from 0 to 1, meets A first: a MeshCast, or a ShapeCast
where one is another shape than a mesh, or None if it never does. Of two meshes it is exact, and never late. With
`start` "is_left" what merely touches at t = 0 may leave.

Raises InputError for a displacement that is not finite, and what intersects() raises.

>>> graze.cast(bolt, (nut, far), [-1, 0, 0]).time < 1
True
)";

}  // namespace

void add_motions(py::module_& module) {
  const auto add = [&](const char* name, auto* function, const char* text) {
    module.def(name, function, text, py::arg("a"), py::arg("motion_a"), py::arg("b"),
               py::arg("motion_b"), py::kw_only(), py::arg("clearance") = 0.0,
               py::arg("tolerance") = 1e-6, py::arg("budget") = std::size_t{1} << 24,
               py::arg("threads") = 0, py::arg("progress") = py::none(),
               py::arg("work") = py::none());
  };
  add("first_contact", &first_contact_of, kFirstContactText);
  add("is_free", &is_free_of, kIsFreeText);
  module.def(
      "last_free", &last_free_of,
      R"(last_free(a, motion_a, b, motion_b, *, clearance=0.0, tolerance=1e-06, budget=16777216, work=None)
--

The last time up to which two meshes are proved to stay apart, 1.0 if that is so to the end; None if they are too near at
the start.

>>> graze.last_free(bolt, np.eye(4), nut, far)
1.0
)",
      py::arg("a"), py::arg("motion_a"), py::arg("b"), py::arg("motion_b"), py::kw_only(),
      py::arg("clearance") = 0.0, py::arg("tolerance") = 1e-6,
      py::arg("budget") = std::size_t{1} << 24, py::arg("work") = py::none());
  module.def("cast", &cast_of, kCastText, py::arg("a"), py::arg("b"), py::arg("displacement"),
             py::kw_only(), py::arg("start") = "counts", py::arg("work") = py::none());
}

}  // namespace graze::python
