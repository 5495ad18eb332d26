#pragma once

// The ways out of the pieces that two meshes have in common. Private to engine/world.

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

/// How A leaves B in a piece.
struct PieceExit {
  TouchedTriangle touched;  ///< the way out is A's, whoever's the triangle is
  bool is_of_a = false;
  bool is_found = false;
  bool is_local = false;    ///< it does not lead round a body that goes on
  bool is_partial = false;  ///< it is that of what is about the triangle alone
  double beyond = 0;        ///< metres, by which what lies outside extends farther along the exit
};

/// Memory is kept from one pair to the next.
class PieceExits {
 public:
  /// All must outlive it.
  void start(MeshPieces& pieces, FacingFeatures& features_a, FacingFeatures& features_b);

  /// The shortest way out of a piece: by the triangles that cross, if they are few; else from the
  /// normal of the piece and from the best face on, by the triangles about the points that are
  /// farthest along the way out so far, as long as it becomes shorter. So a piece of thousands of
  /// triangles is left as soon as one of a dozen.
  PieceExit shortest(std::uint32_t piece);

  /// The shortest of those of the triangles in some crossing pairs that the clearance does not
  /// satisfy.
  PieceExit shortest_of(std::uint32_t piece, std::span<const TrianglePair> pairs,
                        const Clearance& clearance);

  /// The share of each way out that has to be satisfied: facets of a round surface differ by less
  /// than what law 15 leaves open, and need not all be regions.
  double enough(std::uint32_t piece) { return enter(piece), is_wrapped_ ? kEnoughOfFacet : 1; }

  /// The contacts of a way out.
  void add_contacts(std::uint32_t piece, const PieceExit& piece_exit,
                    ContactCandidates& candidates);

 private:
  static constexpr double kEnoughOfFacet = 0.95;
  // Ways out are taken by their lengths, of which those of faces count for less: an edge that is
  // shorter by a hair, along which two bodies that lie on each other would turn, is none. And of
  // two faces along each other the same is left from step to step. Law 15's depths are to a
  // twentieth.
  static constexpr double kFaceShare = 0.97, kPreferredShare = 0.99;

  /// A triangle that was looked at. How it is left is found out as far as anybody asks: most ways
  /// out are longer than the shortest so far, and bounds say so at once.
  struct Looked {
    PieceExit exit;
    narrowphase::Vec3 normal;
    double at_least = 0;  ///< the way out is known, or no shorter than that
    bool is_known = false;
    bool is_close = false;  ///< whether what is left may depend on the face's share
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
  double larger_ = 0;  ///< by how much A is the larger mesh; negative if B is
  static constexpr std::uint32_t kNoPiece = 0xffffffffu;
  std::uint32_t piece_ = kNoPiece;
  std::vector<std::uint8_t> is_left_whole_;  ///< of each piece: no facet of it has a way out
  bool is_wrapped_ = false;                  ///< whether faces of both meshes look to many sides
  PieceFacets facets_;                       ///< of the piece, if so
  LocalPart local_;
  std::vector<MeshCrossing> on_face_;  ///< the crossings of one triangle
  std::vector<Looked> looked_;         ///< at of this piece
  std::vector<std::uint64_t> order_;   ///< their triangles and numbers, ascending
  PieceExit best_;                     ///< of all that were looked at
  PieceExit best_of_any_;              ///< likewise, though it lead round a body that goes on
};

}  // namespace graze
