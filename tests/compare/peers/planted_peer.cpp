// graze_planted_peer ENGINE FAULT: an engine over the pipe that does what none should. It answers
// "any" alone, and reads of a request no more than its number.

#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <string>
#include <thread>

namespace {

void say(const std::string& line) {
  std::fputs((line + "\n").c_str(), stdout);
  std::fflush(stdout);
}

[[noreturn]] void hang() {
  while (true)
    pause();
}

[[noreturn]] void crash() {
  std::signal(SIGSEGV, SIG_DFL);
  std::raise(SIGSEGV);
  _exit(1);
}

void sleep_ms(int count) {
  std::this_thread::sleep_for(std::chrono::milliseconds(count));
}

std::string number_of(const std::string& request) {
  const std::size_t at = request.find("\"id\":") + 5;
  return request.substr(at, request.find(',', at) - at);
}

std::string answer_to(const std::string& request, const std::string& answer) {
  return "{\"id\":" + number_of(request) + ",\"answer\":" + answer + "}";
}

class PlantedPeer {
 public:
  explicit PlantedPeer(std::string fault) : fault_(std::move(fault)) {}

  void greet(const std::string& engine) const {
    if (fault_ == "dies at once") crash();
    if (fault_ == "says nothing") hang();
    const std::string version = fault_ == "later protocol" ? "2" : "1";
    const std::string name = fault_ == "another engine" ? "somebody" : engine;
    say("{\"graze_peer\":" + version + ",\"engine\":\"" + name + "\",\"version\":\"planted\"}");
  }

  void load(const std::string& request) {
    if (fault_ == "dies loading") crash();
    if (fault_ == "hangs loading") hang();
    if (fault_ == "loads slowly") sleep_ms(1500);
    const std::string without = "dies loading without ";
    if (fault_.rfind(without, 0) == 0 && access(fault_.c_str() + without.size(), F_OK) != 0)
      crash();
    if (fault_ == "refuses") return say(reply(request, "\"unsupported\":\"too hard\""));
    say(reply(request, "\"loaded\":true"));
  }

  void answer(const std::string& request) {
    ++questions_;
    if (fault_ == "dies") crash();
    if (fault_ == "hangs") hang();
    if (fault_ == "answers slowly") sleep_ms(30);
    if (fault_ == "ends") end_with(3);
    if (fault_ == "closes") close_and_hang();
    if (fault_ == "garbage") return say("the answer is no");
    if (fault_ == "no number") return say(answer_to(request, "{\"distance\":NaN}"));
    if (fault_ == "null") return say(answer_to(request, "{\"distance\":null}"));
    if (fault_ == "another part") return say(answer_to(request, "{\"pairs\":[]}"));
    if (fault_ == "another number") return say("{\"id\":77,\"answer\":{\"says\":false}}");
    if (fault_ == "no end") write_without_end();
    if (fault_ == "error") return say(reply(request, "\"error\":\"out of its depth\""));
    if (fault_ == "unsupported") return say(reply(request, "\"unsupported\":\"\""));
    if (fault_ == "noise") make_noise();
    // Right first and wrong later, but for one that is always wrong.
    const bool is_wrong = fault_ == "wrong" || (fault_ == "forgets" && questions_ > 1);
    say(answer_to(request, is_wrong ? "{\"says\":true}" : "{\"says\":false}"));
    if (fault_ == "answers twice") say(answer_to(request, "{\"says\":true}"));
  }

 private:
  static std::string reply(const std::string& request, const std::string& member) {
    return "{\"id\":" + number_of(request) + "," + member + "}";
  }
  [[noreturn]] static void end_with(int code) {
    std::fputs("first\nout of paint\n", stderr);
    std::fflush(stderr);
    _exit(code);
  }
  [[noreturn]] static void close_and_hang() {
    close(STDOUT_FILENO);
    hang();
  }
  [[noreturn]] static void write_without_end() {
    const std::string much(65536, '[');
    while (std::fputs(much.c_str(), stdout) >= 0) {
    }
    _exit(1);
  }
  static void make_noise() {
    for (int i = 0; i < 20000; ++i)
      std::fputs("what a fine triangle this is, and what a fine one that is\n", stderr);
  }

  std::string fault_;
  int questions_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  PlantedPeer peer(argv[2]);
  peer.greet(argv[1]);
  for (std::string request; std::getline(std::cin, request);) {
    if (request.find("\"load\"") != std::string::npos) {
      peer.load(request);
    } else {
      peer.answer(request);
    }
  }
}
