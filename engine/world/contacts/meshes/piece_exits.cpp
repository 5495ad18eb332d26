#include <graze/engine/world/contacts/meshes/piece_exits.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace graze {

using narrowphase::Core;
using narrowphase::Exit;
using narrowphase::Vec3;

namespace {

// Up to this many crossings are few: each of their triangles is looked at.
constexpr std::size_t kFew = 24;

// A way counts as longer than another if it is so by more than law 15's depths are exact to.
constexpr double kLonger = 1.05;

// The way of one facet is held against that of the whole piece only if it is longer than this share
// of the piece's outline: most are shorter, and the second search takes as long as the first.
constexpr double kLongFacet = 0.01;

// Two edges that dip into each other, of two faces each, cross four times, or a little more often
// where faces are divided.
constexpr std::size_t kOfTwoEdges = 8;

double depth_of(const PieceExit& piece_exit) {
  return piece_exit.is_found ? piece_exit.touched.parting.exit.depth
                             : std::numeric_limits<double>::infinity();
}

}  // namespace

void PieceExits::start(MeshPieces& pieces, FacingFeatures& features_a, FacingFeatures& features_b) {
  pieces_ = &pieces, features_a_ = &features_a, features_b_ = &features_b;
  larger_ = pieces.larger();
  piece_ = kNoPiece;
  is_left_whole_.assign(pieces.count(), false);
}

void PieceExits::enter(std::uint32_t piece) {
  if (piece_ == piece) return;
  piece_ = piece;
  looked_.clear(), order_.clear();
  best_ = {}, best_of_any_ = {};
  const std::span<const MeshCrossing> crossings = pieces_->crossings(piece);
  // If the faces of one mesh look to one side, that is the way out of the whole piece.
  const Outline& outline = pieces_->outline(piece);
  // For two faces at right angles, as where a box dips an edge in, together() is 0.7.
  const double most = crossings.size() > kFew ? 0.8 : 0.7;
  is_wrapped_ =
      !is_left_whole_[piece] && outline.together(true) < most && outline.together(false) < most;
  // Of few triangles the best way is found either way.
  if (is_wrapped_ && crossings.size() > kFew) is_wrapped_ = !pieces_->is_left_one_way(piece);
  if (is_wrapped_) facets_.start(crossings, surface(true), surface(false));
}

/// Returns the share of its length for which a face's exit counts. It is less for the larger mesh,
/// or for equal ones for the mesh from which the normal leads upward, in whichever direction that
/// is: which of the two is called A may change with each step.
double PieceExits::face_share(const Vec3& from_a_to_b, bool is_of_a) const {
  double for_a = larger_ != 0 ? larger_ : dot(from_a_to_b, {1, 2, 4});
  if (for_a == 0) for_a = from_a_to_b.x != 0 ? from_a_to_b.x : from_a_to_b.y;
  return (for_a > 0) == is_of_a ? kFaceShare * kPreferredShare : kFaceShare;
}

double PieceExits::rank_of(const PieceExit& piece_exit) const {
  if (!piece_exit.is_found) return std::numeric_limits<double>::infinity();
  const LocalParting& parting = piece_exit.touched.parting;
  if (parting.feature != LeftFeature::Face) return parting.exit.depth;
  return parting.exit.depth * face_share(-parting.exit.direction, piece_exit.is_of_a);
}

/// Returns the length beyond which no exit off a triangle ranks before another.
double PieceExits::limit_for(const Looked& looked, const PieceExit& best) const {
  const bool is_of_a = looked.exit.is_of_a;
  return rank_of(best) / face_share(is_of_a ? looked.normal : -looked.normal, is_of_a);
}

/// Makes the local part of a triangle of a piece that wraps around; false if it has none.
bool PieceExits::start_local(std::uint32_t triangle, bool is_of_a) {
  if (!is_wrapped_ || facets_.index().on_triangle(triangle, is_of_a).empty()) return false;
  local_.start(surface(!is_of_a), facets_.index(), piece_, triangle,
               is_of_a ? InnerSide::OfB : InnerSide::OfA, facets_.facets().back().bound);
  return true;
}

/// Returns a key of a triangle and its side, with room for a number. A mesh has fewer than 2^31
/// triangles.
static std::uint64_t key_of(std::uint32_t triangle, bool is_of_a) {
  return (std::uint64_t{triangle} << 1 | is_of_a) << 32;
}

bool PieceExits::is_looked_at(std::uint32_t triangle, bool is_of_a) const {
  const std::uint64_t key = key_of(triangle, is_of_a);
  const auto at = std::lower_bound(order_.begin(), order_.end(), key);
  return at != order_.end() && *at >> 32 == key >> 32;
}

PieceExits::Looked& PieceExits::look_at(std::uint32_t triangle, bool is_of_a) {
  const std::uint64_t key = key_of(triangle, is_of_a);
  const auto at = std::lower_bound(order_.begin(), order_.end(), key);
  if (at != order_.end() && *at >> 32 == key >> 32) return looked_[static_cast<std::uint32_t>(*at)];
  order_.insert(at, key | looked_.size());
  surface(is_of_a).note_neighbours(triangle);
  Looked& looked = looked_.emplace_back();
  looked.exit.is_of_a = is_of_a;
  Core& core = looked.exit.touched.triangle;
  core = features(is_of_a).placed_triangle(triangle);
  looked.exit.touched.parting.triangle = triangle;
  looked.is_known = FacingFeatures::is_sliver(core);
  if (looked.is_known) return looked;
  looked.normal = LocalPartings::normal_of(core);
  find_below(limit_for(looked, best_), looked);
  if (!looked.is_known) return looked;
  if (depth_of(looked.exit) < depth_of(best_of_any_)) best_of_any_ = looked.exit;
  if (looked.exit.is_local && rank_of(looked.exit) < rank_of(best_)) best_ = looked.exit;
  return looked;
}

/// Computes the exit off a triangle if that may be shorter than the limit.
void PieceExits::find_below(double limit, Looked& looked) {
  if (looked.is_known || looked.at_least >= limit) return;
  looked.is_close = false;
  find_below(limit, {.face_share = kFaceShare}, looked);
  const PieceExit& piece_exit = looked.exit;
  if (!looked.is_close || !piece_exit.is_found || piece_exit.is_local ||
      piece_exit.touched.parting.feature != LeftFeature::Face)
    return;
  // The face's exit belongs to another piece: now edges that are hardly shorter count. If none of
  // them lost only because of the share, the result would be the same.
  looked.is_known = looked.exit.is_found = false;
  find_below(limit, {}, looked);
}

void PieceExits::find_below(double limit, const PartingSettings& settings, Looked& looked) {
  const bool is_of_a = looked.exit.is_of_a;
  looked.exit.is_partial = start_local(looked.exit.touched.parting.triangle, is_of_a);
  if (looked.exit.is_partial) {
    find_with(local_, limit, settings, looked);
    if (looked.exit.is_found) widen(looked.exit, looked.normal);
    return;
  }
  InnerSurface& leaving = surface(!is_of_a);
  struct Whole {
    InnerSurface& surface;
    std::uint32_t piece;
    const InnerPart& part() const { return surface.part(piece); }
    std::size_t grow(const Vec3& direction) { return surface.grow(piece, direction); }
    bool goes_on() const { return false; }
  };
  find_with(Whole{leaving, piece_}, limit, settings, looked);
  leaving.shrink(piece_);
}

/// Makes the exit of the part around one triangle that of the whole piece, if nothing of the piece
/// is deeper, and if all of the surface that faces this way is flat: a facet of a round surface
/// does not stand for the piece.
void PieceExits::widen(PieceExit& piece_exit, const Vec3& normal) {
  constexpr double kAsDeep = 0.05;     // as law 15's depths are to a twentieth
  constexpr double kFacesSoToo = 0.9;  // a cosine
  Exit& exit = piece_exit.touched.parting.exit;
  const Vec3 out = piece_exit.is_of_a ? exit.direction : -exit.direction;
  const InnerPart& about = local_.part();
  const InnerPart& whole = surface(!piece_exit.is_of_a).part(piece_);
  const double deeper =
      dot(whole.points[whole.farthest(out)], out) - dot(about.points[about.farthest(out)], out);
  if (deeper > kAsDeep * exit.depth) return;
  for (const MeshCrossing& crossing : facets_.index().crossings()) {
    const Vec3& other = piece_exit.is_of_a ? crossing.normal_a : crossing.normal_b;
    if (dot(other, normal) > kFacesSoToo && !is_one_direction(other, normal)) return;
  }
  exit.depth += std::max(deeper, 0.0);
  piece_exit.is_partial = false;
}

/// Finds the exit of a part. The part grows in the direction of the exit that was found until it
/// reaches no farther: then the exit is one for all that is connected with the part.
template <typename Part>
void PieceExits::find_with(Part&& leaving, double limit, const PartingSettings& settings,
                           Looked& looked) {
  PieceExit& piece_exit = looked.exit;
  LocalParting& parting = piece_exit.touched.parting;
  const InnerPart& part = leaving.part();
  leaving.grow(-looked.normal);
  for (std::size_t points = 0; points != part.points.size() && !leaving.goes_on();) {
    points = part.points.size();
    const Core body = part.core();
    const std::optional<LocalParting> found =
        LocalPartings(body, features(piece_exit.is_of_a), settings)
            .below(limit, parting.triangle, piece_exit.touched.triangle, looked.normal,
                   part.at + part.points[part.farthest(-looked.normal)]);
    if (!found) {
      looked.at_least = limit;
      return;
    }
    parting = *found;
    looked.is_close |= parting.is_close;
    if (parting.feature == LeftFeature::Face) break;  // nothing is farther along the normal
    leaving.grow(-parting.exit.direction);
  }
  looked.is_known = true;
  if (leaving.goes_on()) return;
  Exit& exit = parting.exit;
  exit.depth = std::max(exit.depth, 0.0);
  piece_exit.is_found = true;
  const std::optional<double> outer = part.outer_extent(-exit.direction, exit.depth);
  piece_exit.is_local = outer.has_value();
  // Points outside are beside the triangle's mesh, and need not be lifted out.
  piece_exit.beyond = piece_exit.is_partial ? 0 : std::min(outer.value_or(0), exit.depth);
  exit.depth -= piece_exit.beyond;
  if (piece_exit.is_of_a) exit.direction = -exit.direction;
}

PieceExit PieceExits::shortest(std::uint32_t piece) {
  enter(piece);
  if (!is_wrapped_) return shortest_whole(piece);
  const PieceExit of_facet = shortest_facet(nullptr);
  const bool may_be_longer = depth_of(of_facet) > kLongFacet * pieces_->outline(piece).around &&
                             pieces_->is_left_one_way(piece);
  if (of_facet.is_found && !may_be_longer) return of_facet;
  leave_whole(piece, true);
  const PieceExit of_whole = shortest_whole(piece);
  const bool is_longer = of_whole.is_local && depth_of(of_facet) > kLonger * depth_of(of_whole);
  if (!of_facet.is_found || is_longer) return of_whole;
  leave_whole(piece, false);
  return of_facet;
}

/// Enters a piece anew, as a whole or by its facets.
void PieceExits::leave_whole(std::uint32_t piece, bool is_whole) {
  is_left_whole_[piece] = is_whole, piece_ = kNoPiece;
  enter(piece);
}

PieceExit PieceExits::shortest_whole(std::uint32_t piece) {
  const std::span<const MeshCrossing> crossings = pieces_->crossings(piece);
  if (crossings.size() <= kFew) {
    for (const MeshCrossing& crossing : crossings)
      look_at(crossing.pair.a, true), look_at(crossing.pair.b, false);
  }
  descend(piece, -pieces_->outline(piece).normal());
  if (crossings.size() > kFew) {
    // The other part may grow behind a face that seemed to be the best. So the next best face is
    // looked at, as long as it seems shorter than the best so far; and more of them if the best is
    // longer than one that leads round a body that goes on.
    constexpr int kMostFaces = 8, kMostIfLonger = 64;
    const auto is_enough = [&](int faces) {
      if (!best_.is_found) return false;
      const bool is_longer = depth_of(best_) > kLonger * depth_of(best_of_any_);
      return faces >= (is_longer ? kMostIfLonger : kMostFaces);
    };
    for (int faces = 0; !is_enough(faces) && look_at_best_face(piece);)
      ++faces;
    descend(piece, {});
  }
  return best_.is_found ? best_ : best_of_any_;
}

/// Looks for shorter exits, beginning with a direction, or with the best exit so far if the
/// direction is zero.
void PieceExits::descend(std::uint32_t piece, Vec3 direction) {
  constexpr int kMostSteps = 8;
  for (int step = 0; step < kMostSteps; ++step) {
    if (largest(direction) == 0) direction = best_.touched.parting.exit.direction;
    if (largest(direction) == 0) return;
    const double before = rank_of(best_);
    look_about(piece, -direction, true);
    look_about(piece, direction, false);
    if (!(rank_of(best_) < before)) return;
    direction = {};
  }
}

/// Looks at the triangles around the point of a mesh that is farthest in a direction.
void PieceExits::look_about(std::uint32_t piece, const Vec3& direction, bool is_of_a) {
  InnerSurface& own = surface(is_of_a);
  const std::size_t at = own.grow(piece, direction);
  const std::uint32_t vertex = own.part(piece).vertex[at];
  own.shrink(piece);
  if (vertex == InnerPart::kNoVertex) {
    own.for_each_at(piece, at, [&](std::uint32_t triangle) { look_at(triangle, is_of_a); });
    return;
  }
  for (const std::uint32_t triangle : features(is_of_a).fan(vertex))
    look_at(triangle, is_of_a);
}

/// Looks at the triangle with the shortest apparent way along its own normal, among those that
/// cross and have not been looked at. False if no way seems shorter than the best exit so far.
bool PieceExits::look_at_best_face(std::uint32_t piece) {
  double least = rank_of(best_);
  bool is_found = false;
  std::uint32_t best = 0;
  bool best_is_of_a = false;
  std::size_t worst_a = 0, worst_b = 0;
  const auto offer = [&](std::uint32_t triangle, bool is_of_a, const Vec3& normal,
                         const Vec3& point) {
    const InnerPart& other = surface(!is_of_a).part(piece);
    const double height = dot(normal, point - other.at);
    // The point that showed that the last face is worse mostly does so for this one.
    std::size_t& worst = is_of_a ? worst_b : worst_a;
    const double share = face_share(is_of_a ? normal : -normal, is_of_a);
    if ((height - dot(normal, other.points[worst])) * share >= least) return;
    worst = other.farthest(-normal);
    const double depth = share * std::max(0.0, height - dot(normal, other.points[worst]));
    if (depth >= least || is_looked_at(triangle, is_of_a)) return;
    least = depth, best = triangle, best_is_of_a = is_of_a, is_found = true;
  };
  for (const MeshCrossing& crossing : pieces_->crossings(piece)) {
    offer(crossing.pair.a, true, crossing.normal_a, crossing.from);
    offer(crossing.pair.b, false, crossing.normal_b, crossing.from);
  }
  if (is_found) look_at(best, best_is_of_a);
  return is_found;
}

PieceExit PieceExits::shortest_of(std::uint32_t piece, std::span<const TrianglePair> pairs,
                                  const Clearance& clearance) {
  enter(piece);
  if (is_wrapped_) {
    facets_.leave(pairs);
    return shortest_facet(&clearance);
  }
  PieceExit best;
  for (const TrianglePair& pair : pairs) {
    for (const bool is_of_a : {true, false}) {
      Looked& looked = look_at(is_of_a ? pair.a : pair.b, is_of_a);
      find_below(limit_for(looked, best), looked);
      const PieceExit& piece_exit = looked.exit;
      if (piece_exit.is_local && rank_of(piece_exit) < rank_of(best) &&
          !clearance.satisfies(piece_exit.touched.parting.exit))
        best = piece_exit;
    }
  }
  return best;
}

/// Returns the shortest exit of a facet that is still met. Facets are looked at in the order of
/// their bounds. A pair is also parted if a clearance satisfies the exit of one of its triangles
/// but for a twentieth (law 15): facets of a round surface differ by less.
PieceExit PieceExits::shortest_facet(const Clearance* clearance) {
  PieceExit best;
  double limit = std::numeric_limits<double>::infinity();  // the limit for bounds
  const std::span<const PieceFacets::Facet> facets = facets_.facets();
  for (std::size_t n = 0; n < facets.size() && facets[n].bound < limit; ++n) {
    if (facets[n].pairs_left == 0) continue;
    Looked& looked = look_at(facets[n].triangle, facets[n].is_of_a);
    find_below(limit_for(looked, best), looked);
    const PieceExit& piece_exit = looked.exit;
    if (!looked.is_known || !piece_exit.is_local) continue;
    Exit enough = piece_exit.touched.parting.exit;
    enough.depth *= kEnoughOfFacet;
    if (clearance != nullptr && clearance->satisfies(enough)) {
      facets_.part(n);
    } else if (rank_of(piece_exit) < rank_of(best)) {
      best = piece_exit;
      limit = rank_of(best) / (kFaceShare * kPreferredShare);
    }
  }
  return best;
}

void PieceExits::add_contacts(std::uint32_t piece, const PieceExit& piece_exit,
                              ContactCandidates& candidates) {
  enter(piece);
  const std::span<const MeshCrossing> crossings = pieces_->crossings(piece);
  MeshRegion region{
      .left = piece_exit.touched,
      .is_of_a = piece_exit.is_of_a,
      .crossings = crossings,
      .inner_a = &pieces_->inner_a(piece),
      .inner_b = &pieces_->inner_b(piece),
      .is_scattered = piece_exit.is_partial || (is_wrapped_ && crossings.size() > kOfTwoEdges),
      .pose_a = pieces_->pose_a(),
      .pose_b = pieces_->pose_b()};
  const std::uint32_t triangle = piece_exit.touched.parting.triangle;
  static const InnerPart kNone;
  if (piece_exit.is_partial && start_local(triangle, piece_exit.is_of_a)) {
    const Vec3& direction = piece_exit.touched.parting.exit.direction;
    local_.grow(piece_exit.is_of_a ? direction : -direction);
    on_face_.clear();
    for (const std::uint32_t i : facets_.index().on_triangle(triangle, piece_exit.is_of_a))
      on_face_.push_back(facets_.index().crossings()[i]);
    region.crossings = on_face_;
    region.inner_a = piece_exit.is_of_a ? &kNone : &local_.part();
    region.inner_b = piece_exit.is_of_a ? &local_.part() : &kNone;
  }
  add_region_points(region, candidates);
}

}  // namespace graze
