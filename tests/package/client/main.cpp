// Prints what graze answers to a fixed set of queries, in one line, to be compared between builds.

#include <cinttypes>
#include <cstdio>

#include "queries.h"

namespace {

void print(const char* name, const client::Answers& answers) {
  std::printf("%s %" PRIu64 "/%" PRIu64 " %016" PRIx64 "  ", name, answers.hits, answers.queries,
              answers.digest);
}

}  // namespace

int main() {
  print("placed", client::place_points());
  print("triangles", client::test_triangles());
  print("meshes", client::query_meshes());
  print("denormal", client::query_denormal());
  print("refused", client::offer_bad_values());
  std::printf("\n");
}
