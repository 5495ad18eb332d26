// A user of one floor: links graze::narrowphase and nothing else.

#include <graze/narrowphase/triangle_triangle.h>

int main() {
  const graze::Triangle floor{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
  const graze::Triangle touching{{0.5, 0.5, 0}, {0.5, 0.5, 1}, {1, 0.5, 1}};
  const graze::Triangle apart{{0.5, 0.5, 0x1p-1074}, {0.5, 0.5, 1}, {1, 0.5, 1}};
  return graze::intersects(floor, touching) && !graze::intersects(floor, apart) ? 0 : 1;
}
