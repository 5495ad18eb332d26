#pragma once

// Makes cases of what the queries of two rigid motions (law 14) answer, from the arguments of the
// query and what it returned.

#include <graze/engine/cases/to_case.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/world/shape_motion.h>

namespace graze {

/// Return the motion of one of the two things of a case: from its pose along its course, or at
/// rest. Throw what RigidMotion throws.
RigidMotion motion_of(const CaseMesh& mesh);
RigidMotion motion_of(const CaseBody& body);

/// Return a mesh or a shape in a motion as one of the two things of a case.
CaseMesh case_mesh(const Mesh& mesh, const RigidMotion& motion);
CaseBody case_body(const Shape& shape, const RigidMotion& motion);

/// Returns the settings of a query of motions, as a case has them, with the default budget.
RigidContactSettings contact_settings(const CaseSettings& settings);

/// Make a case of first_contact() of two meshes or two shapes. Throw InputError for an answer that
/// may hang on a budget which no file holds: one that ended at another than the default budget, or
/// was found within a larger one.
Case to_case(const CaseMesh& a, const CaseMesh& b, const RigidContact& contact,
             const RigidContactSettings& settings = {});
Case to_case(const CaseBody& a, const CaseBody& b, const RigidContact& contact,
             const RigidContactSettings& settings = {});

/// Make a case of is_free() of two meshes or two shapes. Throw InputError for another budget than
/// the default one.
Case to_case_free(const CaseMesh& a, const CaseMesh& b, bool is_free,
                  const RigidContactSettings& settings = {});
Case to_case_free(const CaseBody& a, const CaseBody& b, bool is_free,
                  const RigidContactSettings& settings = {});

/// Returns a result as the answer of a case.
CaseAnswer answer_of(const RigidContact& contact);

}  // namespace graze
