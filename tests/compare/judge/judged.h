#pragma once

#include <graze/engine/compare/judge/judge.h>

#include <Eigen/Core>

namespace graze::compare {

inline const Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

Triangle moved(const Triangle& t, const Eigen::Vector3d& by);

/// A cube from -1 to 1 about a point.
CaseMesh cube_at(double x, double y = 0);

/// The verdict on the answer that the two hit, or that they do not.
Judgement judged(const CaseShape& a, const CaseShape& b, bool says);

}  // namespace graze::compare
