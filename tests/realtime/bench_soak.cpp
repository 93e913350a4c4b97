// SPDX-License-Identifier: Apache-2.0
//
// bench_soak [minutes] [--json]
//
// How punctual is the step, on this machine, beside whatever else runs on it? One real-time thread alternates blocks of 200
// ticks that only sleep, stamp and multiply for some 15 us ("bare") with blocks of 200 whole ticks ("full": device, step, snapshot, record) of the
// basic grasp by the scripted expert, attempt after attempt. The machine's own hiccups meet both alike, so their ratio says
// what the step adds. Passes when
//
//   late(full) <= 1.5 late(bare) + 10 per minute     a tick is late when it wakes more than half a period after its time
//   no allocation, lock, sleep or file access in a full tick
//   p99 of a full tick's processor time < 0.2 ms
//
// The processor time of bare ticks stands beside that of full ones: what its p99 is above its p50 is the machine's doing
// (interrupts, a hypervisor), for the multiplications take the same time each tick.
//
// Where the system refuses real-time priority the first line is told, not judged.
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "attempt.hpp"
#include "base/clock.hpp"
#include "base/histogram.hpp"
#include "host/services.hpp"
#include "rt_calls.hpp"
#include "session/rt_thread.hpp"
#include "test_places.hpp"

namespace swage::realtime {
namespace {

constexpr int64_t kPeriod = 1'000'000;  // ns
constexpr int kBlock = 200;             // ticks
constexpr int kWarmUp = 2000;           // ticks that are not counted: first touches of memory, cold caches
constexpr int kProducts = 12'000;       // of a bare tick, one after the other: as long as a step's median

/// What was seen in ticks of one kind.
struct Seen {
  uint64_t ticks = 0, late = 0;
  uint64_t switches = 0, faults = 0;  // voluntary context switches, page faults
  base::Histogram wake;               // ns
  base::Histogram cpu;                // ns
};

struct Soak {
  session::RtGrant grant;
  Seen bare, full;
  base::Histogram wall;  // ns, of full ticks
  Calls calls;
  uint64_t attempts = 0, passed = 0, overrun = 0;
};

/// Attempts made ready on [main], played on [rt], given back.
struct Exchange {
  std::atomic<Attempt*> ready{nullptr}, done{nullptr};
  std::atomic<bool> over{false};
};

struct Usage {
  uint64_t switches, faults;
};
Usage usage() {
  rusage u{};
  getrusage(RUSAGE_THREAD, &u);
  return {static_cast<uint64_t>(u.ru_nvcsw), static_cast<uint64_t>(u.ru_minflt + u.ru_majflt)};
}

// sleeps to the deadline and stamps; lets go of deadlines that have passed
void wait(int64_t& deadline, Seen* seen) {
  base::sleep_until_ns(deadline);
  const int64_t late = base::wall_ns() - deadline;
  if (seen) {
    ++seen->ticks;
    seen->late += late > kPeriod / 2;
    seen->wake.add(late);
  }
  deadline += kPeriod * (1 + late / kPeriod);
}

// always the same products, so that every difference in time is the machine's
void bare_tick(Seen* seen) {
  const int64_t cpu0 = base::cpu_ns();
  uint64_t product = 1;
  for (int i = 0; i < kProducts; ++i) product = product * 6364136223846793005u + 1442695040888963407u;
  volatile uint64_t kept = product;
  static_cast<void>(kept);
  if (seen) seen->cpu.add(base::cpu_ns() - cpu0);
}

// one whole tick; false when the attempt is over
bool full_tick(Attempt& attempt, Soak& soak, bool count) {
  const Calls calls0 = calls();
  const int64_t wall0 = base::wall_ns(), cpu0 = base::cpu_ns();
  const bool go_on = attempt.tick();
  const int64_t cpu = base::cpu_ns() - cpu0, wall = base::wall_ns() - wall0;
  const Calls c = calls() - calls0;
  if (!count) return go_on;
  soak.full.cpu.add(cpu);
  soak.wall.add(wall);
  soak.overrun += wall > kPeriod;
  soak.calls.heap += c.heap;
  soak.calls.lock += c.lock;
  soak.calls.sleep += c.sleep;
  soak.calls.file += c.file;
  return go_on;
}

void run(Exchange& exchange, Soak& soak, int64_t ticks) {
  soak.grant = session::make_punctual();
  host::set_thread_role(SWAGE_THREAD_RT);
  int64_t deadline = base::wall_ns() + kPeriod;
  Attempt* attempt = nullptr;
  for (int64_t n = -kWarmUp; n < ticks;) {
    const bool counted = n >= 0;
    const Usage bare0 = usage();
    for (int i = 0; i < kBlock; ++i, ++n) {
      wait(deadline, counted ? &soak.bare : nullptr);
      bare_tick(counted ? &soak.bare : nullptr);
    }
    const Usage full0 = usage();
    if (counted) {
      soak.bare.switches += full0.switches - bare0.switches;
      soak.bare.faults += full0.faults - bare0.faults;
    }
    if (!attempt) attempt = exchange.ready.exchange(nullptr);
    if (!attempt) continue;  // the next one is not ready yet
    bool over = false;
    for (int i = 0; i < kBlock; ++i, ++n) {
      wait(deadline, counted ? &soak.full : nullptr);
      if (!over) over = !full_tick(*attempt, soak, counted);
    }
    const Usage full1 = usage();
    if (counted) {
      soak.full.switches += full1.switches - full0.switches;
      soak.full.faults += full1.faults - full0.faults;
    }
    if (!over) continue;
    ++soak.attempts;
    soak.passed += attempt->engine().verdict().outcome == judge::Outcome::kPassed;
    exchange.done.store(attempt);
    attempt = nullptr;
  }
  if (attempt) exchange.done.store(attempt);
  exchange.over.store(true);
}

double us(uint64_t ns) { return 1e-3 * static_cast<double>(ns); }
double share(uint64_t part, uint64_t all) {
  return all ? static_cast<double>(part) / static_cast<double>(all) : 0;
}

struct Line {
  const char* name;
  double measured, bound;
  bool held, judged;
};

void print_text(const Soak& s, const Line* lines, int count, double minutes) {
  std::printf("%s\n%.2f minutes, %llu attempts, %llu passed\n\n", s.grant.sentence.c_str(), minutes,
              static_cast<unsigned long long>(s.attempts), static_cast<unsigned long long>(s.passed));
  std::printf("%-34s %12s %12s\n", "", "bare", "full");
  const auto row = [](const char* name, double bare, double full) {
    std::printf("%-34s %12.3f %12.3f\n", name, bare, full);
  };
  row("ticks", static_cast<double>(s.bare.ticks), static_cast<double>(s.full.ticks));
  row("late ticks", static_cast<double>(s.bare.late), static_cast<double>(s.full.late));
  row("late, share in %", 100 * share(s.bare.late, s.bare.ticks), 100 * share(s.full.late, s.full.ticks));
  row("wake p50, us", us(s.bare.wake.quantile(0.5)), us(s.full.wake.quantile(0.5)));
  row("wake p99, us", us(s.bare.wake.quantile(0.99)), us(s.full.wake.quantile(0.99)));
  row("wake p99.9, us", us(s.bare.wake.quantile(0.999)), us(s.full.wake.quantile(0.999)));
  row("voluntary switches per tick", share(s.bare.switches, s.bare.ticks),
      share(s.full.switches, s.full.ticks));
  row("processor p50, us", us(s.bare.cpu.quantile(0.5)), us(s.full.cpu.quantile(0.5)));
  row("processor p99, us", us(s.bare.cpu.quantile(0.99)), us(s.full.cpu.quantile(0.99)));
  row("processor p99.9, us", us(s.bare.cpu.quantile(0.999)), us(s.full.cpu.quantile(0.999)));
  row("processor, most, us", us(s.bare.cpu.max()), us(s.full.cpu.max()));
  row("page faults", static_cast<double>(s.bare.faults), static_cast<double>(s.full.faults));
  std::printf(
      "\nfull tick, wall time: p50 %.1f us, p99 %.1f us, p99.9 %.1f us, most %.1f us; longer than 1 ms: "
      "%llu\n\n",
      us(s.wall.quantile(0.5)), us(s.wall.quantile(0.99)), us(s.wall.quantile(0.999)), us(s.wall.max()),
      static_cast<unsigned long long>(s.overrun));
  for (int i = 0; i < count; ++i)
    std::printf("%-8s %-46s %12.3f   bound %.3f\n",
                !lines[i].judged ? "told"
                : lines[i].held  ? "held"
                                 : "NOT HELD",
                lines[i].name, lines[i].measured, lines[i].bound);
}

void print_json(const Soak& s, const Line* lines, int count, double minutes) {
  const auto part = [](const Seen& seen) {
    std::printf(
        "{\"ticks\": %llu, \"late\": %llu, \"wake_p50_us\": %.3f, \"wake_p99_us\": %.3f, \"cpu_p50_us\": "
        "%.3f, \"cpu_p99_us\": %.3f, \"cpu_max_us\": %.3f, \"switches\": %llu, \"faults\": %llu}",
        static_cast<unsigned long long>(seen.ticks), static_cast<unsigned long long>(seen.late),
        us(seen.wake.quantile(0.5)), us(seen.wake.quantile(0.99)), us(seen.cpu.quantile(0.5)),
        us(seen.cpu.quantile(0.99)), us(seen.cpu.max()), static_cast<unsigned long long>(seen.switches),
        static_cast<unsigned long long>(seen.faults));
  };
  std::printf("{\"minutes\": %.3f, \"realtime\": %s, \"attempts\": %llu, \"passed\": %llu, \"bare\": ",
              minutes, s.grant.fifo ? "true" : "false", static_cast<unsigned long long>(s.attempts),
              static_cast<unsigned long long>(s.passed));
  part(s.bare);
  std::printf(", \"full\": ");
  part(s.full);
  std::printf(", \"lines\": [");
  for (int i = 0; i < count; ++i)
    std::printf("%s{\"name\": \"%s\", \"measured\": %.6g, \"bound\": %.6g, \"held\": %s, \"judged\": %s}",
                i ? ", " : "", lines[i].name, lines[i].measured, lines[i].bound,
                lines[i].held ? "true" : "false", lines[i].judged ? "true" : "false");
  std::printf("]}\n");
}

// Half of the ticks are bare, half full: rates are per minute of each.
std::array<Line, 4> lines_of(const Soak& soak) {
  const auto late = static_cast<double>(soak.full.late);
  const double full_minutes = static_cast<double>(soak.full.ticks) / 60e3;
  const double rate = share(soak.bare.late, soak.bare.ticks) * static_cast<double>(soak.full.ticks);
  const double late_bound = 1.5 * rate + 10 * full_minutes;
  const double p99 = us(soak.full.cpu.quantile(0.99));
  return {{{"late full ticks, against 1.5 bare + 10 a minute", late, late_bound, late <= late_bound,
            soak.grant.fifo},
           {"calls that may block, in full ticks", static_cast<double>(soak.calls.all()), 0,
            soak.calls.all() == 0, counts()},
           {"p99 of processor time per tick, us", p99, 200, p99 < 200, true},
           {"attempts that did not pass", static_cast<double>(soak.attempts - soak.passed), 0,
            soak.attempts == soak.passed, true}}};
}

int main_of(double minutes, bool json) {
  namespace fs = std::filesystem;
  char name[] = "/tmp/swage-soak-XXXXXX";
  const std::string folder = mkdtemp(name);
  const auto make = [&folder] {
    return new Attempt(SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json", "expert",
                       {SWAGE_BINARY_DIR "/plugins"}, folder + "/attempts.db");
  };
  auto first = std::unique_ptr<Attempt>(make());
  if (!first->ok()) return 2;
  Exchange exchange;
  exchange.ready.store(first.release());
  Soak soak;
  std::thread thread([&] { run(exchange, soak, static_cast<int64_t>(minutes * 60e9) / kPeriod); });
  // this thread prepares the next attempt while one is played, as a session does between two attempts
  while (!exchange.over.load()) {
    delete exchange.done.exchange(nullptr);
    if (!exchange.ready.load()) exchange.ready.store(make());
    usleep(20000);
  }
  thread.join();
  delete exchange.done.exchange(nullptr);
  delete exchange.ready.exchange(nullptr);
  fs::remove_all(folder);

  const auto lines = lines_of(soak);
  json ? print_json(soak, lines.data(), static_cast<int>(lines.size()), minutes)
       : print_text(soak, lines.data(), static_cast<int>(lines.size()), minutes);
  bool good = true;
  for (const Line& l : lines) good = good && (l.held || !l.judged);
  return good ? 0 : 1;
}

}  // namespace
}  // namespace swage::realtime

int main(int argc, char** argv) {
  double minutes = 1;
  bool json = false;
  for (int i = 1; i < argc; ++i) {
    char* end = nullptr;
    const double number = std::strtod(argv[i], &end);
    if (std::strcmp(argv[i], "--json") == 0) {
      json = true;
    } else if (*end == 0 && number > 0 && number < 1e5) {
      minutes = number;
    } else {
      std::fprintf(stderr, "usage: bench_soak [minutes] [--json]\n");
      return 2;
    }
  }
  return swage::realtime::main_of(minutes, json);
}
