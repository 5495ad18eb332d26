#pragma once

namespace graze::narrowphase {

/// What a floating-point stage may answer (law 6). Unsure goes one stage on, never to the user.
enum class Verdict { Apart, Touching, Unsure };

}  // namespace graze::narrowphase
