// Along d all is in one plane: which features meet is a matter of the sides on which corners are of
// the lines through edges, seen along d. There a corner is in a triangle if it is beyond no edge,
// and two edges cross if the ends of each are not on one side of the other. Where a corner is on
// the lines of all edges of a triangle, that triangle is in one plane with it and d, and what meets
// is told within that plane.

#include <graze/narrowphase/translation/axes.h>
#include <graze/narrowphase/translation/meeting_time.h>

#include <algorithm>
#include <cmath>

namespace graze::narrowphase {
namespace {

bool are_against(Sign s, Sign t) {
  return s != Sign::Zero && t == -s;
}

/// Says on which sides of the edges of one triangle the corners of another are, seen along d.
struct CornerSides {
  Sign sign[3][3];  ///< the side of a corner (first) beside an edge (second)

  bool is_beside(int corner) const {
    const Sign* s = sign[corner];
    return are_against(s[0], s[1]) || are_against(s[1], s[2]) || are_against(s[2], s[0]);
  }
  bool is_in_plane(int corner) const {
    const Sign* s = sign[corner];
    return s[0] == Sign::Zero && s[1] == Sign::Zero && s[2] == Sign::Zero;
  }
  /// True if the ends of the other's edge are on one side, or both on the line: then edges cross
  /// nowhere, or not in one point.
  bool are_ends_alike(int corner, int edge) const {
    return sign[corner][edge] == sign[(corner + 1) % 3][edge];
  }
};

/// Finds all eighteen sides. With w from a corner of one to the corners p and q of the other, the
/// side is the sign of (w_p x w_q) . d = (w_q x d) . w_p: nine differences and their products with
/// d serve all. What is surely beyond an edge is told before any sign is asked exactly.
class SidesOfAll {
 public:
  explicit SidesOfAll(const TranslatedPair& pair) : pair_(pair), d_{kZeroPoint, pair.displacement} {
    double size = 0;
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        offset_[i][k] = Offset(pair.b.point[k], pair.a.point[i]);
        size = std::max(size, offset_[i][k].size());
        across_[i][k] = cross(offset_[i][k], pair.displacement);
      }
    }
    bound_ = triple_bound(size, d_, size);
  }

  /// Tells the sides. False if one triangle is surely beyond an edge of the other: then nothing is
  /// told.
  bool tell() {
    // From A's corners to B's both offsets are the other way round, which changes no sign.
    const auto of_b_value = [&](int corner, int edge) {
      return dot(across_[(edge + 1) % 3][corner], offset_[edge][corner]);
    };
    const auto of_a_value = [&](int corner, int edge) {
      return dot(across_[corner][(edge + 1) % 3], offset_[corner][edge]);
    };
    double values_b[3][3], values_a[3][3];
    if (are_beyond_an_edge(of_b_value, values_b) || are_beyond_an_edge(of_a_value, values_a))
      return false;
    tell_signs(pair_.b, pair_.a, values_b, of_b);
    tell_signs(pair_.a, pair_.b, values_a, of_a);
    return true;
  }

  CornerSides of_a;  ///< the sides of A's corners
  CornerSides of_b;

 private:
  struct Offset {
    double x, y, z;

    Offset() = default;
    Offset(const double* from, const double* to)
        : x(to[0] - from[0]), y(to[1] - from[1]), z(to[2] - from[2]) {}
    double size() const { return std::max(std::max(std::abs(x), std::abs(y)), std::abs(z)); }
  };
  static Offset cross(const Offset& w, const double* d) {
    Offset across;
    across.x = w.y * d[2] - w.z * d[1];
    across.y = w.z * d[0] - w.x * d[2];
    across.z = w.x * d[1] - w.y * d[0];
    return across;
  }
  static double dot(const Offset& a, const Offset& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

  /// Computes the values of all corners. Those of one corner add up to the determinant of two edges
  /// and d, whose sign all have within the triangle; their sum is off by three bounds and its own
  /// rounding, which is less than another.
  template <typename ValueOf>
  bool are_beyond_an_edge(const ValueOf& value_of, double (&values)[3][3]) const {
    for (int corner = 0; corner < 3; ++corner) {
      for (int edge = 0; edge < 3; ++edge)
        values[corner][edge] = value_of(corner, edge);
    }
    const double turn = (values[0][0] + values[0][1]) + values[0][2];
    if (!(std::abs(turn) > 4 * bound_)) return false;
    const double sense = turn > 0 ? 1 : -1;
    for (int edge = 0; edge < 3; ++edge) {
      if (sense * values[0][edge] < -bound_ && sense * values[1][edge] < -bound_ &&
          sense * values[2][edge] < -bound_)
        return true;
    }
    return false;
  }

  void tell_signs(const Corners<double>& corners, const Corners<double>& triangle,
                  const double (&values)[3][3], CornerSides& sides) const {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const double value = values[i][k];
        if (std::abs(value) > bound_) {
          sides.sign[i][k] = value > 0 ? Sign::Positive : Sign::Negative;
        } else {
          sides.sign[i][k] = sign_of_triple({corners.point[i], triangle.point[k]},
                                            {corners.point[i], triangle.point[(k + 1) % 3]}, d_);
        }
      }
    }
  }

  const TranslatedPair& pair_;
  Step d_;
  Offset offset_[3][3];  ///< the offset from a corner of B to one of A, by [of A][of B]
  Offset across_[3][3];  ///< that offset x d
  double bound_;
};

class Meetings {
 public:
  explicit Meetings(const TranslatedPair& pair)
      : pair_(pair),
        d_{kZeroPoint, pair.displacement},
        sides_(pair),
        sides_a_(sides_.of_a),
        sides_b_(sides_.of_b) {}

  /// Finds the first meeting. False if there are none, or all are at negative times.
  bool find() {
    if (!sides_.tell()) return false;
    for (int i = 0; i < 3; ++i) {
      if (!sides_a_.is_beside(i)) take_corner_of_a(i);
    }
    for (int i = 0; i < 3; ++i) {
      if (!sides_b_.is_beside(i)) take_corner_of_b(i);
    }
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        if (!sides_b_.are_ends_alike(k, i) && !sides_a_.are_ends_alike(i, k))
          take({Meeting::Kind::EdgeEdge, i, k, 0});
      }
    }
    return first_ && !is_before_;
  }

  const Meeting& first() const { return *first_; }
  const MeetingTime& time() const { return *time_; }

 private:
  void take_corner_of_a(int corner) {
    if (!sides_a_.is_in_plane(corner)) return take({Meeting::Kind::VertexFace, corner, 0, 0});
    for (int edge = 0; edge < 3; ++edge) {
      take_in_plane(pair_.a.point[corner], pair_.b, edge,
                    {Meeting::Kind::VertexOnEdge, corner, edge, 0},
                    {Meeting::Kind::VertexVertex, corner, edge, 0});
    }
  }

  void take_corner_of_b(int corner) {
    if (!sides_b_.is_in_plane(corner)) return take({Meeting::Kind::FaceVertex, 0, corner, 0});
    for (int edge = 0; edge < 3; ++edge) {
      take_in_plane(pair_.b.point[corner], pair_.a, edge,
                    {Meeting::Kind::EdgeWithVertex, edge, corner, 0},
                    {Meeting::Kind::VertexVertex, edge, corner, 0});
    }
  }

  /// Takes a corner, and an edge in one plane with it and d. Seen along d the corner is in the edge
  /// if the ends are not on one side of it. Both sides are multiples of one vector across d. Where
  /// both are zero, all is on one line along d, on which ends come before what is between; of the
  /// two that where the edge begins is enough, as the other one is where the next edge begins.
  void take_in_plane(const double* corner, const Corners<double>& triangle, int edge,
                     Meeting with_edge, Meeting with_corner) {
    const int next = (edge + 1) % 3;
    bool is_on_line = true;
    for (int axis = 0; axis < 3; ++axis) {
      const Sign from = sign_of_triple({corner, triangle.point[edge]}, d_, axis_step(axis));
      const Sign to = sign_of_triple({corner, triangle.point[next]}, d_, axis_step(axis));
      if (from == Sign::Zero && to == Sign::Zero) continue;
      is_on_line = false;
      if (from == to) return;
      with_edge.axis = axis;
    }
    if (!is_on_line) return take(with_edge);
    while (pair_.displacement[with_corner.axis] == 0)
      ++with_corner.axis;
    take(with_corner);
  }

  /// Takes a meeting. All times are of one sign, for triangles that are apart at t = 0.
  void take(const Meeting& meeting) {
    if (is_before_) return;
    const TimeQuotient quotient(pair_, meeting);
    if (!first_ && sign_of(quotient) == Sign::Negative) {
      is_before_ = true;
      return;
    }
    const MeetingTime time(quotient);
    if (first_ && compare(time, *time_) != Sign::Negative) return;
    first_ = meeting;
    time_.emplace(time);
  }

  const TranslatedPair& pair_;
  Step d_;
  SidesOfAll sides_;
  const CornerSides& sides_a_;  ///< the sides of A's corners
  const CornerSides& sides_b_;
  std::optional<Meeting> first_;
  std::optional<MeetingTime> time_;
  bool is_before_ = false;
};

}  // namespace

std::optional<TimedMeeting> first_meeting(const TranslatedPair& pair) {
  const double* d = pair.displacement;
  if (d[0] == 0 && d[1] == 0 && d[2] == 0) return std::nullopt;
  Meetings meetings(pair);
  if (!meetings.find() || is_above_one(meetings.time())) return std::nullopt;
  return TimedMeeting{meetings.first(), meetings.time().bounds};
}

}  // namespace graze::narrowphase
