#pragma once

#include <string>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/meshes/parts_review.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// The contacts of two meshes that hit, `hits` being all pairs. See README.md for what is asked of
/// each engine, and of convex meshes.
PartsReview review_contacts(const MeshReferee& referee, const std::vector<TrianglePair>& hits,
                            const MeshCase& meshes, const std::vector<CaseContact>& contacts,
                            const std::string& engine);

}  // namespace graze::compare
