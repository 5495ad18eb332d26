#include "tests/benchmark/error/baselines/add_baselines.h"

#include <type_traits>

#include "tests/benchmark/error/baselines/akenine_moeller.h"
#include "tests/benchmark/error/baselines/guigue_devillers.h"
#include "tests/benchmark/error/baselines/moeller.h"
#include "tests/benchmark/error/baselines/path_tests.h"
#include "tests/benchmark/error/baselines/segment_distance.h"
#include "tests/benchmark/error/baselines/sphere_tests.h"
#include "tests/benchmark/error/baselines/volume_tests.h"

namespace graze::benchmark {
namespace {

constexpr double kEpsilons[] = {1e-15, 1e-12, 1e-9, 1e-6, 1e-3};

template <typename Real>
struct PlainPair {
  PlainTriangle<Real> a;
  PlainTriangle<Real> b;
};

template <typename Real>
struct PlainTriangleAndBox {
  PlainTriangle<Real> triangle;
  PlainBox<Real> box;
};

template <typename Real>
const char* precision_of() {
  return std::is_same_v<Real, float> ? "float" : "double";
}

/// The method without EPSILON and with each; `test_with(snap)` makes the test.
template <typename Real, typename Element, typename Convert, typename TestWith>
void add_family(Contestants<Element>& contestants, const char* name, Convert convert,
                TestWith test_with) {
  const Label plain{name, Origin::Baseline, precision_of<Real>(), std::nullopt};
  add(contestants, plain, convert, test_with(NoSnap{}));
  for (const double epsilon : kEpsilons) {
    Label snapped = plain;
    snapped.epsilon = epsilon;
    add(contestants, snapped, convert, test_with(Snap<Real>{static_cast<Real>(epsilon)}));
  }
}

template <typename Real>
struct PlainSphereAndBox {
  PlainSphere<Real> sphere;
  PlainBox<Real> box;
};

template <typename Real>
struct PlainSpherePair {
  PlainSphere<Real> a;
  PlainSphere<Real> b;
};

template <typename Real>
void add_spheres(Field& field) {
  using Both = PlainSphereAndBox<Real>;
  const auto to_both = [](const SphereAndBox& pair) {
    return Both{to_plain<Real>(pair.sphere), to_plain<Real>(pair.box)};
  };
  const auto label = [](const char* name) {
    return Label{name, Origin::Baseline, precision_of<Real>(), std::nullopt};
  };
  add(field.sphere_boxes, label("Arvo"), to_both,
      [](const Both& pair) { return arvo(pair.sphere, pair.box); });
  add(field.sphere_boxes, label("quick rejections"), to_both,
      [](const Both& pair) { return quick_rejections(pair.sphere, pair.box); });
  add(field.sphere_boxes, label("branch-free"), to_both,
      [](const Both& pair) { return branch_free(pair.sphere, pair.box); });
  add(
      field.sphere_pairs, label("plain"),
      [](const SpherePair& pair) {
        return PlainSpherePair<Real>{to_plain<Real>(pair.a), to_plain<Real>(pair.b)};
      },
      [](const PlainSpherePair<Real>& pair) { return plain_spheres(pair.a, pair.b); });
}

template <typename Real>
struct PlainObbPair {
  PlainObb<Real> a;
  PlainObb<Real> b;
};

template <typename Real>
struct PlainKDopPair {
  PlainKDop<Real> a;
  PlainKDop<Real> b;
};

double epsilon_of(NoSnap) {
  return 0;
}
template <typename Number>
Number epsilon_of(Snap<Number> snap) {
  return snap.epsilon;
}

template <typename Real>
void add_volumes(Field& field) {
  using Boxes = PlainObbPair<Real>;
  const auto to_boxes = [](const ObbPair& pair) {
    return Boxes{to_plain<Real>(pair.a), to_plain<Real>(pair.b)};
  };
  add_family<Real>(field.obb_pairs, "15 axes", to_boxes, [](auto snap) {
    return [epsilon = static_cast<Real>(epsilon_of(snap))](const Boxes& pair) {
      return fifteen_axes(pair.a, pair.b, epsilon);
    };
  });
  add(
      field.kdop_pairs, {"plain", Origin::Baseline, precision_of<Real>(), std::nullopt},
      [](const KDopPair& pair) {
        return PlainKDopPair<Real>{plain_kdop<Real>(pair.a), plain_kdop<Real>(pair.b)};
      },
      [](const PlainKDopPair<Real>& pair) { return plain_kdops(pair.a, pair.b); });
}

template <typename Real>
PlainPaths<Real> plain_paths(const MotionQuery& query) {
  const PointPath paths[4] = {query.edge_a.a, query.edge_a.b, query.edge_b.a, query.edge_b.b};
  PlainPaths<Real> plain;
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      plain.start[i][k] = static_cast<Real>(paths[i].start.data()[k]);
      plain.end[i][k] = static_cast<Real>(paths[i].end.data()[k]);
    }
  }
  return plain;
}

template <typename Real>
void add_cubics(Field& field) {
  const auto to_paths = [](const MotionQuery& query) { return plain_paths<Real>(query); };
  add_family<Real>(field.moving_points, "cubic", to_paths, [](auto snap) {
    return [epsilon = static_cast<Real>(epsilon_of(snap))](const PlainPaths<Real>& paths) {
      return cubic_point(paths, epsilon);
    };
  });
  add_family<Real>(field.moving_edges, "cubic", to_paths, [](auto snap) {
    return [epsilon = static_cast<Real>(epsilon_of(snap))](const PlainPaths<Real>& paths) {
      return cubic_edges(paths, epsilon);
    };
  });
}

void add_inclusion(Field& field) {
  const Label label{"inclusion to 1e-6", Origin::Baseline, "double", std::nullopt};
  const auto to_paths = [](const MotionQuery& query) { return plain_paths<double>(query); };
  add(field.moving_points, label, to_paths, inclusion_point);
  add(field.moving_edges, label, to_paths, inclusion_edges);
}

template <typename Real>
void add_in_precision(Field& field) {
  const auto to_pair = [](const TrianglePair& pair) {
    return PlainPair<Real>{to_plain<Real>(pair.a), to_plain<Real>(pair.b)};
  };
  add_family<Real>(field.triangle_pairs, "Guigue-Devillers", to_pair, [](auto snap) {
    return [snap](const PlainPair<Real>& pair) {
      return guigue_devillers(corners_of(pair.a), corners_of(pair.b), snap);
    };
  });
  add_family<Real>(field.triangle_pairs, "Möller 1997", to_pair, [](auto snap) {
    return [snap](const PlainPair<Real>& pair) {
      return moeller(corners_of(pair.a), corners_of(pair.b), snap);
    };
  });
  add(field.distances, {"edges and vertices", Origin::Baseline, precision_of<Real>(), std::nullopt},
      to_pair, [](const PlainPair<Real>& pair) {
        return static_cast<double>(segment_distance(corners_of(pair.a), corners_of(pair.b)));
      });
  const auto to_box = [](const TriangleAndBox& pair) {
    return PlainTriangleAndBox<Real>{to_plain<Real>(pair.triangle), to_plain<Real>(pair.box)};
  };
  add_family<Real>(field.triangle_boxes, "Akenine-Möller", to_box, [](auto snap) {
    return [snap](const PlainTriangleAndBox<Real>& pair) {
      return akenine_moeller(corners_of(pair.triangle), pair.box.min, pair.box.max, snap);
    };
  });
}

}  // namespace

void add_baselines(Field& field) {
  add_in_precision<double>(field);
  add_in_precision<float>(field);
  add_spheres<double>(field);
  add_spheres<float>(field);
  add_volumes<double>(field);
  add_volumes<float>(field);
  add_cubics<double>(field);
  add_cubics<float>(field);
  add_inclusion(field);
}

}  // namespace graze::benchmark
