#include <graze/bvh/error.h>
#include <graze/engine/compare/judge/answer_fault.h>
#include <graze/engine/compare/judge/in_metres.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/mesh_referee.h>
#include <graze/engine/compare/judge/pair_error.h>
#include <graze/engine/compare/judge/rational_triangle.h>
#include <graze/engine/compare/judge/shape_judge.h>
#include <graze/engine/compare/judge/volume_judge.h>
#include <graze/engine/compare/judge/way_out.h>
#include <graze/engine/compare/judge/witness_check.h>
#include <graze/engine/compare/peers/engine.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/placement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>

namespace graze::compare {
namespace {

/// So many pairs of a list are looked at for the worst.
constexpr std::size_t kMaxExamined = 64;

bool may_be_judged(const Case& query) {
  return query.settings.touch == Touch::Include && query.settings.interior == Interior::Surface;
}

}  // namespace

/// What is true, found when it is first needed.
struct Judge::Truth {
  explicit Truth(const Case& the_query) : query(the_query), meshes(as_meshes(the_query)) {
    if (meshes) referee.emplace(placed_a(), placed_b());
    if (const std::optional<BodyCase> pair = as_bodies(query)) {
      bodies.emplace(PlacedBody{pair->a.shape, pair->a.pose},
                     PlacedBody{pair->b.shape, pair->b.pose});
    }
  }

  PlacedMesh placed_a() const { return {meshes->a.mesh, meshes->a.pose}; }
  PlacedMesh placed_b() const { return {meshes->b.mesh, meshes->b.pose}; }

  const std::vector<TrianglePair>& hits() {
    std::call_once(hits_once, [&] { known_hits = referee->find_hits(); });
    return known_hits;
  }
  bool is_hit() {
    std::call_once(any_once, [&] { first_hit = referee->find_hit(); });
    return first_hit.has_value();
  }
  const MeshReferee::Gap& gap(const std::optional<TrianglePair>& hint) {
    std::call_once(gap_once, [&] { known_gap = referee->find_gap(hint); });
    return known_gap;
  }

  Judgement judge_any(bool says, const JudgeSettings& settings);
  void add_missed_hit(Judgement& judgement, const JudgeSettings& settings);
  bool is_one_inside() const;
  bool has_area(const TrianglePair& pair) const;
  Judgement judge_list(const std::vector<TrianglePair>& pairs, const JudgeSettings& settings);
  Judgement judge_cut_list(const std::vector<TrianglePair>& pairs, const JudgeSettings& settings);
  Judgement judge_separation(const Eigen::Vector3d& translation);
  Judgement judge_distance(const CaseAnswer& answer, bool is_graze);
  Judgement judge_contacts(const CaseAnswer& answer, const JudgeSettings& settings);
  void add_fault(Judgement& judgement, const std::optional<WitnessFault>& fault) const;
  Judgement judge_touch_claim(const MeshReferee::Gap& nearest);
  Judgement judge_within(bool says, bool is_graze);
  double distance_tolerance(const TrianglePair& pair, bool is_graze) const;
  void add_error(Judgement& judgement, const TrianglePair& pair, bool is_a_hit,
                 const JudgeSettings& settings) const;

  const Case& query;
  std::optional<MeshCase> meshes;
  std::optional<MeshReferee> referee;
  std::optional<ShapeJudge> bodies;
  std::once_flag hits_once;
  std::once_flag any_once;
  std::once_flag gap_once;
  std::vector<TrianglePair> known_hits;
  std::optional<TrianglePair> first_hit;
  MeshReferee::Gap known_gap;
};

/// Keeps the worst class, and of one class the largest error.
void Judge::Truth::add_error(Judgement& judgement, const TrianglePair& pair, bool is_a_hit,
                             const JudgeSettings& settings) const {
  const PairError error = pair_error(placed_a(), placed_b(), pair, is_a_hit, settings);
  const bool is_worse =
      !judgement.culprit || error.error_class > judgement.error_class ||
      (error.error_class == judgement.error_class && error.error > judgement.error);
  if (!is_worse) return;
  judgement.error_class = error.error_class;
  judgement.error = error.error;
  judgement.ulps = error.ulps;
  judgement.culprit = pair;
}

/// For what is apart on the surface. It names a reason, and decides no verdict.
bool Judge::Truth::is_one_inside() const {
  return meshes->a.mesh.topology().is_closed && meshes->b.mesh.topology().is_closed &&
         intersects(placed_a(), placed_b(), {.interior = Interior::Solid});
}

bool Judge::Truth::has_area(const TrianglePair& pair) const {
  return !has_no_area(exactly(referee->triangle_a(pair.a))) &&
         !has_no_area(exactly(referee->triangle_b(pair.b)));
}

/// The class and size of having overlooked all hits. Each pair alone gives a lower bound only: the
/// error is how far B must be moved until none is left.
void Judge::Truth::add_missed_hit(Judgement& judgement, const JudgeSettings& settings) {
  const std::size_t examined = std::min(hits().size(), kMaxExamined);
  double ulp = 0;
  for (std::size_t i = 0; i < examined; ++i) {
    const TrianglePair& pair = hits()[i];
    add_error(judgement, pair, true, settings);
    ulp = std::max(ulp, ulp_of(referee->triangle_a(pair.a), referee->triangle_b(pair.b)));
  }
  const bool are_triangles =
      meshes->a.mesh.triangles().size() == 1 && meshes->b.mesh.triangles().size() == 1;
  const bool is_degenerate = std::none_of(hits().begin(), hits().end(),
                                          [&](const TrianglePair& pair) { return has_area(pair); });
  if (are_triangles || is_degenerate) return;

  WayOut way_out(*referee, hits());
  const bool may_be_rounding = judgement.error_class != ErrorClass::Real;
  const std::optional<double> way =
      may_be_rounding ? way_out.find_within(kTouchUlps * ulp) : std::nullopt;
  judgement.error = way ? *way : std::max(way_out.find(), judgement.error);
  judgement.ulps = judgement.error / ulp;
  if (!way) {
    judgement.error_class = ErrorClass::Real;
  } else if (judgement.error_class == ErrorClass::PoseRounding && !settings.ask_again &&
             !is_hit_by_placing(placed_a(), placed_b())) {
    judgement.error_class = ErrorClass::Touching;
  }
}

Judgement Judge::Truth::judge_any(bool says, const JudgeSettings& settings) {
  Judgement judgement;
  judgement.truth = is_hit() ? "hit" : "apart";
  judgement.verdict = says == is_hit() ? Verdict::Right : Verdict::Wrong;
  if (judgement.verdict == Verdict::Right) return judgement;
  if (is_hit()) {
    add_missed_hit(judgement, settings);
    return judgement;
  }
  const MeshReferee::Gap& nearest = gap(std::nullopt);
  judgement.truth = in_metres("apart by", rounded_root(nearest.square));
  add_error(judgement, nearest.pair, false, settings);
  if (is_one_inside()) judgement.error_class = ErrorClass::Containment;
  return judgement;
}

/// Any pairs do, if they are true and as many as the limit lets pass.
Judgement Judge::Truth::judge_cut_list(const std::vector<TrianglePair>& pairs,
                                       const JudgeSettings& settings) {
  const std::size_t count = std::min<std::size_t>(*query.settings.limit, hits().size());
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
    add_error(judgement, wrong[i], is_true, settings);
  }
  return judgement;
}

/// It must separate: by how much less would do is not judged.
Judgement Judge::Truth::judge_separation(const Eigen::Vector3d& translation) {
  Pose moved = meshes->b.pose;
  moved.translation() += translation;
  try {
    check_placement(moved, meshes->b.mesh.bounds(), "the pose of B");
  } catch (const Error&) {
    Judgement judgement;
    judgement.truth = "it takes B out of the range of double";
    return judgement;
  }
  const Case after = {.note = "",
                      .ask = Ask::Any,
                      .settings = {},
                      .a = meshes->a,
                      .b = CaseMesh(meshes->b.mesh, moved),
                      .answer = std::nullopt,
                      .answered_by = {}};
  Truth then(after);
  Judgement judgement = then.judge_any(false, {});
  judgement.truth = judgement.verdict == Verdict::Right ? "apart after it, length not judged"
                                                        : "still a hit after it";
  return judgement;
}

Judgement Judge::Truth::judge_list(const std::vector<TrianglePair>& pairs,
                                   const JudgeSettings& settings) {
  std::vector<TrianglePair> wrong;
  std::set_symmetric_difference(pairs.begin(), pairs.end(), hits().begin(), hits().end(),
                                std::back_inserter(wrong));
  Judgement judgement;
  judgement.truth = std::to_string(hits().size()) + (hits().size() == 1 ? " pair" : " pairs");
  judgement.verdict = wrong.empty() ? Verdict::Right : Verdict::Wrong;
  judgement.wrong_pairs = wrong.size();
  if (pairs.empty() && !hits().empty()) {  // that is to say that they are apart
    add_missed_hit(judgement, settings);
    return judgement;
  }
  for (std::size_t i = 0; i < std::min(wrong.size(), kMaxExamined); ++i) {
    const bool is_true = std::binary_search(hits().begin(), hits().end(), wrong[i]);
    add_error(judgement, wrong[i], is_true, settings);
  }
  return judgement;
}

// Law 7: four ulp of the largest difference of placed coordinates.
double Judge::Truth::distance_tolerance(const TrianglePair& pair, bool is_graze) const {
  const Triangle& a = referee->triangle_a(pair.a);
  const Triangle& b = referee->triangle_b(pair.b);
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

/// A negative distance, as other engines return it, claims a touch, and no more: how deep it is has
/// as many definitions as there are engines.
Judgement Judge::Truth::judge_touch_claim(const MeshReferee::Gap& nearest) {
  Judgement judgement;
  judgement.truth = in_metres("apart by", rounded_root(nearest.square));
  judgement.error = rounded_root(nearest.square);
  judgement.ulps = judgement.error /
                   ulp_of(referee->triangle_a(nearest.pair.a), referee->triangle_b(nearest.pair.b));
  judgement.verdict = judgement.ulps <= kTouchUlps ? Verdict::Right : Verdict::Wrong;
  return judgement;
}

/// What else an answer says may be wrong though its number is right.
void Judge::Truth::add_fault(Judgement& judgement, const std::optional<WitnessFault>& fault) const {
  if (!fault) return;
  judgement.verdict = Verdict::Wrong;
  judgement.error_class = ErrorClass::Real;
  judgement.truth += ", but " + fault->what;
  judgement.error = fault->error;
  judgement.ulps = fault->error / ulp_of(referee->triangle_a(0), referee->triangle_b(0));
}

Judgement Judge::Truth::judge_contacts(const CaseAnswer& answer, const JudgeSettings& settings) {
  Judgement judgement = judge_any(!answer.contacts->empty(), settings);
  if (judgement.verdict == Verdict::Wrong || answer.contacts->empty()) return judgement;
  const std::optional<WitnessFault> fault = fault_of_contacts(*referee, answer);
  add_fault(judgement, fault);
  if (!fault) judgement.truth += ", depths not judged";
  return judgement;
}

Judgement Judge::Truth::judge_distance(const CaseAnswer& answer, bool is_graze) {
  const MeshReferee::Gap& nearest = gap(answer.pair);
  const double claimed = *answer.distance;
  const bool claims_touch = claimed < 0 && !is_graze;
  Judgement judgement = claims_touch ? judge_touch_claim(nearest) : Judgement();
  if (!claims_touch) {
    judgement.truth = in_metres("apart by", rounded_root(nearest.square));
    judgement.error = root_error(claimed, nearest.square);
    judgement.ulps = judgement.error / ulp_of(referee->triangle_a(nearest.pair.a),
                                              referee->triangle_b(nearest.pair.b));
    const bool agrees_on_zero = !is_graze || (claimed == 0) == (nearest.square == 0);
    const bool is_right =
        agrees_on_zero && judgement.error <= distance_tolerance(nearest.pair, is_graze);
    judgement.verdict = is_right ? Verdict::Right : Verdict::Wrong;
    if (is_right) add_fault(judgement, fault_of_distance(*referee, answer));
    if (is_right) return judgement;
  }
  if (judgement.verdict == Verdict::Right) return judgement;
  judgement.culprit = nearest.pair;
  if (!has_area(nearest.pair)) {
    judgement.error_class = ErrorClass::Degenerate;
  } else if (judgement.ulps <= kTouchUlps) {
    judgement.error_class = ErrorClass::Touching;
  } else if (claimed <= 0 && nearest.square != 0 && is_one_inside()) {
    judgement.error_class = ErrorClass::Containment;
  }
  return judgement;
}

Judgement Judge::Truth::judge_within(bool says, bool is_graze) {
  const MeshReferee::Gap& nearest = gap(std::nullopt);
  const double clearance = query.settings.clearance;
  const mpq_class square = mpq_class(clearance) * mpq_class(clearance);
  Judgement judgement;
  judgement.truth = in_metres("apart by", rounded_root(nearest.square));
  judgement.error = root_error(clearance, nearest.square);
  const Triangle& a = referee->triangle_a(nearest.pair.a);
  const Triangle& b = referee->triangle_b(nearest.pair.b);
  judgement.ulps = judgement.error / ulp_of(a, b);
  // It speaks of the rounded distance (law 7), so that either answer is right this near.
  const bool is_right = says == (nearest.square <= square) ||
                        judgement.error <= distance_tolerance(nearest.pair, is_graze);
  judgement.verdict = is_right ? Verdict::Right : Verdict::Wrong;
  if (is_right) return judgement;
  judgement.culprit = nearest.pair;
  if (judgement.ulps <= kTouchUlps) {
    judgement.error_class = ErrorClass::Touching;
  } else if (says && is_one_inside()) {
    judgement.error_class = ErrorClass::Containment;
  }
  return judgement;
}

Judge::Judge(const Case& query) : truth_(std::make_unique<Truth>(query)) {}
Judge::~Judge() = default;

Judgement Judge::judge(const CaseAnswer& answer, const CaseWitness& witness,
                       const JudgeSettings& settings) const {
  const bool is_graze = witness.engine == "graze";
  const Case& query = truth_->query;
  if (const std::optional<std::string> fault = fault_of_answer(query, answer)) {
    return engine_error(*fault);
  }
  if (!may_be_judged(query) || !query.b) return {};
  if (truth_->bodies) {
    if (query.ask != Ask::Any || !answer.says) return {};
    return truth_->bodies->judge(*answer.says, witness, settings);
  }
  if (!truth_->meshes) return judge_volumes(query, answer, is_graze);
  if (query.ask == Ask::Any && answer.says) return truth_->judge_any(*answer.says, settings);
  if (query.ask == Ask::Pairs && answer.pairs) {
    return query.settings.limit ? truth_->judge_cut_list(*answer.pairs, settings)
                                : truth_->judge_list(*answer.pairs, settings);
  }
  if (query.ask == Ask::Intersection && (answer.intersection || answer.corners)) {
    const bool is_hit =
        answer.intersection ? !answer.intersection->points.empty() : !answer.corners->empty();
    Judgement judgement = truth_->judge_any(is_hit, settings);
    if (judgement.verdict == Verdict::Right && is_hit) judgement.truth += ", its parts not judged";
    return judgement;
  }
  if (query.ask == Ask::Separation && answer.translation) {
    return truth_->judge_separation(*answer.translation);
  }
  if (query.ask == Ask::Distance && answer.distance)
    return truth_->judge_distance(answer, is_graze);
  if (query.ask == Ask::Within && answer.says) return truth_->judge_within(*answer.says, is_graze);
  if (query.ask == Ask::Contacts && answer.contacts) {
    return truth_->judge_contacts(answer, settings);
  }
  return {};
}

const char* name_of(Verdict verdict) {
  constexpr std::array kNames = {"right", "wrong", "not judged", "not confirmed"};
  return kNames[static_cast<std::size_t>(verdict)];
}

const char* name_of(ErrorClass error_class) {
  constexpr std::array kNames = {"touching",    "pose rounding", "degenerate",
                                 "containment", "real",          "engine error"};
  return kNames[static_cast<std::size_t>(error_class)];
}

}  // namespace graze::compare
