// SPDX-License-Identifier: Apache-2.0
#include "host/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

#include "base/clock.hpp"

extern char** environ;

namespace swage::host {

namespace {

constexpr std::size_t kMaxText = std::size_t{8} << 20;

struct Pipe {
  int read = -1, write = -1;
  Pipe() {
    std::array<int, 2> fd{-1, -1};
    // close-on-exec: a child that outlives its own child must not hold the other's pipe open
    if (pipe2(fd.data(), O_CLOEXEC) == 0) {
      read = fd[0];
      write = fd[1];
    }
  }
  ~Pipe() {
    close_read();
    close_write();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_read() { close(read, read); }
  void close_write() { close(write, write); }

 private:
  static void close(int fd, int& slot) {
    if (fd >= 0) ::close(fd);
    slot = -1;
  }
};

// one read; false at the end of the stream
bool drain(Pipe& pipe, std::string& text) {
  std::array<char, 4096> buffer;
  const ssize_t n = ::read(pipe.read, buffer.data(), buffer.size());
  if (n < 0 && errno == EINTR) return true;
  if (n <= 0) {
    pipe.close_read();
    return false;
  }
  if (text.size() < kMaxText) text.append(buffer.data(), static_cast<std::size_t>(n));
  return true;
}

// Limits the processor time of a child; see child.hpp.
class Patience {
 public:
  Patience(pid_t pid, double limit_s)
      : limit_(static_cast<int64_t>(limit_s * 1e9)), begin_(base::wall_ns()), progress_(begin_) {
    known_ = clock_getcpuclockid(pid, &clock_) == 0;
  }
  int64_t begin() const { return begin_; }
  bool over() {
    const int64_t now = base::wall_ns();
    timespec t{};
    const bool read = known_ && clock_gettime(clock_, &t) == 0;
    const int64_t cpu = read ? t.tv_sec * 1'000'000'000 + t.tv_nsec : cpu_;
    if (cpu != cpu_) progress_ = now;
    cpu_ = cpu;
    return cpu_ >= limit_ || now - progress_ >= limit_ || now - begin_ >= 10 * limit_;
  }

 private:
  const int64_t limit_, begin_;  // ns
  int64_t progress_, cpu_ = 0;   // ns
  clockid_t clock_{};
  bool known_ = false;
};

// polls both streams once, for at most `wait_ms`; false when there was nothing to read
bool listen(Pipe& out, Pipe& err, int wait_ms, ChildResult& result) {
  // poll ignores negative descriptors
  std::array<pollfd, 2> watch{pollfd{out.read, POLLIN, 0}, pollfd{err.read, POLLIN, 0}};
  if (poll(watch.data(), watch.size(), wait_ms) <= 0) return false;
  if (watch[0].revents != 0) drain(out, result.out);
  if (watch[1].revents != 0) drain(err, result.err);
  return true;
}

constexpr int kLook_ms = 20;                  // ms between two checks of a child
constexpr int64_t kFarewell = 2'000'000'000;  // ns for a child to report its call and to end

// reads both streams until they end or the time is over, then collects the child
void collect(pid_t pid, Pipe& out, Pipe& err, double limit_s, ChildResult& result) {
  Patience patience(pid, limit_s);
  int status = 0;
  pid_t ended = 0;
  int64_t last = 0;  // ns, time until which a child that was told to end may stay
  while (ended == 0) {
    // a child may close its streams and continue
    const bool talks = out.read >= 0 || err.read >= 0;
    if (talks)
      listen(out, err, kLook_ms, result);
    else
      usleep(500);
    if (!talks || last != 0) ended = waitpid(pid, &status, WNOHANG);
    if (ended != 0) break;
    if (last == 0 && patience.over()) {
      result.timed_out = true;
      kill(pid, SIGALRM);
      last = base::wall_ns() + kFarewell;
    } else if (last != 0 && base::wall_ns() >= last) {
      kill(pid, SIGKILL);
      ended = waitpid(pid, &status, 0);
    }
  }
  while (result.timed_out && listen(out, err, 0, result)) {
  }
  result.seconds = 1e-9 * static_cast<double>(base::wall_ns() - patience.begin());
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
}

}  // namespace

ChildResult run_program(const std::vector<std::string>& argv, double limit_s) {
  ChildResult result;
  Pipe out, err;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out.write, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.write, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& a : argv) arguments.push_back(const_cast<char*>(a.c_str()));
  arguments.push_back(nullptr);
  pid_t pid = -1;
  const int failure = posix_spawn(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) {
    result.started = false;
    return result;
  }
  out.close_write();
  err.close_write();
  collect(pid, out, err, limit_s, result);
  return result;
}

ChildResult run_forked(const std::function<std::string()>& work, double limit_s) {
  ChildResult result;
  Pipe out, err;
  // else a plugin that calls exit() in the child would write our buffered output a second time
  std::fflush(nullptr);
  const pid_t pid = fork();
  if (pid < 0) {
    result.started = false;
    return result;
  }
  if (pid == 0) {
    dup2(err.write, STDERR_FILENO);
    const std::string text = work();
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t n = write(out.write, text.data() + done, text.size() - done);
      if (n <= 0) _exit(3);
      done += static_cast<std::size_t>(n);
    }
    _exit(0);
  }
  out.close_write();
  err.close_write();
  collect(pid, out, err, limit_s, result);
  return result;
}

std::string signal_text(int signal) {
  const char* name = strsignal(signal);
  return "signal " + std::to_string(signal) + (name != nullptr ? " (" + std::string(name) + ")" : "");
}

}  // namespace swage::host
