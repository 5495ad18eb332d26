#pragma once

namespace graze::narrowphase {

/// What a floating-point stage may answer (law 6). Unsure goes one stage on, never to the user.
enum class Verdict { Apart, Touching, Unsure };

/// Which stage gave an answer.
enum class Stage { Triage, Exact };

/// An exact answer, and how it was come by.
struct Decision {
  bool is_hit;
  Stage stage;
};

}  // namespace graze::narrowphase
