#include <graze/bvh/error.h>
#include <graze/engine/compare/peers/process/peer_session.h>
#include <graze/engine/files/source.h>

namespace graze::compare {
namespace {

constexpr std::size_t kLongestMessage = 300;

/// Calls `read` with the line's JSON; what it refuses is the engine's failure.
template <typename Read>
auto read_line(const std::string& line, const std::string& name, const Read& read) {
  try {
    const cases::JsonValue tree = cases::parse_json(line, name);
    return read(cases::JsonCursor(tree, name));
  } catch (const CaseError& error) {
    throw EngineFailure(std::string("what it wrote cannot be read: ") + error.what());
  }
}

}  // namespace

PeerSession::PeerSession(const PeerProgram& program)
    : program_(program), process_(program.command) {
  hello_ = read_line(next_line(""), "its first line",
                     [](const cases::JsonCursor& at) { return read_hello(at); });
  if (!program.name.empty() && hello_.witness.engine != program.name) {
    throw EngineFailure("says that it is " + hello_.witness.engine + ", not " + program.name);
  }
}

std::string PeerSession::next_line(std::string_view request) {
  return process_.exchange(request, program_.timeout, program_.longest_line);
}

bool PeerSession::request(std::string_view member,
                          const std::function<void(const cases::JsonCursor&)>& on_reply) {
  const std::uint64_t id = ++last_id_;
  const std::string line = next_line(request_line(id, member));
  return read_line(line, "its answer", [&](const cases::JsonCursor& at) {
    const cases::JsonCursor there = at.member("id");
    constexpr std::int64_t kMostRequests = std::int64_t{1} << 53;
    if (there.whole(0, kMostRequests) != static_cast<std::int64_t>(id)) {
      there.fail("is not that of the question, which is " + std::to_string(id));
    }
    if (at.has("unsupported")) return false;
    if (at.has("error")) {
      throw EngineFailure(mesh_io::printable(at.member("error").text().substr(0, kLongestMessage)));
    }
    on_reply(at);
    return true;
  });
}

}  // namespace graze::compare
