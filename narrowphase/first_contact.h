#pragma once

#include <Eigen/Core>

#include <optional>
#include <span>

namespace graze {

/// A point on a straight path: `start + t (end - start)` in real arithmetic, metres, t in [0, 1].
struct PointPath {
  Eigen::Vector3d start;  ///< its place at t = 0
  Eigen::Vector3d end;    ///< its place at t = 1

  bool operator==(const PointPath&) const = default;
};

/// The closed segment between two points on straight paths. It may come to have no length.
struct EdgePath {
  PointPath a;  ///< the path of the first end
  PointPath b;  ///< the path of the second end

  bool operator==(const EdgePath&) const = default;
};

/// The closed convex hull of three points on straight paths: a triangle that moves and deforms. It
/// may come to be a segment or a point.
struct TrianglePath {
  PointPath a;  ///< the path of the first corner
  PointPath b;  ///< the path of the second corner
  PointPath c;  ///< the path of the third corner

  bool operator==(const TrianglePath&) const = default;
};

/// Says whether a contact at t = 0 counts.
enum class StartContact {
  Counts,  ///< the first contact
  IsLeft   ///< no contact, nor are the times of contact connected with it: bodies that leave each
           ///< other
};

/// Says how first_contact() treats contacts at t = 0, and which clearance counts as one.
struct FirstContactSettings {
  StartContact start = StartContact::Counts;  ///< says whether a contact at t = 0 counts
  /// A clearance in metres, finite and not negative: sets no further apart than that are in
  /// contact.
  double clearance = 0;
};

/// Says when two things that move meet first.
struct FirstContact {
  double time;       ///< in [0, 1]: the largest double that is not above the first contact
  bool is_at_start;  ///< whether that contact is at t = 0 itself

  bool operator==(const FirstContact&) const = default;
};

/// Returns when a point meets a triangle first, or nothing if it never does (law 12). The answer is
/// that of real arithmetic on the given doubles, for every finite input: the two may be in one
/// plane all the time, touch without crossing, be huge or tiny, and the triangle may have no area.
/// The time is never late, and it is early by less than the distance of two doubles. With
/// StartContact::IsLeft the connected part of the times of contact that holds 0 is left out. The
/// order of corners changes nothing. Takes tens of nanoseconds where all are never in one plane.
/// Throws InputError for a coordinate that is not finite.
///
/// With a clearance the two are in contact while they are no further apart than that, again in
/// real arithmetic. So a step up to the time returned keeps at least that distance, even if they
/// come so near for a moment only. Takes some hundred nanoseconds where they are clearly further
/// apart all the way, else about a millisecond, and up to a second for coordinates that are a
/// thousand binary places apart, on the heap.
///
/// Brochu, Edwards and Bridson, "Efficient geometrically exact continuous collision detection", ACM
/// Transactions on Graphics 31(4), 2012, decide the parity of contacts exactly; Wang, Ferguson,
/// Schneider, Jiang, Attene and Panozzo, "A large-scale benchmark and an inclusion-based algorithm
/// for continuous collision detection", ACM Transactions on Graphics 40(5), 2021, are never late.
std::optional<FirstContact> first_contact(const PointPath& point, const TrianglePath& triangle,
                                          const FirstContactSettings& settings = {});

/// Returns when two edges meet first. All that is said of a point and a triangle holds for them
/// too; swapping the edges changes nothing.
std::optional<FirstContact> first_contact(const EdgePath& edge_a, const EdgePath& edge_b,
                                          const FirstContactSettings& settings = {});

/// Returns when two triangles meet first. All that is said of a point and a triangle holds for them
/// too; swapping the triangles changes nothing. With StartContact::IsLeft each corner with the
/// other triangle and each pair of edges is asked in this way, and triangles that cross at t = 0
/// (crosses()) meet there all the same.
std::optional<FirstContact> first_contact(const TrianglePath& triangle_a,
                                          const TrianglePath& triangle_b,
                                          const FirstContactSettings& settings = {});

// These functions answer for many pairs at once: contacts[i] becomes the answer for element i of
// one array and element i of the other. All have the same length, which may be 0. They throw
// InputError for lengths that differ, and for a coordinate that is not finite, naming the first bad
// element; `contacts` is then unspecified.

/// Answers for pairs of a point and a triangle.
void first_contacts(std::span<const PointPath> points, std::span<const TrianglePath> triangles,
                    std::span<std::optional<FirstContact>> contacts,
                    const FirstContactSettings& settings = {});

/// Answers for pairs of edges.
void first_contacts(std::span<const EdgePath> edges_a, std::span<const EdgePath> edges_b,
                    std::span<std::optional<FirstContact>> contacts,
                    const FirstContactSettings& settings = {});

/// Answers for pairs of triangles.
void first_contacts(std::span<const TrianglePath> triangles_a,
                    std::span<const TrianglePath> triangles_b,
                    std::span<std::optional<FirstContact>> contacts,
                    const FirstContactSettings& settings = {});

}  // namespace graze
