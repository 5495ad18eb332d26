#pragma once

#include <mutex>
#include <optional>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/meshes/pair_error.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// Holds what is true of two meshes, found when it is first needed, and judges what answers say of
/// it. Many threads may ask it.
class MeshTruth {
 public:
  /// Keeps the case, which must outlive it.
  MeshTruth(const Case& the_query, const MeshCase& the_meshes);

  Judgement judge(const CaseAnswer& answer, const CaseWitness& witness);

 private:
  PlacedMeshView placed_a() const { return {meshes_.a.mesh, meshes_.a.pose}; }
  PlacedMeshView placed_b() const { return {meshes_.b.mesh, meshes_.b.pose}; }

  const std::vector<TrianglePair>& hits();
  bool is_hit();
  const MeshReferee::Gap& gap(const std::optional<TrianglePair>& hint);

  Judgement judge_any(bool says);
  void add_missed_hit(Judgement& judgement);
  bool is_contained() const;
  bool has_area(const TrianglePair& pair) const;
  Judgement judge_list(const std::vector<TrianglePair>& pairs);
  Judgement judge_cut_list(const std::vector<TrianglePair>& pairs);
  Judgement judge_distance(const CaseAnswer& answer, bool is_graze);
  Judgement judge_contacts(const CaseAnswer& answer, const std::string& engine);
  Judgement judge_intersection(const CaseAnswer& answer);
  Judgement judge_solid(bool says);
  double ulp() const { return ulp_of(referee_.triangle_a(0), referee_.triangle_b(0)); }
  Judgement judge_touch_claim(const MeshReferee::Gap& nearest);
  Judgement judge_within(bool says, bool is_graze);
  void add_class(Judgement& judgement, const MeshReferee::Gap& nearest, bool claims_touch);
  double distance_tolerance(const TrianglePair& pair, bool is_graze) const;
  void add_error(Judgement& judgement, const TrianglePair& pair, bool is_a_hit);

  const Case& query_;
  MeshCase meshes_;
  MeshReferee referee_;
  std::once_flag hits_once_;
  std::once_flag any_once_;
  std::once_flag gap_once_;
  std::vector<TrianglePair> known_hits_;
  std::optional<TrianglePair> first_hit_;
  MeshReferee::Gap known_gap_;
};

}  // namespace graze::compare
