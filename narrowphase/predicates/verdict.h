#pragma once

namespace graze::narrowphase {

/// Lists what a floating-point stage may answer (law 6). An Unsure pair goes to the next stage; the
/// user never sees it.
enum class Verdict {
  No,     ///< surely no: what was asked for is not there
  Yes,    ///< surely yes
  Unsure  ///< the next stage is asked
};

/// Names the stage that gave an answer.
enum class Stage { Triage, Exact };

/// Holds an exact answer and the stage that gave it.
struct Decision {
  bool is_hit;
  Stage stage;
};

}  // namespace graze::narrowphase
