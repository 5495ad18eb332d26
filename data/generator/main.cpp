// graze_generate --output DIR: writes the bundled meshes and poses.

#include <cstdio>
#include <exception>
#include <string>

#include "data/generator/generate.h"

int main(int argc, char** argv) {
  if (argc != 3 || std::string(argv[1]) != "--output") {
    std::fprintf(stderr, "usage: graze_generate --output DIR\n");
    return 2;
  }
  try {
    graze::generator::generate(argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "graze_generate: %s\n", error.what());
    return 1;
  }
  return 0;
}
