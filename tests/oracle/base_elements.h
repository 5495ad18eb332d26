#pragma once

#include <tests/oracle/sampler.h>
#include <tests/oracle/shapes.h>

namespace graze::oracle {

/// A pair of ordinary size from one of the other families, for families that scale and move it.
TrianglePair base_pair(Sampler& sampler);
TriangleAndBox base_box(Sampler& sampler);

}  // namespace graze::oracle
