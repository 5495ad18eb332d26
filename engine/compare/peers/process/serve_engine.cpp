#include <graze/bvh/error.h>
#include <graze/engine/cases/read/read_parts.h>
#include <graze/engine/cases/text/case_words.h>
#include <graze/engine/cases/text/json_text.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/compare/peers/process/protocol.h>
#include <graze/engine/compare/peers/process/serve_engine.h>
#include <graze/engine/files/source.h>

#include <malloc.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <istream>
#include <limits>
#include <string>

namespace graze::compare {
namespace {

using cases::json_string;
using cases::JsonCursor;
using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kMaxIndex = std::numeric_limits<std::int32_t>::max();
constexpr cases::JsonLimits kLimits = {.values = std::size_t{1} << 28};  // for meshes of any size
constexpr std::size_t kLongLine = std::size_t{1} << 16;  // bytes: no question is as long
constexpr int kHasReplied = 42;                          // no code that an engine would end with

/// Thrown if the engine refuses, or knows no such question.
class Unsupported : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

Ask read_question(const JsonCursor& at) {
  for (const auto& [name, ask] : cases::kAsks)
    if (at.text() == name) return ask;
  throw Unsupported("there is no question " + mesh_io::quoted(at.text()));
}

std::string microseconds(Clock::time_point start) {
  return cases::json_plain_number(TimedAnswer::Time(Clock::now() - start).count());
}

void write_all(int descriptor, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count = write(descriptor, text.data() + at, text.size() - at);
    if (count < 0 && errno != EINTR) _exit(1);  // nobody listens any more
    if (count > 0) at += static_cast<std::size_t>(count);
  }
}

class Server {
 public:
  Server(const Engine& engine, int replies) : engine_(engine), replies_(replies) {}

  void greet() const {
    const CaseWitness witness = engine_.name();
    std::string more;
    if (const std::optional<std::vector<Ask>> known = engine_.questions()) {
      more = ",\"questions\":" +
             cases::json_list(*known, ",", [](Ask ask) { return json_string(name_of(ask)); });
    }
    if (engine_.answers_scenes()) more += ",\"scenes\":true";
    if (const std::optional<double> tolerance = engine_.tolerance()) {
      more += ",\"tolerance\":" + cases::json_plain_number(*tolerance);
    }
    write_all(replies_, "{\"graze_peer\":" + std::to_string(kPeerProtocol) +
                            ",\"engine\":" + json_string(witness.engine) + ",\"version\":" +
                            json_string(witness.version) + ",\"alone\":true" + more + "}\n");
  }

  void answer(const std::string& line) {
    const std::string name = "the request";
    std::string id = "0";
    try {
      const cases::JsonValue tree = cases::parse_json(line, name, kLimits);
      const JsonCursor request(tree, name);
      constexpr std::int64_t kMostRequests = std::int64_t{1} << 53;
      id = std::to_string(request.member("id").whole(0, kMostRequests));
      if (request.has("alone") && request.member("alone").boolean()) {
        answer_in_copy(request, id);
      } else {
        write_all(replies_, reply_to(request, id));
      }
    } catch (const CaseError& error) {
      write_all(replies_, reply(id, "\"error\":" + json_string(error.what())));
    }
  }

 private:
  static std::string reply(const std::string& id, const std::string& member) {
    return "{\"id\":" + id + "," + member + "}\n";
  }

  /// Returns the reply. Refusals of the engine's are the library's Errors; what else it throws is
  /// an error of its own.
  std::string reply_to(const JsonCursor& request, const std::string& id) {
    try {
      return reply(id, request.has("load") ? load(request.member("load")) : answer_to(request));
    } catch (const CaseError&) {
      throw;
    } catch (const Error& refusal) {
      return reply(id, "\"unsupported\":" + json_string(refusal.what()));
    } catch (const Unsupported& refusal) {
      return reply(id, "\"unsupported\":" + json_string(refusal.what()));
    } catch (const std::exception& error) {
      return reply(id, "\"error\":" + json_string(std::string("throws ") + error.what()));
    }
  }

  /// Answers in a copy of this process, which ends and leaves the state as it is.
  void answer_in_copy(const JsonCursor& request, const std::string& id) {
    const pid_t copy = fork();
    if (copy == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      std::string text;
      try {
        text = reply_to(request, id);
      } catch (const CaseError& error) {
        text = reply(id, "\"error\":" + json_string(error.what()));
      }
      write_all(replies_, text);
      _exit(kHasReplied);
    }
    int status = 0;
    while (copy > 0 && waitpid(copy, &status, 0) == -1 && errno == EINTR) {
    }
    if (copy > 0 && WIFEXITED(status) && WEXITSTATUS(status) == kHasReplied) return;
    std::string why = "cannot be copied: " + std::string(std::strerror(errno));
    if (copy > 0 && WIFSIGNALED(status)) {
      const char* signal = sigabbrev_np(WTERMSIG(status));
      why = std::string("died of SIG") + (signal != nullptr ? signal : "?");
    } else if (copy > 0) {
      why = "ended with exit code " + std::to_string(WEXITSTATUS(status));
    }
    write_all(replies_, reply(id, "\"error\":" + json_string(why)));
  }

  std::string load(const JsonCursor& at) {
    pair_.reset();
    shapes_.reset();
    if (at.has("shapes")) {
      std::vector<Shape> shapes;
      const JsonCursor list = at.member("shapes");
      for (std::size_t i = 0; i < list.size(); ++i)
        shapes.push_back(read_shape(list.item(i)));
      shapes_ = engine_.load_shapes(shapes);
      shape_count_ = shapes.size();
      if (!shapes_) throw Unsupported("knows meshes alone");
    } else {
      const Mesh a = cases::read_inline_mesh(at.member("a"));
      const JsonCursor b = at.member("b");
      mesh_a_ = a;
      mesh_b_ = b.has("same_as") ? a : cases::read_inline_mesh(b);
      pair_ = engine_.load(*mesh_a_, *mesh_b_);
      if (!pair_) throw Unsupported("knows no meshes");
    }
    return "\"loaded\":true";
  }

  std::string answer_to(const JsonCursor& request) const {
    const Ask ask = read_question(request.member("question"));
    if (request.has("pairs")) return answer_about_shapes(request, ask);
    if (request.has("bodies")) return answer_about_two(request, ask);
    if (!pair_) request.fail("no meshes are loaded");
    Question question{ask, cases::read_settings(request, ask)};
    question.course_a = read_course(request, "motion_a");
    question.course_b = read_course(request, "motion_b");
    const Pose pose_a = cases::read_pose(request.member("pose_a"));
    const Pose pose_b = cases::read_pose(request.member("pose_b"));
    const auto start = Clock::now();
    const std::optional<CaseAnswer> answer = pair_->answer(question, pose_a, pose_b);
    const std::string time = microseconds(start);
    if (!answer) throw Unsupported("knows no such question");
    return "\"answer\":" + to_plain_json(*answer) + ",\"us\":" + time;
  }

  static std::optional<RigidCourse> read_course(const JsonCursor& at, std::string_view key) {
    if (!at.has(key)) return std::nullopt;
    return cases::read_course(at.member(key));
  }

  PlacedShape read_placed_shape(const JsonCursor& at) const {
    const JsonCursor shape = at.member("shape");
    PlacedShape body{shape.index(kMaxIndex), cases::read_pose(at.member("pose"))};
    if (body.shape >= shape_count_) shape.fail("there is no such shape");
    return body;
  }

  std::string answer_about_two(const JsonCursor& request, Ask ask) const {
    if (!shapes_) request.fail("no shapes are loaded");
    if (ask == Ask::Any) request.fail("has no pairs");
    const JsonCursor bodies = request.member("bodies");
    bodies.require_size(2);
    const Question question{ask, cases::read_settings(request, ask),
                            read_course(bodies.item(0), "motion"),
                            read_course(bodies.item(1), "motion")};
    const PlacedShape a = read_placed_shape(bodies.item(0));
    const PlacedShape b = read_placed_shape(bodies.item(1));
    const auto start = Clock::now();
    const std::optional<CaseAnswer> answer = shapes_->answer(question, a, b);
    const std::string time = microseconds(start);
    if (!answer) throw Unsupported("knows no such question about such shapes");
    return "\"answer\":" + to_plain_json(*answer) + ",\"us\":" + time;
  }

  std::string answer_about_shapes(const JsonCursor& request, Ask ask) const {
    if (!shapes_) request.fail("no shapes are loaded");
    if (ask != Ask::Any) throw Unsupported("knows no such question about shapes");
    std::vector<PlacedShape> bodies;
    const JsonCursor body_list = request.member("bodies");
    for (std::size_t i = 0; i < body_list.size(); ++i)
      bodies.push_back(read_placed_shape(body_list.item(i)));
    const auto read_body = [&](const JsonCursor& at) -> std::size_t {
      const std::uint32_t body = at.index(kMaxIndex);
      if (body >= bodies.size()) at.fail("there is no such body");
      return body;
    };
    const JsonCursor pair_list = request.member("pairs");
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < pair_list.size(); ++i) {
      const JsonCursor pair = pair_list.item(i);
      pair.require_size(2);
      pairs.emplace_back(read_body(pair.item(0)), read_body(pair.item(1)));
    }
    const ShapesAnswer all = shapes_->intersect_all(bodies, pairs);
    std::string answers;
    for (const ShapesAnswer::Pair& pair : all.pairs) {
      if (!pair.fault.empty()) return "\"error\":" + json_string(pair.fault);
      answers += answers.empty() ? "" : ",";
      answers += !pair.says ? "null" : *pair.says ? "true" : "false";
    }
    return "\"answers\":[" + answers + "],\"us\":" + cases::json_plain_number(all.time.count());
  }

  const Engine& engine_;
  int replies_;
  std::optional<Mesh> mesh_a_;  ///< an adaptor may refer to them
  std::optional<Mesh> mesh_b_;
  std::size_t shape_count_ = 0;
  std::unique_ptr<LoadedPair> pair_;
  std::unique_ptr<LoadedShapes> shapes_;
};

}  // namespace

void serve_engine(const Engine& engine, std::istream& requests, int replies) {
  Server server(engine, replies);
  server.greet();
  for (std::string line; std::getline(requests, line);) {
    server.answer(line);
    if (line.size() < kLongLine) continue;
    // What was loaded is held by the engine now: its text and the tree of it are given back, so
    // that the copies of this process and those beside it have room.
    line = {};
    malloc_trim(0);
  }
}

}  // namespace graze::compare
