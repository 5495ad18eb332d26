#include <graze/engine/compare/judge/meshes/mesh_judges.h>
#include <graze/engine/compare/judge/meshes/mesh_reviews.h>
#include <graze/engine/compare/judge/meshes/mesh_truth.h>
#include <graze/engine/compare/judge/meshes/witness_check.h>
#include <graze/engine/compare/judge/rational/in_metres.h>
#include <graze/engine/compare/judge/rational/least_translation.h>
#include <graze/engine/compare/judge/rational/rational_triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace graze::compare {
namespace {

/// So many pairs of a list are looked at for the worst.
constexpr std::size_t kMaxExamined = 64;

bool is_solid(const Case& query) {
  return query.settings.hit == Hit::Solid;
}

}  // namespace

MeshTruth::MeshTruth(const Case& the_query, const MeshCase& the_meshes)
    : query_(the_query),
      meshes_(the_meshes),
      referee_(placed_a(), placed_b(),
               the_query.settings.hit == Hit::Crossing ? Touch::Exclude : Touch::Include) {}

const std::vector<TrianglePair>& MeshTruth::hits() {
  std::call_once(hits_once_, [&] { known_hits_ = referee_.find_hits(); });
  return known_hits_;
}

bool MeshTruth::is_hit() {
  std::call_once(any_once_, [&] { first_hit_ = referee_.find_hit(); });
  return first_hit_.has_value();
}

const MeshReferee::Gap& MeshTruth::gap(const std::optional<TrianglePair>& hint) {
  std::call_once(gap_once_, [&] { known_gap_ = referee_.find_gap(hint); });
  return known_gap_;
}

/// Keeps the worst class, and of one class the largest error.
void MeshTruth::add_error(Judgement& judgement, const TrianglePair& pair, bool is_a_hit) {
  // The answer may claim a touch where no surfaces meet.
  std::function<bool()> contained;
  if (!is_a_hit && !is_hit()) contained = [this] { return is_contained(); };
  PairError error = pair_error(placed_a(), placed_b(), pair, is_a_hit, contained);
  // Whether real numbers touch says nothing of whether they cross.
  const bool is_of_crossing = query_.settings.hit == Hit::Crossing;
  if (is_of_crossing && error.error_class == ErrorClass::PoseRounding)
    error.error_class = ErrorClass::Touching;
  const bool is_worse =
      !judgement.culprit || error.error_class > judgement.error_class ||
      (error.error_class == judgement.error_class && error.error > judgement.error);
  if (!is_worse) return;
  judgement.error_class = error.error_class;
  judgement.error = error.error;
  judgement.ulps = error.ulps;
  judgement.culprit = pair;
}

/// True if one mesh is inside the other, for meshes that are apart on the surface. It names a
/// reason, and decides no verdict.
bool MeshTruth::is_contained() const {
  return is_one_inside(meshes_).value_or(false);
}

bool MeshTruth::has_area(const TrianglePair& pair) const {
  return !has_no_area(exactly(referee_.triangle_a(pair.a))) &&
         !has_no_area(exactly(referee_.triangle_b(pair.b)));
}

/// Adds the class and size of having overlooked all hits. Each pair alone gives a lower bound only:
/// the error is how far B must be moved until none is left.
void MeshTruth::add_missed_hit(Judgement& judgement) {
  const std::size_t examined = std::min(hits().size(), kMaxExamined);
  double ulp = 0;
  for (std::size_t i = 0; i < examined; ++i) {
    const TrianglePair& pair = hits()[i];
    add_error(judgement, pair, true);
    ulp = std::max(ulp, ulp_of(referee_.triangle_a(pair.a), referee_.triangle_b(pair.b)));
  }
  const bool are_triangles =
      meshes_.a.mesh.triangles().size() == 1 && meshes_.b.mesh.triangles().size() == 1;
  const bool is_degenerate = std::none_of(hits().begin(), hits().end(),
                                          [&](const TrianglePair& pair) { return has_area(pair); });
  if (are_triangles || is_degenerate) return;

  LeastTranslation separating_translation(referee_, hits());
  const bool may_be_rounding = judgement.error_class != ErrorClass::Real;
  const std::optional<double> length =
      may_be_rounding ? separating_translation.find_within(kTouchUlps * ulp) : std::nullopt;
  judgement.error = length ? *length : std::max(separating_translation.find(), judgement.error);
  judgement.ulps = judgement.error / ulp;
  if (!length) {
    judgement.error_class = ErrorClass::Real;
  } else if (judgement.error_class == ErrorClass::PoseRounding &&
             !is_hit_by_placing(placed_a(), placed_b())) {
    judgement.error_class = ErrorClass::Touching;
  }
}

Judgement MeshTruth::judge_any(bool says) {
  Judgement judgement;
  judgement.truth = is_hit() ? "hit" : "apart";
  judgement.verdict = says == is_hit() ? Verdict::Right : Verdict::Wrong;
  if (judgement.verdict == Verdict::Right) return judgement;
  if (is_hit()) {
    add_missed_hit(judgement);
    return judgement;
  }
  const MeshReferee::Gap& nearest = gap(std::nullopt);
  judgement.truth = in_metres("apart by", rounded_root(nearest.square));
  add_error(judgement, nearest.pair, false);
  return judgement;
}

/// Judges a list that was cut: any pairs do, if they are true and as many as the limit lets pass.
Judgement MeshTruth::judge_cut_list(const std::vector<TrianglePair>& pairs) {
  const std::size_t count = std::min<std::size_t>(*query_.settings.limit, hits().size());
  std::vector<TrianglePair> wrong;
  std::set_difference(pairs.begin(), pairs.end(), hits().begin(), hits().end(),
                      std::back_inserter(wrong));
  if (wrong.empty() && pairs.size() != count) {
    std::set_difference(hits().begin(), hits().end(), pairs.begin(), pairs.end(),
                        std::back_inserter(wrong));
  }
  Judgement judgement;
  judgement.truth = std::to_string(count) + " of " + std::to_string(hits().size()) +
                    (hits().size() == 1 ? " pair" : " pairs");
  const bool is_right = wrong.empty() && pairs.size() == count;
  judgement.verdict = is_right ? Verdict::Right : Verdict::Wrong;
  judgement.wrong_pairs = wrong.size();
  for (std::size_t i = 0; i < std::min(wrong.size(), kMaxExamined); ++i) {
    const bool is_true = std::binary_search(hits().begin(), hits().end(), wrong[i]);
    add_error(judgement, wrong[i], is_true);
  }
  return judgement;
}

/// Judges solids: they meet if their surfaces share a point, and else if one mesh is inside the
/// other.
Judgement MeshTruth::judge_solid(bool says) {
  if (is_hit()) return judge_any(says);
  const std::optional<bool> is_inside = is_one_inside(meshes_);
  Judgement judgement;
  if (!is_inside) return judgement;
  if (!*is_inside) return judge_any(says);
  const MeshReferee::Gap& nearest = gap(std::nullopt);
  judgement.truth = in_metres("one inside the other by", rounded_root(nearest.square));
  judgement.verdict = says ? Verdict::Right : Verdict::Wrong;
  if (!says) add_error(judgement, nearest.pair, false);
  return judgement;
}

Judgement MeshTruth::judge_list(const std::vector<TrianglePair>& pairs) {
  std::vector<TrianglePair> wrong;
  std::set_symmetric_difference(pairs.begin(), pairs.end(), hits().begin(), hits().end(),
                                std::back_inserter(wrong));
  Judgement judgement;
  judgement.truth = std::to_string(hits().size()) + (hits().size() == 1 ? " pair" : " pairs");
  judgement.verdict = wrong.empty() ? Verdict::Right : Verdict::Wrong;
  judgement.wrong_pairs = wrong.size();
  if (pairs.empty() && !hits().empty()) {  // that is to say that they are apart
    add_missed_hit(judgement);
    return judgement;
  }
  for (std::size_t i = 0; i < std::min(wrong.size(), kMaxExamined); ++i) {
    const bool is_true = std::binary_search(hits().begin(), hits().end(), wrong[i]);
    add_error(judgement, wrong[i], is_true);
  }
  return judgement;
}

// Law 7 allows four ulp of the largest difference of placed coordinates.
double MeshTruth::distance_tolerance(const TrianglePair& pair, bool is_graze) const {
  const Triangle& a = referee_.triangle_a(pair.a);
  const Triangle& b = referee_.triangle_b(pair.b);
  if (!is_graze) return kTouchUlps * ulp_of(a, b);
  double largest = 0;
  const std::array<const Eigen::Vector3d*, 6> corners = {&a.a, &a.b, &a.c, &b.a, &b.b, &b.c};
  for (const Eigen::Vector3d* p : corners) {
    for (const Eigen::Vector3d* q : corners)
      largest = std::max(largest, (*p - *q).cwiseAbs().maxCoeff());
  }
  if (!std::isfinite(largest)) return 0x1p+974;  // differences beyond the range: 4 ulp of its end
  return 4 * (std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest);
}

/// Judges a negative distance, as other engines return it. It claims a touch, and no more: how deep
/// it is has as many definitions as there are engines.
Judgement MeshTruth::judge_touch_claim(const MeshReferee::Gap& nearest) {
  Judgement judgement;
  judgement.truth = in_metres("apart by", rounded_root(nearest.square));
  judgement.error = rounded_root(nearest.square);
  judgement.ulps = judgement.error /
                   ulp_of(referee_.triangle_a(nearest.pair.a), referee_.triangle_b(nearest.pair.b));
  judgement.verdict = judgement.ulps <= kTouchUlps ? Verdict::Right : Verdict::Wrong;
  return judgement;
}

Judgement MeshTruth::judge_contacts(const CaseAnswer& answer, const std::string& engine) {
  Judgement judgement = judge_any(!answer.contacts->empty());
  if (judgement.verdict == Verdict::Wrong || answer.contacts->empty()) return judgement;
  add_review(judgement, review_contacts(referee_, hits(), meshes_, *answer.contacts, engine),
             ulp());
  return judgement;
}

Judgement MeshTruth::judge_intersection(const CaseAnswer& answer) {
  const bool is_empty =
      answer.intersection ? answer.intersection->points.empty() : answer.corners->empty();
  Judgement judgement = judge_any(!is_empty);
  if (judgement.verdict == Verdict::Wrong || is_empty) return judgement;
  add_review(judgement,
             answer.intersection
                 ? review_intersection(referee_, hits(), *answer.intersection)
                 : review_corners(referee_.triangle_a(0), referee_.triangle_b(0), *answer.corners),
             ulp());
  return judgement;
}

Judgement MeshTruth::judge_distance(const CaseAnswer& answer, bool is_graze) {
  const MeshReferee::Gap& nearest = gap(answer.pair);
  const double claimed = *answer.distance;
  const bool claims_touch = claimed < 0 && !is_graze;
  Judgement judgement = claims_touch ? judge_touch_claim(nearest) : Judgement();
  if (!claims_touch) {
    judgement.truth = in_metres("apart by", rounded_root(nearest.square));
    judgement.error = root_error(claimed, nearest.square);
    judgement.ulps = judgement.error / ulp_of(referee_.triangle_a(nearest.pair.a),
                                              referee_.triangle_b(nearest.pair.b));
    const bool agrees_on_zero = !is_graze || (claimed == 0) == (nearest.square == 0);
    const bool is_right =
        agrees_on_zero && judgement.error <= distance_tolerance(nearest.pair, is_graze);
    judgement.verdict = is_right ? Verdict::Right : Verdict::Wrong;
    if (is_right) {
      const double tolerance = distance_tolerance(nearest.pair, is_graze);
      add_review(judgement, {.fault = fault_of_distance(referee_, nearest, answer, tolerance)},
                 ulp());
      return judgement;
    }
  }
  if (judgement.verdict == Verdict::Right) {
    // -1 is the word of some engines for a touch; another number is how deep it is to them.
    if (claimed != -1) add_review(judgement, {.unjudged = "how deep"}, ulp());
    return judgement;
  }
  add_class(judgement, nearest, claimed <= 0);
  return judgement;
}

/// Adds the class of a claim about the nearest pair, whose size is known.
void MeshTruth::add_class(Judgement& judgement, const MeshReferee::Gap& nearest,
                          bool claims_touch) {
  const bool is_touch = nearest.square == 0;
  judgement.culprit = nearest.pair;
  judgement.error_class = class_of_pair(
      exactly(referee_.triangle_a(nearest.pair.a)), exactly(referee_.triangle_b(nearest.pair.b)),
      judgement.ulps,
      [&] {
        return claims_touch != is_touch &&
               is_due_to_placing(placed_a(), placed_b(), nearest.pair, is_touch);
      },
      [&] { return claims_touch && !is_touch && is_contained(); });
}

Judgement MeshTruth::judge_within(bool says, bool is_graze) {
  const MeshReferee::Gap& nearest = gap(std::nullopt);
  const double clearance = query_.settings.clearance;
  const mpq_class square = mpq_class(clearance) * mpq_class(clearance);
  Judgement judgement;
  judgement.truth = in_metres("apart by", rounded_root(nearest.square));
  judgement.error = root_error(clearance, nearest.square);
  const Triangle& a = referee_.triangle_a(nearest.pair.a);
  const Triangle& b = referee_.triangle_b(nearest.pair.b);
  judgement.ulps = judgement.error / ulp_of(a, b);
  // The question is about the rounded distance (law 7), so that either answer is right this near.
  const bool is_right = says == (nearest.square <= square) ||
                        judgement.error <= distance_tolerance(nearest.pair, is_graze);
  judgement.verdict = is_right ? Verdict::Right : Verdict::Wrong;
  if (is_right) return judgement;
  add_class(judgement, nearest, says);
  return judgement;
}

Judgement MeshTruth::judge(const CaseAnswer& answer, const CaseWitness& witness) {
  const bool is_graze = witness.engine == "graze";
  const bool lists_pairs = query_.ask == Ask::Pairs && answer.pairs;
  if (query_.ask == Ask::Any && answer.says) {
    return is_solid(query_) ? judge_solid(*answer.says) : judge_any(*answer.says);
  }
  if (lists_pairs) {
    return query_.settings.limit ? judge_cut_list(*answer.pairs) : judge_list(*answer.pairs);
  }
  if (query_.ask == Ask::Intersection) return judge_intersection(answer);
  if (query_.ask == Ask::Separation) return judge_separation(query_, meshes_, answer);
  if (query_.ask == Ask::Distance) return judge_distance(answer, is_graze);
  if (query_.ask == Ask::Within && answer.says) return judge_within(*answer.says, is_graze);
  if (query_.ask == Ask::Contacts && answer.contacts) return judge_contacts(answer, witness.engine);
  return {};
}

}  // namespace graze::compare
