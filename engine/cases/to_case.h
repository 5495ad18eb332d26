#pragma once

// A query and its result as a case: the arguments of the query, then what it returned.
//
//   graze::write_case("odd.json", graze::to_case({bolt}, {nut, pose}, graze::distance({bolt}, {nut,
//   pose})));

#include <graze/engine/cases/case.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/mesh/contacts/mesh_contacts.h>
#include <graze/engine/mesh/contacts/separation.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/self.h>
#include <graze/engine/mesh/volume_query.h>

namespace graze {

/// intersects(): two meshes; a mesh and a volume; triangles; overlaps() of two volumes.
Case to_case(const PlacedMesh& a, const PlacedMesh& b, bool says,
             const QuerySettings& settings = {});
Case to_case(const CaseShape& a, const CaseShape& b, bool says, const QuerySettings& settings = {});

/// find_triangle_pairs() and find_triangles(), complete: throws InputError for a list that a limit
/// has cut, for which pairs it holds is nothing that another engine could be asked.
Case to_case(const PlacedMesh& a, const PlacedMesh& b, const TrianglePairs& pairs,
             const PairSettings& settings = {});
Case to_case(const PlacedMesh& a, const CaseShape& volume, const TriangleList& triangles);

/// distance(), within(), find_contacts(), separating_translation() without a direction.
Case to_case(const PlacedMesh& a, const PlacedMesh& b, const MeshDistance& gap);
Case to_case_within(const PlacedMesh& a, const PlacedMesh& b, double clearance, bool says);
Case to_case(const PlacedMesh& a, const PlacedMesh& b, const MeshContacts& contacts);
Case to_case(const PlacedMesh& a, const PlacedMesh& b, const Separation& separation);

/// contains(), self_intersects(), find_self_pairs() with SelfPairKind::Crossing.
Case to_case_contains(const Mesh& mesh, const Eigen::Vector3d& point, bool is_inside);
Case to_case_self(const Mesh& mesh, bool crosses_itself, const QuerySettings& settings = {});
Case to_case_self(const Mesh& mesh, const TrianglePairs& self_pairs);

/// Results as the answers of cases.
CaseAnswer answer_of(const TrianglePairs& pairs);
CaseAnswer answer_of(const TriangleList& triangles);
CaseAnswer answer_of(const MeshDistance& gap);
CaseAnswer answer_of(const MeshContacts& contacts);
CaseAnswer answer_of(const Separation& separation);

}  // namespace graze
