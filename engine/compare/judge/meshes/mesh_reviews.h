#pragma once

#include <graze/engine/cases/case.h>
#include <graze/engine/cases/case_intersection.h>
#include <graze/engine/compare/judge/meshes/parts_review.h>
#include <graze/engine/compare/judge/rational/mesh_referee.h>
#include <graze/engine/compare/peers/engine.h>

#include <string>
#include <vector>

namespace graze::compare {

/// Reviews the contacts of two meshes that hit, `hits` being all pairs. See README.md for what is
/// asked of each engine, and of convex meshes.
PartsReview review_contacts(const MeshReferee& referee, const std::vector<TrianglePair>& hits,
                            const MeshCase& meshes, const std::vector<CaseContact>& contacts,
                            const std::string& engine);

/// Reviews the parts of an intersection: every point lies on both triangles of each pair of its
/// part, within kTouchUlps of the largest coordinate; every pair that is named is one of `hits`,
/// and every one of these that crosses is named by a segment. How parts are joined is not judged.
PartsReview review_intersection(const MeshReferee& referee, const std::vector<TrianglePair>& hits,
                                const CaseIntersection& intersection);

/// Reviews the corners of the intersection of two triangles: each must be on both, and no corner of
/// the true one outside of the polygon that they make. Their order is not judged.
PartsReview review_corners(const Triangle& triangle_a, const Triangle& triangle_b,
                           const std::vector<Eigen::Vector3d>& corners);

}  // namespace graze::compare
