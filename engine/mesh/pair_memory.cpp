// A gap that is proved in one pose holds in others. In the frame of tree A, in common units, a
// point b of B lies at C b + T, and C, T are relative_frame()'s; where two placed triangles share a
// point, some points a, b of them have |C b + T - a| <= slack in each component, less than twice
// the slack in length. Boxes and primitives that a walk proves apart with a slack enlarged by some
// margin are so for any C b + T moved by that margin. From C1, T1 to C2, T2 no b of the box m +- h
// moves by more than |dC m + dT| + sum h_j |dC_j|. So a gap less this motion that exceeds twice the
// new slack leaves no two triangles that meet.

#include <graze/bvh/error.h>
#include <graze/engine/mesh/pair_memory.h>
#include <graze/engine/mesh/parity.h>
#include <graze/engine/mesh/query_results.h>
#include <graze/engine/mesh/solid.h>
#include <graze/engine/mesh/wide_query.h>

#include <algorithm>
#include <cmath>

namespace graze {
namespace {

/// For how many steps a proof is made at most, and how many queries at most pass after a vain one
/// before the next.
constexpr double kMostStepsAhead = 32;
constexpr int kLongestPause = 8;

void require_wide(Volume volume) {
  if (volume != Volume::Wide) throw InputError("volume: a PairMemory needs Volume::Wide");
}

}  // namespace

/// One query with a memory.
class MemoryQuery {
 public:
  MemoryQuery(const PlacedMesh& a, const PlacedMesh& b, PairMemory& memory, Touch touch, Work& work)
      : query_(a, b, work), memory_(memory), touch_(touch), work_(work) {
    const bool is_same =
        memory.mesh_a_ && memory.mesh_b_ && *memory.mesh_a_ == a.mesh && *memory.mesh_b_ == b.mesh;
    if (!is_same) {
      memory = PairMemory();
      memory.mesh_a_ = a.mesh;
      memory.mesh_b_ = b.mesh;
    }
    for (int i = 0; i < 3; ++i) {
      std::copy_n(query_.b_in_a.rotation[i], 3, now_.rotation[i]);
      now_.translation[i] = query_.b_in_a.translation[i];
    }
    step_ = memory.has_last_ ? motion_from(memory.last_) : 0;
    memory.last_ = now_;
    memory.has_last_ = true;
  }

  /// Whether nothing meets, as far as boxes of all and the memory know.
  bool are_surely_apart() {
    if (query_.are_far_apart(work_)) return true;
    const bool is_apart = memory_.gap_ - motion_from(memory_.proven_) > 2 * query_.b_in_a.slack;
    memory_.still_apart_ += is_apart;
    return is_apart;
  }

  /// Whether triangles that touched when last asked still do.
  bool does_remembered_pair_touch() {
    if (memory_.gap_ > 0) return false;
    Candidates candidates(touch_, work_);
    const std::size_t count = memory_.pair_count_;
    std::size_t touching = count;
    const auto on_pair = [&](TrianglePair pair) {
      touching = static_cast<std::size_t>(
          std::find(memory_.pairs_.begin(), memory_.pairs_.end(), pair) - memory_.pairs_.begin());
      return bvh::Walk::Stop;
    };
    for (std::size_t i = 0; i < count && touching == count; ++i) {
      const TrianglePair pair = memory_.pairs_[i];
      candidates.add(pair, query_.triangle_a(pair), query_.triangle_b(pair));
      // The first alone: most of the time it is enough.
      if (i == 0 || i + 1 == count) candidates.decide(on_pair);
    }
    if (touching == count) return false;
    std::swap(memory_.pairs_[0], memory_.pairs_[touching]);
    ++memory_.still_touching_;
    return true;
  }

  /// Walks the trees until something meets. If nothing does, remembers how far apart all is.
  bool walk() {
    // After a hit another is likelier than a gap, and the first query knows no motion.
    const bool was_apart = memory_.pair_count_ == 0;
    memory_.pair_count_ = 0;
    memory_.gap_ = 0;
    if (was_apart && step_ > 0 && step_ < 1 && memory_.pause_-- <= 0 && prove_gap()) return false;
    bvh::WidePairWalk walk = query_.walk();
    const bool is_hit = look_for_pairs(walk);
    add_counts(walk.counts(), work_);
    return is_hit;
  }

  void remember(TrianglePair pair) {
    if (memory_.pair_count_ < PairMemory::kMostPairs) memory_.pairs_[memory_.pair_count_++] = pair;
  }

  void forget() {
    memory_.pair_count_ = 0;
    memory_.gap_ = 0;
  }

 private:
  double motion_from(const PairMemory::Placing& before) const {
    const bvh::FloatBox& box = query_.tree_b.box();
    const double unit = query_.b_in_a.units_b;
    double moved[3] = {0, 0, 0};
    double sizes = 0;
    double total = 0;
    for (int j = 0; j < 3; ++j) {
      const double middle = (0.5 * box.min[j] + 0.5 * box.max[j]) * unit;
      const double half = (0.5 * box.max[j] - 0.5 * box.min[j]) * unit;
      double square = 0;
      for (int i = 0; i < 3; ++i) {
        const double turned = now_.rotation[i][j] - before.rotation[i][j];
        moved[i] += turned * middle;
        square += turned * turned;
        sizes += std::abs(turned * middle);
      }
      total += half * std::sqrt(square);
    }
    double square = 0;
    for (int i = 0; i < 3; ++i) {
      const double way = now_.translation[i] - before.translation[i];
      sizes += std::abs(way);
      square += (moved[i] + way) * (moved[i] + way);
    }
    // Rounding of sums of five terms, and squares that underflow.
    return (std::sqrt(square) + total) * (1 + 0x1p-40) + 0x1p-48 * sizes + 0x1p-500;
  }

  /// Decides what waits; whether anything has met.
  bool decide(Candidates& candidates) {
    candidates.decide([&](TrianglePair pair) {
      remember(pair);
      return bvh::Walk::Continue;
    });
    return memory_.pair_count_ > 0;
  }

  bool look_for_pairs(bvh::WidePairWalk& walk) {
    bvh::PlacePair places[bvh::WidePairWalk::kMostAtOnce + Candidates::kCapacity];
    Candidates candidates(touch_, work_);
    while (const std::size_t count = walk.next(places)) {
      for (std::size_t i = 0; i < count; ++i) {
        const TrianglePair pair = query_.pair_at(places[i]);
        candidates.add(pair, query_.triangle_a(pair), query_.triangle_b(pair));
        if (candidates.is_full() && decide(candidates)) return true;
      }
    }
    return decide(candidates);
  }

  /// Whether all is further apart than some steps of the motion, which is then remembered. Ends at
  /// the first primitives for which boxes and planes do not prove it, so that to have tried in vain
  /// costs little; how many steps are tried follows from what was proved before.
  bool prove_gap() {
    const double margin = memory_.steps_ahead_ * step_;
    bvh::RelativeFrame a_in_b = relative_frame(query_.frame_b, query_.frame_a);
    bvh::RelativeFrame b_in_a = query_.b_in_a;
    // A walk triples the slack that it is given.
    b_in_a.slack += margin * (1.01 / 3);
    a_in_b.slack += margin * (1.01 / 3);
    bvh::WidePairWalk walk(query_.tree_a, query_.tree_b, b_in_a, a_in_b);
    bvh::PlacePair places[bvh::WidePairWalk::kMostAtOnce];
    const bool is_proved = walk.next(places) == 0;
    add_counts(walk.counts(), work_);
    if (is_proved) {
      memory_.gap_ = margin;
      memory_.proven_ = now_;
      memory_.steps_ahead_ = std::min(2 * memory_.steps_ahead_, kMostStepsAhead);
      memory_.next_pause_ = 1;
    } else if (memory_.steps_ahead_ > 4) {
      memory_.steps_ahead_ /= 2;
    } else {
      memory_.pause_ = memory_.next_pause_;
      memory_.next_pause_ = std::min(2 * memory_.next_pause_, kLongestPause);
    }
    return is_proved;
  }

  WideQuery query_;
  PairMemory& memory_;
  Touch touch_;
  Work& work_;
  PairMemory::Placing now_;
  double step_ = 0;
};

bool intersects(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b, PairMemory& memory,
                const QuerySettings& settings, Work* work) {
  require_wide(settings.volume);
  narrowphase::check_touch(settings.touch);
  check_interior(settings);
  if (settings.interior == Interior::Solid) {
    check_closed(mesh_a.mesh, "mesh A");
    check_closed(mesh_b.mesh, "mesh B");
  }
  CountedWork counted(work);
  MemoryQuery query(mesh_a, mesh_b, memory, settings.touch, counted.work());
  if (!query.are_surely_apart() && (query.does_remembered_pair_touch() || query.walk()))
    return true;
  return settings.interior == Interior::Solid && is_either_inside(mesh_a, mesh_b, counted.work());
}

TrianglePairs find_triangle_pairs(const PlacedMesh& mesh_a, const PlacedMesh& mesh_b,
                                  PairMemory& memory, const PairSettings& settings, Work* work) {
  require_wide(settings.volume);
  narrowphase::check_touch(settings.touch);
  CountedWork counted(work);
  MemoryQuery query(mesh_a, mesh_b, memory, settings.touch, counted.work());
  if (query.are_surely_apart()) return {};
  if (!query.does_remembered_pair_touch() && !query.walk()) return {};
  TrianglePairs found = find_triangle_pairs(mesh_a, mesh_b, settings, &counted.work());
  query.forget();
  for (const TrianglePair& pair : found.pairs)
    query.remember(pair);
  return found;
}

}  // namespace graze
