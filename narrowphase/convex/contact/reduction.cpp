#include <graze/narrowphase/convex/contact/meeting_points.h>
#include <graze/narrowphase/convex/contact/reduction.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace graze::narrowphase {
namespace {

// Squares of distances count as equal where they differ by no more than this share of them.
constexpr double kSame = 1e-4;

// Depths count as the same to this share of the width of the contact, which is how far from the
// first of its points any other lies, where a corner of a face may stand for the deepest.
constexpr double kAsDeep = 1e-5;

// Contacts are level where their depths differ by less than this share of their width.
constexpr double kLevel = 0.01;

// A contact is one of the outermost at this share of the greatest square from the middle.
constexpr double kOuter = 0.9;

// The greatest depth may be said to be less by this share of it, of the thousandth that law 15
// allows and of which the place where two round faces are deepest takes up to a fifth; and by this
// share of the size, which is more where stacks rest. The less contacts have to move the sooner
// they do.
constexpr double kLacking = 7e-4, kLackingOfSize = 2e-6;

// Depths of faces that only touch differ by this share of the width, which is rounding.
constexpr double kRoundingOfDepths = 0x1p-34;

// A contact that takes another's place takes its name if it is this near, as a share of the width.
constexpr double kNear = 0x1p-8;

// A point is on the plane of a face to this share of the size.
constexpr double kOnFace = 0x1p-36;

// So many moves are tried before a contact jumps: mostly the first is on the surfaces.
constexpr int kMostMoves = 8;

bool is_goal(const ContactPoint& contact) {
  return contact.feature_a == kDeepestOfFace;
}

/// True if its points are off the normal by more than `within`: then it is a contact of its own.
bool is_aside(const ContactPoint& contact, double within) {
  const Vec3 off = contact.point_a - contact.point_b - contact.normal * contact.depth;
  return dot(off, off) > within * within;
}

bool comes_before(const ContactPoint& s, const ContactPoint& t) {
  if (is_goal(s) != is_goal(t)) return is_goal(t);
  if (s.feature_a != t.feature_a) return s.feature_a < t.feature_a;
  if (s.feature_b != t.feature_b) return s.feature_b < t.feature_b;
  return s.depth > t.depth;
}

bool is_before_in_depth(const ContactPoint& s, const ContactPoint& t) {
  return s.depth != t.depth ? s.depth > t.depth : comes_before(s, t);
}

void sort_by_depth(std::span<ContactPoint> contacts) {
  if (std::is_sorted(contacts.begin(), contacts.end(), is_before_in_depth)) return;
  std::sort(contacts.begin(), contacts.end(), is_before_in_depth);
}

/// One of the contacts that are offered.
struct Offer {
  std::size_t at;  ///< its place among all that are offered
  Vec3 middle;
  double away;  ///< the square of how far it is from all that are kept, or from the first
};

/// Holds the contacts that are offered, in an order that changes without any of them being moved.
class Offered {
 public:
  explicit Offered(std::span<ContactPoint> contacts) : contacts_(contacts), offers_(scratch()) {
    offers_.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i)
      offers_.push_back({i, middle_of(contacts[i]), 0});
    std::sort(offers_.begin(), offers_.end(), [&](const Offer& s, const Offer& t) {
      const ContactPoint &left = contacts[s.at], &right = contacts[t.at];
      if (comes_before(left, right)) return true;
      return !comes_before(right, left) && s.at < t.at;
    });
  }

  std::size_t size() const { return offers_.size(); }
  ContactPoint& operator[](std::size_t i) const { return contacts_[offers_[i].at]; }
  const Vec3& middle(std::size_t i) const { return offers_[i].middle; }
  double& away(std::size_t i) const { return offers_[i].away; }
  double square_between(std::size_t i, std::size_t j) const {
    const Vec3 offset = middle(i) - middle(j);
    return dot(offset, offset);
  }

  /// Moves `next` to the front of those that are not kept yet, which stay in their order.
  void keep(std::size_t kept, std::size_t next) const {
    const auto place = [&](std::size_t i) {
      return offers_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::rotate(place(kept), place(next), place(next + 1));
  }

  /// Puts the first `kept` of them at the front of all contacts, the deepest first.
  std::size_t gather(std::size_t kept) const {
    static thread_local std::vector<ContactPoint> found;
    std::sort(offers_.begin(), offers_.begin() + static_cast<std::ptrdiff_t>(kept),
              [&](const Offer& s, const Offer& t) {
                return is_before_in_depth(contacts_[s.at], contacts_[t.at]);
              });
    found.clear();
    for (std::size_t i = 0; i < kept; ++i)
      found.push_back((*this)[i]);
    std::copy(found.begin(), found.end(), contacts_.begin());
    return kept;
  }

 private:
  static std::vector<Offer>& scratch() {
    static thread_local std::vector<Offer> offers;  // static so that no step of a simulation
                                                    // allocates
    return offers;
  }

  std::span<ContactPoint> contacts_;
  std::vector<Offer>& offers_;
};

/// Holds the least depth and the greatest, and how far from the first contact any other lies.
struct Extent {
  double shallowest = std::numeric_limits<double>::infinity();
  double deepest = -1;
  double width = 0;
};

Extent extent_of(const Offered& contacts) {
  Extent extent;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    extent.shallowest = std::min(extent.shallowest, contacts[i].depth);
    extent.deepest = std::max(extent.deepest, contacts[i].depth);
    extent.width = std::max(extent.width, contacts.square_between(i, 0));
  }
  extent.width = std::sqrt(extent.width);
  return extent;
}

/// Keeps, beside the first, whichever of those offered is farthest from all that are kept, until
/// there are `most`.
void keep_farthest(const Offered& contacts, std::size_t offered, std::size_t most) {
  for (std::size_t i = 1; i < offered; ++i)
    contacts.away(i) = contacts.square_between(i, 0);
  for (std::size_t kept = 1; kept < most; ++kept) {
    std::size_t next = kept;
    for (std::size_t i = kept + 1; i < offered; ++i)
      if (contacts.away(i) > contacts.away(next) * (1 + kSame)) next = i;
    contacts.keep(kept, next);
    for (std::size_t i = kept + 1; i < offered; ++i)
      contacts.away(i) = std::min(contacts.away(i), contacts.square_between(i, kept));
  }
}

/// Returns the first of the contacts offered that are about as far from the middle of these as any
/// is.
std::size_t outermost(const Offered& contacts, std::size_t offered) {
  Vec3 middle{0, 0, 0};
  for (std::size_t i = 0; i < offered; ++i)
    middle = middle + contacts.middle(i) * (1.0 / static_cast<double>(offered));
  double farthest = 0;
  for (std::size_t i = 0; i < offered; ++i) {
    const Vec3 offset = contacts.middle(i) - middle;
    contacts.away(i) = dot(offset, offset);
    farthest = std::max(farthest, contacts.away(i));
  }
  std::size_t at = 0;
  while (!(contacts.away(at) >= kOuter * farthest))
    ++at;
  return at;
}

std::size_t first_so_deep(const Offered& contacts, double depth) {
  std::size_t at = 0;
  while (contacts[at].depth < depth)
    ++at;
  return at;
}

/// Moves a kept contact to where another is deep enough.
struct Move {
  std::size_t from;
  std::size_t to;
  double share;   ///< the share of the segment to the other contact
  double square;  ///< the square of the move's length
};

/// Says what moves are to lead to.
struct Goals {
  double depth;   ///< the depth to come to, metres
  double within;  ///< points count as along the normal to this much
};

/// Returns the shortest move that is longer than `longer`.
std::optional<Move> next_move(const Offered& contacts, std::size_t kept, const Goals& goals,
                              double longer) {
  std::optional<Move> best;
  for (std::size_t i = 0; i < kept; ++i) {
    for (std::size_t j = kept; j < contacts.size(); ++j) {
      if (contacts[j].depth < goals.depth || is_aside(contacts[j], goals.within)) continue;
      const double share =
          (goals.depth - contacts[i].depth) / (contacts[j].depth - contacts[i].depth);
      const double square = share * share * contacts.square_between(i, j);
      if (square > longer && (!best || square * (1 + kSame) < best->square))
        best = Move{i, j, share, square};
    }
  }
  return best;
}

bool follow(const Move& move, const ContactSurfaces& surfaces, const Offered& contacts) {
  const ContactPoint& goal = contacts[move.to];
  ContactPoint moved = contacts[move.from];
  moved.point_a = moved.point_a + (goal.point_a - moved.point_a) * move.share;
  moved.point_b = moved.point_b + (goal.point_b - moved.point_b) * move.share;
  moved.depth += (goal.depth - moved.depth) * move.share;
  if (!surfaces.hold(moved)) return false;
  contacts[move.from] = moved;
  return true;
}

/// Makes one of the kept contacts as deep as the deepest of all. A deeper one in its place, which
/// has features of its own, would be another contact with every jitter.
void deepen(const Offered& contacts, std::size_t kept, const Extent& extent,
            const Reduction& reduction) {
  const auto has = [&](double depth) {
    for (std::size_t i = 0; i < kept; ++i)
      if (contacts[i].depth >= depth) return true;
    return false;
  };
  const double within = kRoundingOfDepths * extent.width;
  if (reduction.surfaces == nullptr) {
    if (has(extent.deepest - kAsDeep * extent.width)) return;
  } else {
    const double depth =
        std::min(least_of_deepest(extent.deepest, {reduction.margin, extent.width}),
                 extent.deepest - within);
    if (has(depth)) return;
    double longer = -1;
    for (int i = 0; i < kMostMoves; ++i) {
      const std::optional<Move> move = next_move(contacts, kept, {depth, within}, longer);
      if (!move) break;
      if (follow(*move, *reduction.surfaces, contacts)) return;
      longer = move->square;
    }
  }
  const std::size_t at = first_so_deep(contacts, extent.deepest);
  std::size_t next = 0;
  for (std::size_t i = 1; i < kept; ++i)
    if (contacts.square_between(i, at) < contacts.square_between(next, at)) next = i;
  ContactPoint &nearest = contacts[next], taken = contacts[at];
  // Where surfaces are known a place has to be taken so seldom that a contact from far away may
  // count as another one.
  const double far = reduction.surfaces == nullptr ? 2 : kNear;
  const bool is_near = contacts.square_between(next, at) <= far * far * extent.width * extent.width;
  if (is_near && !is_aside(taken, within))
    taken.feature_a = nearest.feature_a, taken.feature_b = nearest.feature_b;
  nearest = taken;
}

}  // namespace

double least_of_deepest(double depth, const DepthScale& scale) {
  return depth - std::min(kLacking * std::abs(depth - scale.margin), kLackingOfSize * scale.size);
}

double least_offered(double depth, const DepthScale& scale) {
  return depth - 0.25 * (depth - least_of_deepest(depth, scale));
}

bool move_onto_face(const Core& core, const Vec3& out, double margin, Vec3& point) {
  const ContactFace face = face_along(core, out);
  if (face.count == 1) return false;
  const Vec3 own = margin > 0 ? point - out * margin : point;
  if (!is_uneven({face, core})) {
    const double size = core.bounding_radius + core.radius + margin;
    return std::abs(dot(face.normal, own - face.corner[0])) <= kOnFace * size;
  }
  const std::optional<Vec3> on_surface = onto_surface({face, core}, own, out);
  if (on_surface) point = margin > 0 ? *on_surface + out * margin : *on_surface;
  return on_surface.has_value();
}

bool CoreSurfaces::hold(ContactPoint& contact) const {
  const Vec3& normal = contact.normal;
  if (!move_onto_face(a_, normal, margin_, contact.point_a) ||
      !move_onto_face(b_, -normal, 0, contact.point_b))
    return false;
  contact.depth = std::max(dot(contact.point_a - contact.point_b, normal), contact.depth);
  return true;
}

std::size_t reduce(std::span<ContactPoint> contacts, const Reduction& reduction) {
  const std::size_t most = reduction.most;
  const bool has_goal =
      reduction.surfaces != nullptr && std::any_of(contacts.begin(), contacts.end(), is_goal);
  if (contacts.size() <= most && !has_goal) {
    sort_by_depth(contacts);
    return contacts.size();
  }
  const Offered all(contacts);
  const Extent extent = extent_of(all);
  const bool is_level = extent.deepest - extent.shallowest < kLevel * extent.width;
  std::size_t corners = all.size();
  while (has_goal && corners > 0 && is_goal(all[corners - 1]))
    --corners;
  const std::size_t offered = is_level && corners > 2 ? corners : all.size();
  if (offered > most) {
    const double deep_enough = extent.deepest - kAsDeep * extent.width;
    all.keep(0, is_level ? outermost(all, offered) : first_so_deep(all, deep_enough));
    keep_farthest(all, offered, most);
  }
  const std::size_t kept = std::min(offered, most);
  if (kept < all.size()) deepen(all, kept, extent, reduction);
  return all.gather(kept);
}

}  // namespace graze::narrowphase
