// libccd, in double: GJK and MPR on support functions, as its users write them. The number of
// iterations, which is without limit by default, ends at 100; all else is its default. MPR heeds
// that limit in its last phase only: see support_limit.h.

#include <ccd/ccd.h>
#include <ccd/vec3.h>

#include "tests/benchmark/error/peers/peers.h"
#include "tests/benchmark/error/peers/support_limit.h"

namespace graze::benchmark {
namespace {

struct CcdTriangle {
  explicit CcdTriangle(const Triangle& t) {
    for (int i = 0; i < 3; ++i) {
      corners[0].v[i] = t.a.data()[i];
      corners[1].v[i] = t.b.data()[i];
      corners[2].v[i] = t.c.data()[i];
    }
  }
  ccd_vec3_t corners[3];
};

struct CcdBox {
  explicit CcdBox(const Aabb& box) {
    for (int i = 0; i < 3; ++i) {
      min.v[i] = box.min.data()[i];
      max.v[i] = box.max.data()[i];
    }
  }
  ccd_vec3_t min;
  ccd_vec3_t max;
};

struct CcdSphere {
  explicit CcdSphere(const Sphere& sphere) : radius(sphere.radius) {
    for (int i = 0; i < 3; ++i)
      centre.v[i] = sphere.centre.data()[i];
  }
  ccd_vec3_t centre;
  double radius;
};

void support(const CcdTriangle& t, const ccd_vec3_t& direction, ccd_vec3_t& point) {
  int farthest = 0;
  double most = ccdVec3Dot(&t.corners[0], &direction);
  for (int i = 1; i < 3; ++i) {
    const double reach = ccdVec3Dot(&t.corners[i], &direction);
    if (reach > most) farthest = i, most = reach;
  }
  point = t.corners[farthest];
}

void support(const CcdBox& box, const ccd_vec3_t& direction, ccd_vec3_t& point) {
  for (int i = 0; i < 3; ++i)
    point.v[i] = direction.v[i] < 0 ? box.min.v[i] : box.max.v[i];
}

void support(const CcdSphere& sphere, const ccd_vec3_t& direction, ccd_vec3_t& point) {
  point = direction;
  ccdVec3Normalize(&point);
  ccdVec3Scale(&point, sphere.radius);
  ccdVec3Add(&point, &sphere.centre);
}

void centre(const CcdTriangle& t, ccd_vec3_t& point) {
  point = t.corners[0];
  ccdVec3Add(&point, &t.corners[1]);
  ccdVec3Add(&point, &t.corners[2]);
  ccdVec3Scale(&point, 1.0 / 3);
}

void centre(const CcdBox& box, ccd_vec3_t& point) {
  point = box.min;
  ccdVec3Add(&point, &box.max);
  ccdVec3Scale(&point, 0.5);
}

void centre(const CcdSphere& sphere, ccd_vec3_t& point) {
  point = sphere.centre;
}

template <typename Shape>
void centre_of(const void* shape, ccd_vec3_t* point) {
  centre(*static_cast<const Shape*>(shape), *point);
}

template <typename Shape>
void support_of(const void* shape, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  SupportLimit::count();
  support(*static_cast<const Shape*>(shape), *direction, *point);
}

template <typename A, typename B>
struct CcdPair {
  A a;
  B b;
};

using Test = int (*)(const void*, const void*, const ccd_t*);

template <typename A, typename B, typename Element, typename Convert>
void add_both(Contestants<Element>& contestants, Convert convert) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support_of<A>;
  ccd.support2 = support_of<B>;
  ccd.center1 = centre_of<A>;
  ccd.center2 = centre_of<B>;
  ccd.max_iterations = 100;
  const auto with = [&](const char* name, Test test) {
    add(contestants, {name, Origin::Peer, "double", std::nullopt}, convert,
        [ccd, test](const CcdPair<A, B>& pair) {
          SupportLimit::begin();
          return test(&pair.a, &pair.b, &ccd) != 0;
        });
  };
  with("libccd GJK", ccdGJKIntersect);
  with("libccd MPR", ccdMPRIntersect);
}

}  // namespace

void add_ccd(Field& field) {
  add_both<CcdTriangle, CcdTriangle>(field.triangle_pairs, [](const TrianglePair& pair) {
    return CcdPair<CcdTriangle, CcdTriangle>{CcdTriangle(pair.a), CcdTriangle(pair.b)};
  });
  add_both<CcdTriangle, CcdBox>(field.triangle_boxes, [](const TriangleAndBox& pair) {
    return CcdPair<CcdTriangle, CcdBox>{CcdTriangle(pair.triangle), CcdBox(pair.box)};
  });
  add_both<CcdSphere, CcdBox>(field.sphere_boxes, [](const SphereAndBox& pair) {
    return CcdPair<CcdSphere, CcdBox>{CcdSphere(pair.sphere), CcdBox(pair.box)};
  });
  add_both<CcdSphere, CcdSphere>(field.sphere_pairs, [](const SpherePair& pair) {
    return CcdPair<CcdSphere, CcdSphere>{CcdSphere(pair.a), CcdSphere(pair.b)};
  });
}

}  // namespace graze::benchmark
