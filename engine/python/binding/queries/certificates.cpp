#include <graze/engine/python/binding/arguments/batch.h>
#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/values/motions.h>

#include <graze/engine/mesh/rigid_certificate.h>

#include <optional>
#include <string>

namespace graze::python {
namespace {

py::object certificate_of(FreedomCertificate&& certificate) {
  static const ResultType kType("FreedomCertificate");
  const auto& steps = certificate.steps;
  return kType(certificate.clearance, array_over<std::uint32_t>(std::move(certificate.order_a)),
               array_over<std::uint32_t>(std::move(certificate.order_b)),
               numbers_of<std::uint8_t>(steps, [](const auto& step) { return step.kind; }),
               numbers_of<std::uint32_t>(steps, [](const auto& step) { return step.count; }),
               points_of(steps, [](const auto& step) { return step.normal; }));
}

std::vector<std::uint32_t> indices_from(py::handle argument, const char* name) {
  const auto array = py::array_t<std::uint32_t, py::array::c_style>::ensure(argument);
  if (!array || array.ndim() != 1) {
    PyErr_Clear();
    throw py::type_error("certificate: " + std::string(name) + " is no array of indices");
  }
  return {array.data(), array.data() + array.size()};
}

FreedomCertificate certificate_from(py::handle argument) {
  if (PyTuple_Check(argument.ptr()) == 0 || py::len(argument) != 6)
    throw py::type_error("certificate: is no graze.FreedomCertificate");
  const auto members = py::reinterpret_borrow<py::tuple>(argument);
  FreedomCertificate certificate{.clearance = number_from(members[0], "certificate: clearance"),
                                 .order_a = indices_from(members[1], "order_a"),
                                 .order_b = indices_from(members[2], "order_b"),
                                 .steps = {}};
  const std::vector<std::uint32_t> kinds = indices_from(members[3], "kind");
  const std::vector<std::uint32_t> counts = indices_from(members[4], "size");
  const Points normals(members[5], "certificate: normal");
  if (counts.size() != kinds.size() || normals.size() != kinds.size() || !normals.is_many())
    throw InputError("certificate: has not as many kinds, sizes and normals");
  certificate.steps.reserve(kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] > 3) throw InputError("certificate: a kind of step is none from 0 to 3");
    certificate.steps.push_back({static_cast<FreedomStep::Kind>(kinds[i]), counts[i], normals[i]});
  }
  return certificate;
}

py::object certify(const Mesh& a, py::handle motion_a, const Mesh& b, py::handle motion_b,
                   py::handle clearance, py::handle tolerance, py::handle budget,
                   py::handle work_argument) {
  const RigidMotion course_a = motion_from(motion_a, "motion_a");
  const RigidMotion course_b = motion_from(motion_b, "motion_b");
  const RigidContactSettings settings = contact_settings(clearance, tolerance, budget);
  Work* work = work_from(work_argument);
  std::optional<FreedomCertificate> found;
  {
    const py::gil_scoped_release released;
    found = certify_free({a, course_a}, {b, course_b}, settings, work);
  }
  return found ? certificate_of(std::move(*found)) : py::none();
}

bool proves(py::handle argument, const Mesh& a, py::handle motion_a, const Mesh& b,
            py::handle motion_b) {
  const FreedomCertificate certificate = certificate_from(argument);
  const RigidMotion course_a = motion_from(motion_a, "motion_a");
  const RigidMotion course_b = motion_from(motion_b, "motion_b");
  const py::gil_scoped_release released;
  return proves_freedom(certificate, {a, course_a}, {b, course_b});
}

constexpr const char* kCertifyText =
    R"(certify_free(a, motion_a, b, motion_b, *, clearance=0.0, tolerance=1e-06, budget=16777216, work=None)
--

The proof for what is_free() says of two meshes: a FreedomCertificate, or None where it says no. Plain arrays, which can be
kept, sent, pickled, and checked by proves_freedom().

Raises what first_contact() raises.

>>> proof = graze.certify_free(bolt, np.eye(4), nut, far)
>>> graze.proves_freedom(proof, bolt, np.eye(4), nut, far)
True
>>> graze.certify_free(bolt, np.eye(4), nut, pose) is None
True
)";

constexpr const char* kProvesText = R"(proves_freedom(certificate, a, motion_a, b, motion_b)
--

Whether a certificate proves that two meshes in these motions stay further apart than its clearance at all times, whoever
made it. What is broken in any way proves nothing.
)";

}  // namespace

void add_certificates(py::module_& module) {
  module.def("certify_free", &certify, kCertifyText, py::arg("a"), py::arg("motion_a"),
             py::arg("b"), py::arg("motion_b"), py::kw_only(), py::arg("clearance") = 0.0,
             py::arg("tolerance") = 1e-6, py::arg("budget") = std::size_t{1} << 24,
             py::arg("work") = py::none());
  module.def("proves_freedom", &proves, kProvesText, py::arg("certificate"), py::arg("a"),
             py::arg("motion_a"), py::arg("b"), py::arg("motion_b"));
}

}  // namespace graze::python
