// SPDX-License-Identifier: Apache-2.0
//
// A program to be killed, or to be given too little disk:
//   record_child loop <store> <seed>           records at 1 kHz until killed; writes each step number to stdout as 8 bytes
//   record_child limit <store> <bytes>         no file may grow beyond <bytes>; then as below
//   record_child tmpfs <folder> <kilobytes>    a small disk of its own is mounted there; store "a.db"
//   record_child fixture <folder> <file>       300 steps, exported: how tests/attempts/v<schema>.swage came about
//   record_child crowd <store> <seed>          what a console does: an attempt of 1500 steps is recorded while the store is
//                                              listed, opened again and read; prints "kept <id>", or what went wrong
//   record_child list <store> <user>           as a user who may only read; prints the number of attempts, or what went wrong
//   record_child qt <store> -                  an attempt is recorded, the first that Qt hears of; prints whether Qt takes this thread
//                                              for that of the program: to it belongs what Qt destroys at the exit
// limit and tmpfs record 4000 steps of noise and print what the recorder said. Exit 77: not permitted here.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <QThread>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "attempt.hpp"
#include "base/clock.hpp"
#include "base/rng.hpp"

namespace swage::record::test {
namespace {

int loop(const std::string& store, uint64_t seed) {
  AttemptInfo info = make_info(seed);
  info.realtime = true;
  base::Problems problems;
  const auto recorder = Recorder::open(store, info, problems);
  if (!recorder) return 2;
  int64_t deadline = base::wall_ns();
  for (uint64_t step = 0;; ++step) {
    base::sleep_until_ns(deadline += 1'000'000);
    recorder->step(make_step(seed, step));
    if (write(STDOUT_FILENO, &step, sizeof step) != sizeof step) return 3;
  }
}

// incompressible inputs fill a disk soonest: 290 bytes a step
StepRecord noise(uint64_t step) {
  base::Xoshiro256 random(step);
  StepRecord record = make_step(7, step);
  for (swage_sample& sample : record.sample) {
    uint64_t words[sizeof sample / 8];
    for (uint64_t& word : words) word = random();
    std::memcpy(&sample, words, sizeof sample);
  }
  return record;
}

int fill(const std::string& store) {
  base::Problems problems;
  const auto recorder = Recorder::open(store, make_info(), problems);
  if (recorder) {
    for (uint64_t step = 0; step < 4000; ++step) recorder->step(noise(step));
    recorder->finish(make_end());
    for (const base::Problem& p : recorder->problems()) problems.push_back(p);
    std::printf("healthy %d\ndropped %llu\n", recorder->healthy(),
                static_cast<unsigned long long>(recorder->dropped()));
  }
  for (const base::Problem& p : problems) std::printf("%s\n", p.message.c_str());
  return 0;
}

// after the disk has been made larger everything must be there
int look(const std::string& store) {
  std::string error;
  const auto opened = Store::open(store, error);
  const auto attempts = opened ? opened->attempts("") : std::vector<AttemptRow>();
  Recording recording;
  const bool read = attempts.size() == 1 && read_recording(store, attempts[0].id, recording, error);
  if (!read) std::printf("unreadable: %s\n", error.c_str());
  bool exact = read;
  for (std::size_t i = 0; exact && i < recording.step.size(); ++i) {
    const StepRecord wrote = noise(i);
    exact = recording.step[i] == i &&
            std::memcmp(&recording.sample[2 * i], wrote.sample, 2 * sizeof(swage_sample)) == 0;
  }
  if (!read) return 0;
  double gap = 0;
  for (const EventRow& event : opened->events(attempts[0].id)) gap += event.owner == "gap" ? event.value : 0;
  std::printf("gap %.0f\nstate %s\nsteps %zu\nexact %d\n", gap, attempts[0].state.c_str(),
              recording.step.size(), exact);
  return 0;
}

int limit(const std::string& store, rlim_t bytes) {
  signal(SIGXFSZ, SIG_IGN);
  const rlimit small{bytes, RLIM_INFINITY}, large{RLIM_INFINITY, RLIM_INFINITY};
  if (setrlimit(RLIMIT_FSIZE, &small) != 0) return 77;
  const int code = fill(store);
  setrlimit(RLIMIT_FSIZE, &large);
  return code != 0 ? code : look(store);
}

int tmpfs(const std::string& folder, const std::string& kilobytes) {
  if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return 77;
  if (mount("tmpfs", folder.c_str(), "tmpfs", 0, ("size=" + kilobytes + "k").c_str()) != 0) return 77;
  const int code = fill(folder + "/a.db");
  if (mount("tmpfs", folder.c_str(), "tmpfs", MS_REMOUNT, "size=64m") != 0) return 3;
  return code != 0 ? code : look(folder + "/a.db");
}

// "" or what a look at the store met with
std::string look_around(const std::string& where) {
  std::string error;
  const auto store = Store::open(where, error);
  if (!store) return error;
  store->recover();
  const std::vector<AttemptRow> attempts = store->attempts("");
  if (!store->trouble().empty()) return store->trouble();
  Recording recording;
  for (const AttemptRow& a : attempts)
    if (a.state == "complete") return read_recording(where, a.id, recording, error) ? "" : error;
  return "";
}

int crowd(const std::string& where, uint64_t seed) {
  base::Problems problems;
  const auto recorder = Recorder::open(where, make_info(seed), problems);
  const auto complain = [](const base::Problems& list) {
    for (const base::Problem& p : list) std::printf("trouble %s\n", p.message.c_str());
    std::fflush(stdout);
  };
  complain(problems);
  if (!recorder) return 2;
  for (uint64_t step = 0; step < 1500; ++step) {
    recorder->step(make_step(seed, step));
    if (step % 250 != 249) continue;
    const std::string trouble = look_around(where);
    if (!trouble.empty()) complain({{base::Severity::kError, "", trouble}});
    base::sleep_until_ns(base::wall_ns() + 20'000'000);
  }
  recorder->finish(make_end());
  complain(recorder->problems());
  std::printf("kept %s\n", recorder->attempt_id().c_str());
  return 0;
}

int list(const std::string& where, const std::string& user) {
  // root may write everywhere
  if (geteuid() == 0 && setuid(static_cast<uid_t>(std::atoi(user.c_str()))) != 0) return 77;
  std::string error;
  const auto store = Store::open_as_allowed(where, error);
  if (!store) {
    std::printf("refused %s\n", error.c_str());
    return 0;
  }
  const auto attempts = store->attempts("");
  std::printf("attempts %zu\nread_only %d\n%s\n", attempts.size(), store->read_only(), store->trouble().c_str());
  Recording recording;
  if (!attempts.empty() && read_recording(where, attempts[0].id, recording, error))
    std::printf("steps %zu\n", recording.step.size());
  return 0;
}

int qt(const std::string& store) {
  record_attempt(store, 300);
  // QCoreApplicationPrivate::theMainThread, which no public name tells before Qt 6.8
  const void* qts = dlsym(RTLD_DEFAULT, "_ZN23QCoreApplicationPrivate13theMainThreadE");
  if (qts == nullptr) return 77;
  std::printf("%s\n", *static_cast<QThread* const*>(qts) == QThread::currentThread() ? "this" : "another");
  return 0;
}

int fixture(const std::string& folder, const std::string& file) {
  std::string error;
  const std::string id = record_attempt(folder + "/a.db", 300);
  const auto store = Store::open(folder + "/a.db", error);
  return store && store->export_attempt(id, file, error) ? 0 : 2;
}

}  // namespace
}  // namespace swage::record::test

int main(int argc, char** argv) {
  using namespace swage::record::test;
  const std::string verb = argc == 4 ? argv[1] : "";
  if (verb == "loop") return loop(argv[2], std::strtoull(argv[3], nullptr, 10));
  if (verb == "limit") return limit(argv[2], std::strtoull(argv[3], nullptr, 10));
  if (verb == "tmpfs") return tmpfs(argv[2], argv[3]);
  if (verb == "crowd") return crowd(argv[2], std::strtoull(argv[3], nullptr, 10));
  if (verb == "list") return list(argv[2], argv[3]);
  if (verb == "qt") return qt(argv[2]);
  if (verb == "fixture") return fixture(argv[2], argv[3]);
  return 2;
}
