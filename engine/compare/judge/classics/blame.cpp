#include <graze/engine/compare/judge/classics/blame.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace graze::compare {
namespace {

template <typename Scalar>
using Rows = std::array<std::array<Scalar, 4>, 3>;

template <typename Scalar>
Rows<Scalar> rows_of(const Pose& pose) {
  Rows<Scalar> rows;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 4; ++k)
      rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] =
          static_cast<Scalar>(pose(i, k));
  return rows;
}

/// Returns inverse(a) * b, as engines multiply poses.
template <typename Scalar>
Rows<Scalar> relative(const Rows<Scalar>& a, const Rows<Scalar>& b) {
  Rows<Scalar> out;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      Scalar sum = 0;
      for (std::size_t j = 0; j < 3; ++j)
        sum += a[j][i] * (k < 3 ? b[j][k] : Scalar(b[j][3] - a[j][3]));
      out[i][k] = sum;
    }
  }
  return out;
}

template <typename Scalar>
Eigen::Vector3d moved_by(const Rows<Scalar>& pose, const Eigen::Vector3d& p) {
  Eigen::Vector3d out;
  for (std::size_t i = 0; i < 3; ++i) {
    const Scalar x = pose[i][0] * static_cast<Scalar>(p.x());
    const Scalar y = pose[i][1] * static_cast<Scalar>(p.y());
    const Scalar z = pose[i][2] * static_cast<Scalar>(p.z());
    out.data()[i] = static_cast<double>(Scalar(Scalar(Scalar(x + y) + z) + pose[i][3]));
  }
  return out;
}

template <typename Scalar>
Triangle moved_by(const Rows<Scalar>& pose, const Triangle& t) {
  return {moved_by(pose, t.a), moved_by(pose, t.b), moved_by(pose, t.c)};
}

template <typename Scalar>
Triangle seen_from(const Eigen::Vector3d& corner, const Triangle& t) {
  const auto seen = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    Eigen::Vector3d out;
    for (int i = 0; i < 3; ++i)
      out[i] =
          static_cast<double>(Scalar(static_cast<Scalar>(p[i]) - static_cast<Scalar>(corner[i])));
    return out;
  };
  return {seen(t.a), seen(t.b), seen(t.c)};
}

template <typename Scalar>
PlacedTriangles placed_with(const PosedTriangles& posed, ClassicFrame frame) {
  const Rows<Scalar> a = rows_of<Scalar>(posed.pose_a);
  const Rows<Scalar> b = rows_of<Scalar>(posed.pose_b);
  if (frame == ClassicFrame::Common) return {moved_by(a, posed.a), moved_by(b, posed.b)};
  const Rows<Scalar> still = rows_of<Scalar>(Pose::Identity());
  PlacedTriangles placed{moved_by(still, posed.a), moved_by(relative(a, b), posed.b)};
  if (frame == ClassicFrame::OfA) return placed;
  const Eigen::Vector3d corner = placed.a.a;
  return {seen_from<Scalar>(corner, placed.a), seen_from<Scalar>(corner, placed.b)};
}

double largest_move(const RationalTriangle& from, const RationalTriangle& to) {
  mpq_class largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint by = minus(from[i], to[i]);
    largest = std::max(largest, dot(by, by));
  }
  return rounded_root(largest);
}

/// Returns by how much rounding has moved a corner of B, which is placed in every variant. What A's
/// pose deviates from a rotation counts with it where B is brought into A's frame.
double moved(const PosedTriangles& posed, const PlacedTriangles& placed, ClassicFrame frame) {
  const RationalTriangle b = placed_without_rounding(posed.pose_b, posed.b);
  if (frame == ClassicFrame::Common) return largest_move(b, exactly(placed.b));
  RationalTriangle back = exactly(placed.b);
  if (frame == ClassicFrame::Corner) {
    const RationalPoint corner = exactly(posed.a.a);
    for (RationalPoint& p : back)
      for (std::size_t i = 0; i < 3; ++i)
        p[i] += corner[i];
  }
  // A's pose takes them into the common frame, in rational numbers.
  RationalTriangle there;
  for (std::size_t k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) {
      mpq_class sum(posed.pose_a(i, 3));
      for (int j = 0; j < 3; ++j)
        sum += mpq_class(posed.pose_a(i, j)) * back[k][static_cast<std::size_t>(j)];
      there[k][static_cast<std::size_t>(i)] = sum;
    }
  }
  return largest_move(b, there);
}

std::string number(double value) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

std::string blame_placing(const ClassicVariant& variant, bool says) {
  return std::string("Placing does it: ") + name_of(variant.frame) + ", in " +
         name_of(variant.numbers) + ", rounding moves a corner by up to " + number(variant.moved) +
         " m, and the two triangles as they then stand " + (says ? "do touch" : "do not touch") +
         ", exactly. No test behind that, however careful, gives the true answer.";
}

std::string blame_step(const ClassicVariant& variant, const ClassicRun& run,
                       const ClassicStep& step) {
  const bool by_axes = run.test == ClassicTest::Axes;
  std::string text = by_axes ? "The separating axis test, which looks for a direction with a gap, "
                             : "The test by determinants, which looks for an edge that pierces, ";
  text += std::string("does it, in ") + name_of(variant.numbers) + ", " + name_of(variant.frame) +
          ": " + step.name + " comes out as " + number(step.computed) + " and is " +
          number(step.exact) + ", off by " + number(step.ulps) + " ulp of its largest term";
  if (by_axes) {
    text += step.computed_sign > 0 ? ". So it sees a gap where there is none."
                                   : ". So it overlooks the gap.";
  } else {
    text += step.computed_sign == 0 ? ". So it sees what is on neither side."
                                    : ". So it is on the wrong side.";
  }
  return text;
}

std::optional<std::string> blame_variant(const ClassicVariant& variant, bool says) {
  if (variant.placed_touch == says) return blame_placing(variant, says);
  for (const ClassicRun* run : {&variant.axes, &variant.determinants}) {
    if (run->says != says) continue;
    const ClassicStep* step = run->misleading(variant.placed_touch);
    if (step != nullptr) return blame_step(variant, *run, *step);
  }
  return std::nullopt;
}

}  // namespace

const char* name_of(ClassicFrame frame) {
  switch (frame) {
    case ClassicFrame::Common:
      return "in the common frame";
    case ClassicFrame::OfA:
      return "in A's frame";
    case ClassicFrame::Corner:
      return "from A's corner 1";
  }
  return "";
}

const char* name_of(ClassicNumbers numbers) {
  return numbers == ClassicNumbers::Double ? "double" : "float";
}

PlacedTriangles placed_in(const PosedTriangles& posed, ClassicFrame frame, ClassicNumbers numbers) {
  return numbers == ClassicNumbers::Double ? placed_with<double>(posed, frame)
                                           : placed_with<float>(posed, frame);
}

std::vector<ClassicVariant> classic_variants(const PosedTriangles& posed) {
  std::vector<ClassicVariant> variants;
  for (const ClassicNumbers numbers : {ClassicNumbers::Double, ClassicNumbers::Float}) {
    for (const ClassicFrame frame :
         {ClassicFrame::Common, ClassicFrame::OfA, ClassicFrame::Corner}) {
      const PlacedTriangles placed = placed_in(posed, frame, numbers);
      const bool is_finite = placed.a.a.allFinite() && placed.a.b.allFinite() &&
                             placed.a.c.allFinite() && placed.b.a.allFinite() &&
                             placed.b.b.allFinite() && placed.b.c.allFinite();
      if (!is_finite) continue;  // then it is beyond what float can hold
      variants.push_back(
          {.frame = frame,
           .numbers = numbers,
           .placed_touch = squared_distance(exactly(placed.a), exactly(placed.b)) == 0,
           .moved = moved(posed, placed, frame),
           .axes = run_classic(ClassicTest::Axes, numbers, placed.a, placed.b),
           .determinants = run_classic(ClassicTest::Determinants, numbers, placed.a, placed.b)});
    }
  }
  return variants;
}

std::optional<std::string> blame(const std::vector<ClassicVariant>& variants, bool says) {
  for (const ClassicVariant& variant : variants) {
    if (std::optional<std::string> words = blame_variant(variant, says)) return words;
  }
  return std::nullopt;
}

}  // namespace graze::compare
