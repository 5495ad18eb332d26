// Finds the contacts of two meshes that go through each other, by the ways out of each piece of
// what they have in common.

#include <graze/engine/world/contacts/contact_functions.h>
#include <graze/engine/world/contacts/meshes/mesh_pieces.h>
#include <graze/engine/world/contacts/meshes/piece_exits.h>
#include <graze/engine/world/shapes/placed_core.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

using narrowphase::Exit;
using narrowphase::Vec3;

/// Finds the ways out of all pieces, the shortest first, and adds contacts for each. By law 15 a
/// piece that no longer overlaps once A has taken all ways out so far, by the least translation
/// that does so, has no contact.
class MeshExits {
 public:
  MeshExits(MeshPieces& pieces, PieceExits& exits, ContactCandidates& candidates, Work& work)
      : pieces_(pieces), exits_(exits), candidates_(candidates), work_(work), s_(scratch()) {}

  /// False if a piece has no way out at all, as where slivers alone cross.
  bool run() {
    s_.clearance.start(kNegligible * pieces_.size());
    s_.taken.clear(), s_.first.clear();
    for (std::uint32_t piece = 0; piece < pieces_.count(); ++piece)
      s_.first.push_back({piece, exits_.shortest(piece)});
    std::sort(s_.first.begin(), s_.first.end(), [](const First& s, const First& t) {
      const double of_s = s.exit.touched.parting.exit.depth;
      const double of_t = t.exit.touched.parting.exit.depth;
      return of_s != of_t ? of_s < of_t : s.piece < t.piece;
    });
    for (const First& first : s_.first) {
      if (!first.exit.is_found) return false;
      if (is_needed(first.exit.touched.parting.exit)) take(first.piece, first.exit);
    }
    for (const First& first : s_.first)
      take_others(first.piece);
    return true;
  }

 private:
  static constexpr double kNegligible = 1e-9;
  static constexpr double kSameDepth = 1e-6;

  struct First {
    std::uint32_t piece;
    PieceExit exit;
  };
  struct Taken {
    std::uint32_t piece;
    Exit exit;
  };
  /// Memory that is kept from one pair to the next, so that no step of a simulation allocates.
  struct Scratch {
    Clearance clearance;
    std::vector<First> first;
    std::vector<Taken> taken;
    std::vector<TrianglePair> overlapping;
  };
  static Scratch& scratch() {
    static thread_local Scratch kept;  // no pair is looked at within another
    return kept;
  }

  /// True if no exit so far does the same, or if another piece is left along the same direction, as
  /// where a plank lies on two trestles: then this piece has a contact, too.
  bool is_needed(const Exit& exit) const {
    if (!s_.clearance.satisfies(exit)) return true;
    return std::any_of(s_.taken.begin(), s_.taken.end(), [&](const Taken& taken) {
      return is_one_direction(taken.exit.direction, exit.direction);
    });
  }

  void take(std::uint32_t piece, const PieceExit& piece_exit) {
    const Exit& exit = piece_exit.touched.parting.exit;
    // The part outside makes no exit longer, but has to be cleared as well.
    if (!s_.clearance.satisfies(exit))
      s_.clearance.add({exit.direction, exit.depth + piece_exit.beyond});
    const bool is_listed = std::any_of(s_.taken.begin(), s_.taken.end(), [&](const Taken& taken) {
      return taken.piece == piece && is_one_direction(taken.exit.direction, exit.direction) &&
             std::abs(taken.exit.depth - exit.depth) <= kSameDepth * pieces_.size();
    });
    if (is_listed) return;
    s_.taken.push_back({piece, exit});
    exits_.add_contacts(piece, piece_exit, candidates_);
    candidates_.end_region();
  }

  /// Takes the shortest exit of the triangles of a piece that overlap in spite of the exits so far,
  /// again and again, until no overlapping pair is left.
  void take_others(std::uint32_t piece) {
    const double enough = exits_.enough(piece);
    s_.overlapping.clear();
    for (const MeshCrossing& crossing : pieces_.crossings(piece))
      s_.overlapping.push_back(crossing.pair);
    // This ends, because each exit is satisfied from then on, or its pairs are left out.
    for (;;) {
      pieces_.remove_apart(s_.overlapping, s_.clearance.translation() * (1 / enough), work_);
      if (s_.overlapping.empty()) return;
      const PieceExit piece_exit = exits_.shortest_of(piece, s_.overlapping, s_.clearance);
      if (!piece_exit.is_found) return;
      take(piece, piece_exit);
      // Between walls that are too near to each other no translation satisfies all.
      if (s_.clearance.satisfies(piece_exit.touched.parting.exit)) continue;
      std::erase_if(s_.overlapping, [&](const TrianglePair& pair) {
        return (piece_exit.is_of_a ? pair.a : pair.b) == piece_exit.touched.parting.triangle;
      });
    }
  }

  MeshPieces& pieces_;
  PieceExits& exits_;
  ContactCandidates& candidates_;
  Work& work_;
  Scratch& s_;
};

}  // namespace

bool candidates_of_crossings(const PlacedShapeView& a, const PlacedShapeView& b,
                             ContactCandidates& candidates, Work& work) {
  static thread_local MeshPieces pieces;  // no pair is looked at within another
  static thread_local PieceExits exits;
  const PlacedMeshView mesh_a{*a.shape.as<Mesh>(), a.pose};
  const PlacedMeshView mesh_b{*b.shape.as<Mesh>(), b.pose};
  candidates.origin = middle_of(a.shape, a.pose);
  const Vec3 origin = to_vec3(candidates.origin);
  switch (pieces.find(mesh_a, mesh_b, origin, work)) {
    case MeshPieces::Found::Nothing:
      return true;
    case MeshPieces::Found::Touches:
      return false;
    case MeshPieces::Found::Pieces:
      break;
  }
  FacingFeatures features_a(mesh_a, origin), features_b(mesh_b, origin);
  exits.start(pieces, features_a, features_b);
  if (MeshExits(pieces, exits, candidates, work).run()) return true;
  candidates.clear();
  return false;
}

}  // namespace graze
