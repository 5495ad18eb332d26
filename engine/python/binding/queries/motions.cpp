#include <graze/engine/python/binding/arguments/results.h>
#include <graze/engine/python/binding/arguments/settings.h>
#include <graze/engine/python/binding/module.h>
#include <graze/engine/python/binding/queries/answers.h>
#include <graze/engine/python/binding/queries/rigid_contacts.h>
#include <graze/engine/python/binding/values/motions.h>

#include <graze/engine/mesh/mesh_cast.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/shape_cast.h>
#include <graze/engine/world/shape_motion.h>

#include <graze/bvh/value/element_error.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace graze::python {
namespace {

Placed unplaced(py::handle argument, const char* name) {
  if (PyTuple_Check(argument.ptr()))
    throw py::type_error(std::string(name) + ": has no pose; its motion says where it is");
  return {argument, name};
}

/// Holds two bodies, and one motion of A and one or many of B.
struct MotionQuestion {
  MotionQuestion(py::handle a_argument, py::handle motion_argument_a, py::handle b_argument,
                 py::handle motion_argument_b)
      : a(unplaced(a_argument, "a")),
        b(unplaced(b_argument, "b")),
        motion_a(motion_from(motion_argument_a, "motion_a")),
        motions_b(motion_argument_b, "motion_b") {}

  template <typename Answer, typename Ask>
  std::vector<Answer> answers(const Batch& batch, Work* work, const Ask& ask) const {
    // Motions take times that differ a thousandfold, so that each is a part by itself.
    return ask_all<Answer>(
        motions_b.is_many(), motions_b.size(), batch, work,
        [&](std::size_t i, Work* own) { return ask(*this, motions_b[i], own); }, {}, 1);
  }

  bool are_meshes() const { return a.is_mesh() && b.is_mesh(); }

  Placed a;
  Placed b;
  RigidMotion motion_a;
  Motions motions_b;
};

py::object first_contact_of(py::handle a, py::handle motion_a, py::handle b, py::handle motion_b,
                            py::handle clearance, py::handle tolerance, py::handle budget,
                            py::handle threads, py::handle progress, py::handle work) {
  const MotionQuestion question(a, motion_a, b, motion_b);
  static_cast<void>(question.b.shape());  // is made once, before threads ask for it
  static_cast<void>(question.a.shape());
  const RigidContactSettings settings = contact_settings(clearance, tolerance, budget);
  const auto answers = question.answers<RigidContact>(
      Batch(threads, progress), work_from(work),
      [&](const MotionQuestion& of, const RigidMotion& motion, Work* own) {
        return of.are_meshes()
                   ? first_contact({of.a.mesh(), of.motion_a}, {of.b.mesh(), motion}, settings, own)
                   : first_contact({of.a.shape(), of.motion_a}, {of.b.shape(), motion}, settings,
                                   own);
      });
  if (!question.motions_b.is_many()) return result_of(answers[0]);
  return result_of(answers);
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
                ? is_free({of.a.mesh(), of.motion_a}, {of.b.mesh(), motion}, settings, own)
                : is_free({of.a.shape(), of.motion_a}, {of.b.shape(), motion}, settings, own));
      });
  if (!question.motions_b.is_many()) return py::bool_(answers[0] != 0);
  return numbers_of<bool>(answers, [](char says) { return says != 0; });
}

py::object last_free_of(py::handle a, py::handle motion_a, py::handle b, py::handle motion_b,
                        py::handle clearance, py::handle tolerance, py::handle budget,
                        py::handle threads, py::handle progress, py::handle work) {
  const MotionQuestion question(a, motion_a, b, motion_b);
  if (!question.are_meshes()) throw py::type_error("last_free() is asked about meshes");
  const RigidContactSettings settings = contact_settings(clearance, tolerance, budget);
  const auto answers = question.answers<std::optional<double>>(
      Batch(threads, progress), work_from(work),
      [&](const MotionQuestion& of, const RigidMotion& motion, Work* own) {
        return last_free({of.a.mesh(), of.motion_a}, {of.b.mesh(), motion}, settings, own);
      });
  if (question.motions_b.is_many()) {
    return numbers_of<double>(answers, [](const auto& time) {
      return time.value_or(std::numeric_limits<double>::quiet_NaN());
    });
  }
  return answers[0] ? py::object(py::float_(*answers[0])) : py::none();
}

/// Holds one displacement for all poses, or one for each.
class Displacements {
 public:
  Displacements(py::handle argument, const PlacedPair& pair)
      : points_(argument, "displacement"),
        is_many_(points_.is_many() || pair.is_many()),
        size_(points_.is_many() ? points_.size() : pair.size()) {
    if (points_.is_many() && pair.is_many() && points_.size() != pair.size()) {
      throw InputError("displacement: are " + std::to_string(points_.size()) + ", and there are " +
                       std::to_string(pair.size()) + " poses");
    }
  }

  bool is_many() const { return is_many_; }
  std::size_t size() const { return size_; }
  Eigen::Vector3d operator[](std::size_t i) const { return points_[points_.is_many() ? i : 0]; }

  /// Throws for the first displacement that is not finite, and then for the first bad pose.
  void blame(const PlacedPair& pair) const {
    for (std::size_t i = 0; points_.is_many() && i < size_; ++i) {
      bvh::at_element("displacement", i, [&] {
        if (!points_[i].allFinite())
          throw InputError("displacement: " + std::to_string(i) + " is not finite");
      });
    }
    pair.check_poses();
  }

 private:
  Points points_;
  bool is_many_;
  std::size_t size_;
};

/// Returns the members that casts of meshes and of shapes have, with `pair` between them.
template <typename Cast>
py::object casts_of(const std::vector<std::optional<Cast>>& answers, const ResultType& type,
                    const py::object& pairs) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d nowhere(kNone, kNone, kNone);
  return type(
      numbers_of<bool>(answers, [](const auto& met) { return met.has_value(); }),
      numbers_of<double>(answers, [](const auto& met) { return met ? met->time : kNone; }),
      numbers_of<bool>(answers, [](const auto& met) { return met && met->is_at_start; }), pairs,
      points_of(answers,
                [&](const auto& met) -> Eigen::Vector3d { return met ? met->point : nowhere; }),
      points_of(answers,
                [&](const auto& met) -> Eigen::Vector3d { return met ? met->normal : nowhere; }));
}

py::object casts_of_meshes(const PlacedPair& pair, const Displacements& displacements,
                           const CastSettings& settings, const Batch& batch, Work* work) {
  static const ResultType kSingle("MeshCast");
  static const ResultType kMany("Casts");
  const auto answers = ask_all<std::optional<MeshCast>>(
      displacements.is_many(), displacements.size(), batch, work,
      [&](std::size_t i, Work* own) {
        return cast(pair.a.mesh_at(i), pair.b.mesh_at(i), displacements[i], settings, own);
      },
      [&] { displacements.blame(pair); });
  if (displacements.is_many()) {
    auto pairs = new_array<std::int64_t>({static_cast<py::ssize_t>(answers.size()), 2});
    std::int64_t* at = pairs.mutable_data();
    for (const auto& met : answers) {
      *at++ = met ? static_cast<std::int64_t>(met->pair.a) : -1;
      *at++ = met ? static_cast<std::int64_t>(met->pair.b) : -1;
    }
    return casts_of(answers, kMany, pairs);
  }
  const auto& met = answers[0];
  if (!met) return py::none();
  return kSingle(met->time, met->is_at_start, py::make_tuple(met->pair.a, met->pair.b),
                 array_of(met->point), array_of(met->normal));
}

py::object casts_of_shapes(const PlacedPair& pair, const Displacements& displacements,
                           const Batch& batch, Work* work) {
  static const ResultType kSingle("ShapeCast");
  static const ResultType kMany("Casts");
  const auto answers = ask_all<std::optional<ShapeCast>>(
      displacements.is_many(), displacements.size(), batch, work,
      [&](std::size_t i, Work* own) {
        return cast(pair.a.shape_at(i), pair.b.shape_at(i), displacements[i], own);
      },
      [&] { displacements.blame(pair); });
  if (displacements.is_many()) return casts_of(answers, kMany, py::none());
  const auto& met = answers[0];
  if (!met) return py::none();
  return kSingle(met->time, met->is_at_start, array_of(met->point), array_of(met->normal));
}

py::object cast_of(py::handle a, py::handle b, py::handle displacement, py::handle start,
                   py::handle threads, py::handle progress, py::handle work) {
  const PlacedPair pair(a, b);
  const Displacements displacements(displacement, pair);
  const CastSettings settings{.start = start_from(start)};
  const Batch batch(threads, progress);
  if (pair.are_meshes())
    return casts_of_meshes(pair, displacements, settings, batch, work_from(work));
  if (settings.start != StartContact::Counts) throw InputError("start: is for two meshes");
  return casts_of_shapes(pair, displacements, batch, work_from(work));
}

/// Returns an array of the words, of which numpy keeps four bytes a letter, up to zeros.
py::array words_of(const std::vector<RigidContact>& answers) {
  constexpr std::size_t kLetters = 5;
  py::array words(py::dtype("U5"),
                  std::vector<py::ssize_t>{static_cast<py::ssize_t>(answers.size())});
  auto* at = static_cast<char32_t*>(words.mutable_data());
  for (const RigidContact& contact : answers) {
    const std::string_view word = word_of(contact.status);
    std::fill_n(std::copy(word.begin(), word.end(), at), kLetters - word.size(), U'\0');
    at += kLetters;
  }
  return words;
}

constexpr const char* kFirstContactText =
    R"(first_contact(a, motion_a, b, motion_b, *, clearance=0.0, tolerance=1e-06, budget=16777216, threads=0, progress=None, work=None)
--

When two meshes or shapes in rigid motion meet first, never late: a RigidContact. `status` is "free", which is
proved for all times from 0 to 1, "hit", of which `high` is a witness, or "close"; there is no contact before `low`.

Motions are RigidMotions, or poses of what rests. With RigidMotions or a list of many for B the answer is RigidContacts: arrays, on
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

Whether first_contact() says "free": a bool, or with many motions of B an array.

>>> graze.is_free(bolt, np.eye(4), nut, far)
True
)";

constexpr const char* kLastFreeText =
    R"(last_free(a, motion_a, b, motion_b, *, clearance=0.0, tolerance=1e-06, budget=16777216, threads=0, progress=None, work=None)
--

The last time up to which two meshes are proved to stay apart, 1.0 if that is so to the end; None if they are too near at
the start. With many motions of B an array, in which that is NaN.

>>> graze.last_free(bolt, np.eye(4), nut, far)
1.0
)";

constexpr const char* kCastText =
    R"(cast(a, b, displacement, *, start='counts', threads=0, progress=None, work=None)
--

When placed B, moved straight by t `displacement`, metres, t from 0 to 1, meets A first: a MeshCast, or a ShapeCast
where one is another shape than a mesh, or None if it never does. Of two meshes it is exact, and never late. With
`start` "is_left" what merely touches at t = 0 may leave. With many poses, or displacements of the shape (n, 3), or as
many of both, Casts: arrays.

Raises InputError for a displacement that is not finite, and what intersects() raises.

>>> graze.cast(bolt, (nut, far), [-1, 0, 0]).time < 1
True
)";

}  // namespace

Motions::Motions(py::handle argument, const char* name)
    : keeper_(py::reinterpret_borrow<py::object>(argument)),
      array_(motions_in(argument)),
      is_many_(array_ != nullptr || PyList_Check(argument.ptr()) != 0 ||
               PyTuple_Check(argument.ptr()) != 0) {
  if (array_ != nullptr) return;
  if (!is_many_) {
    listed_.push_back(motion_from(argument, name));
    return;
  }
  listed_.reserve(py::len(argument));
  for (const py::handle motion : argument) {
    const std::string place = std::string(name) + "[" + std::to_string(listed_.size()) + "]";
    listed_.push_back(motion_from(motion, place.c_str()));
  }
}

py::object result_of(const std::vector<RigidContact>& answers) {
  static const ResultType kMany("RigidContacts");
  return kMany(
      words_of(answers),
      numbers_of<double>(answers, [](const auto& contact) { return contact.low; }),
      numbers_of<double>(answers, [](const auto& contact) { return contact.high; }),
      numbers_of<bool>(answers, [](const auto& contact) { return contact.is_out_of_budget; }));
}

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
  add("last_free", &last_free_of, kLastFreeText);
  module.def("cast", &cast_of, kCastText, py::arg("a"), py::arg("b"), py::arg("displacement"),
             py::kw_only(), py::arg("start") = "counts", py::arg("threads") = 0,
             py::arg("progress") = py::none(), py::arg("work") = py::none());
}

}  // namespace graze::python
