#pragma once

// Finds the ways out of the pieces that two meshes have in common. Private to engine/world.

#include <graze/engine/world/contacts/clearance.h>
#include <graze/engine/world/contacts/contact_regions.h>
#include <graze/engine/world/contacts/meshes/local_part.h>
#include <graze/engine/world/contacts/meshes/mesh_pieces.h>
#include <graze/engine/world/contacts/meshes/mesh_region_points.h>
#include <graze/engine/world/contacts/meshes/piece_facets.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze {

/// The way on which A leaves B in a piece.
struct PieceExit {
  TouchedTriangle touched;  ///< the triangle and its way out, which is A's even if the triangle is
                            ///< B's
  bool is_of_a = false;
  bool is_found = false;
  bool is_local = false;    ///< whether the way does not lead round a body that goes on
  bool is_partial = false;  ///< whether only the part around the triangle leaves on this way
  double beyond = 0;        ///< by how much the part outside extends farther along the exit, metres
};

/// The exits of all pieces. Memory is kept from one pair to the next.
class PieceExits {
 public:
  /// Begins with a pair. All arguments must outlive it.
  void start(MeshPieces& pieces, FacingFeatures& features_a, FacingFeatures& features_b);

  /// Returns the shortest way out of a piece. If few triangles cross, it looks at all of them. Else
  /// it begins with the normal of the piece and with the best face, and looks at the triangles
  /// around the points that are farthest along the way out so far, as long as that becomes shorter.
  /// So a piece of thousands of triangles takes no longer than one of a dozen.
  PieceExit shortest(std::uint32_t piece);

  /// Returns the shortest exit through triangles in some crossing pairs that the clearance does not
  /// satisfy.
  PieceExit shortest_of(std::uint32_t piece, std::span<const TrianglePair> pairs,
                        const Clearance& clearance);

  /// Returns the share of each way out that has to be satisfied: facets of a round surface differ
  /// by less than law 15 leaves open, and need not all be regions.
  double enough(std::uint32_t piece) { return enter(piece), is_wrapped_ ? kEnoughOfFacet : 1; }

  /// Adds the contacts of a way out.
  void add_contacts(std::uint32_t piece, const PieceExit& piece_exit,
                    ContactCandidates& candidates);

 private:
  static constexpr double kEnoughOfFacet = 0.95;
  /// Ways out are chosen by their lengths, but those of faces count as shorter: an edge whose way
  /// is shorter by a hair, about which two bodies that lie on each other would turn, is not chosen.
  /// And of two faces along each other the same one is left in each step. Law 15's depths are to a
  /// twentieth.
  static constexpr double kFaceShare = 0.97, kPreferredShare = 0.99;

  /// A triangle that was looked at. Its exit is computed only as far as it is needed: most ways out
  /// are longer than the shortest so far, as bounds show at once.
  struct Looked {
    PieceExit exit;
    narrowphase::Vec3 normal;
    double at_least = 0;  ///< the way out is known, or is no shorter than this
    bool is_known = false;
    bool is_close = false;  ///< whether the feature that is left may depend on the face's share
  };

  Looked& look_at(std::uint32_t triangle, bool is_of_a);
  double face_share(const narrowphase::Vec3& from_a_to_b, bool is_of_a) const;
  double rank_of(const PieceExit& piece_exit) const;
  double limit_for(const Looked& looked, const PieceExit& best) const;
  void find_below(double limit, Looked& looked);
  void find_below(double limit, const PartingSettings& settings, Looked& looked);
  void enter(std::uint32_t piece);
  bool start_local(std::uint32_t triangle, bool is_of_a);
  template <typename Part>
  void find_with(Part&& part, double limit, const PartingSettings& settings, Looked& looked);
  PieceExit shortest_facet(const Clearance* clearance);
  PieceExit shortest_whole(std::uint32_t piece);
  void leave_whole(std::uint32_t piece, bool is_whole);
  void widen(PieceExit& piece_exit, const narrowphase::Vec3& normal);
  void descend(std::uint32_t piece, narrowphase::Vec3 direction);
  void look_about(std::uint32_t piece, const narrowphase::Vec3& direction, bool is_of_a);
  bool look_at_best_face(std::uint32_t piece);
  bool is_looked_at(std::uint32_t triangle, bool is_of_a) const;
  FacingFeatures& features(bool is_of_a) { return is_of_a ? *features_a_ : *features_b_; }
  InnerSurface& surface(bool is_of_a) {
    return pieces_->surface(is_of_a ? InnerSide::OfA : InnerSide::OfB);
  }

  MeshPieces* pieces_ = nullptr;
  FacingFeatures* features_a_ = nullptr;
  FacingFeatures* features_b_ = nullptr;
  double larger_ = 0;  ///< by how much A is larger, by MeshPieces::larger()
  static constexpr std::uint32_t kNoPiece = 0xffffffffu;
  std::uint32_t piece_ = kNoPiece;
  std::vector<std::uint8_t> is_left_whole_;  ///< for each piece, whether it leaves as a whole
                                             ///< though it wraps around: no facet of it has a way
                                             ///< out, or one that is longer
  bool is_wrapped_ = false;                  ///< whether faces of both meshes look to many sides
  PieceFacets facets_;                       ///< the facets of a piece that wraps around
  LocalPart local_;
  std::vector<MeshCrossing> on_face_;  ///< the crossings of one triangle
  std::vector<Looked> looked_;         ///< the triangles of this piece that were looked at
  std::vector<std::uint64_t> order_;   ///< their keys and places in looked_, ascending
  PieceExit best_;                     ///< the best exit of all triangles that were looked at
  PieceExit best_of_any_;              ///< the best exit even if it leads round a body that goes on
};

}  // namespace graze
