// SPDX-License-Identifier: Apache-2.0
//
// swage doctor: checks what this machine offers, with a remedy for each shortcoming.
#include <dlfcn.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "host/catalogue.hpp"
#include "host/child.hpp"
#include "host/nearest.hpp"
#include "record/address.hpp"
#include "record/store.hpp"
#include "tools/doctor_devices.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/verbs.hpp"

namespace swage::tools {
namespace {

namespace fs = std::filesystem;

enum class State { kGood, kPoor, kBad };  // kPoor: Swage works, but not at its best

struct MachineFinding {
  std::string name;
  State state = State::kGood;
  std::string text, remedy;
  std::string command = {};  // command to type, if one command is the remedy
};

// tested in a thread of its own, so that the scheduling of this thread does not change
MachineFinding scheduling() {
  int refused = 0;
  std::thread([&refused] {
    const sched_param wanted{70};
    refused = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
  }).join();
  if (refused == 0) return {"scheduling", State::kGood, say::kMayBeRealTime(), ""};
  return {"scheduling", State::kPoor,
          say::kNotRealTime(std::strerror(refused)), say::kPermitRealTime()};
}

MachineFinding memory() {
  // the program with its plugins and rings needs about 200 MB
  constexpr rlim_t kNeeded = rlim_t{256} << 20;
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  const bool root = geteuid() == 0;
  if (root || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= kNeeded)
    return {"memory", State::kGood, say::kMayBeLocked(), ""};
  return {
      "memory", State::kPoor,
      say::kLittleLocked(limit.rlim_cur >> 10), say::kPermitLocking()};
}

MachineFinding processors() {
  const unsigned n = std::thread::hardware_concurrency();
  if (n >= 2) return {"processors", State::kGood, format("%u", n), ""};
  return {"processors", State::kPoor, say::kOneProcessor(),
          say::kMoreProcessors()};
}

// "vendor, version" of EGL, "" when there is none. EGL is loaded at run time: the program must start without it
std::string gl_text() {
  constexpr int kVendor = 0x3053, kVersion = 0x3054;  // eglQueryString
  void* egl = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (egl == nullptr) return "";
  const auto get_display = reinterpret_cast<void* (*)(void*)>(dlsym(egl, "eglGetDisplay"));
  const auto initialize = reinterpret_cast<unsigned (*)(void*, int*, int*)>(dlsym(egl, "eglInitialize"));
  const auto query = reinterpret_cast<const char* (*)(void*, int)>(dlsym(egl, "eglQueryString"));
  if (get_display == nullptr || initialize == nullptr || query == nullptr) return "";
  void* display = get_display(nullptr);
  int major = 0, minor = 0;
  if (display == nullptr || initialize(display, &major, &minor) == 0) return "";
  return std::string(query(display, kVendor)) + ", EGL " + query(display, kVersion);
}

MachineFinding graphics() {
  if (!has_display())
    return {"graphics", State::kPoor, say::kWithoutWindow(), say::kStartDesktop()};
  // in a child process, because a graphics driver may crash
  const host::ChildResult child = host::run_forked(gl_text, 10);
  if (child.ok() && !child.out.empty()) return {"graphics", State::kGood, child.out, ""};
  return {
      "graphics", State::kPoor,
      child.ok() ? say::kNoOpenGl() : say::kBadOpenGl(),
      say::kInstallOpenGl()};
}

MachineFinding console() {
  if (!beside("swage-console").empty()) return {"window", State::kGood, say::kHasConsole(), ""};
  return {"window", State::kPoor, say::kLacksConsole(),
          say::kBuildConsole()};
}

std::vector<MachineFinding> plugins(const DoctorOptions& o) {
  host::Catalogue::Options options;
  options.plugin_dirs = o.plugin_dirs;
  const host::Catalogue catalogue(options);
  std::vector<std::string> where;
  for (const auto& s : catalogue.searched())
    where.push_back(s.dir + (s.exists ? format(" (%u)", s.plugins) : " (absent)"));
  std::vector<MachineFinding> out;
  const auto found = static_cast<unsigned>(catalogue.plugins().size());
  out.push_back(
      {"plugins", found > 0 ? State::kGood : State::kBad, format("%u found in ", found) + host::join(where),
       found > 0 ? ""
                 : "Install Swage's plugins, or name their folder with --plugin-dir or SWAGE_PLUGIN_PATH."});
  for (const auto& r : catalogue.refused())
    out.push_back({"plugin " + r.id, State::kPoor, say::kRefused(r.path, r.reason), say::kRebuild()});
  for (const auto& s : catalogue.shadowed())
    out.push_back({"plugin " + s.id, State::kPoor, say::kHidden(s.path, s.version, s.by), say::kTakeOneOut()});
  for (const DeviceState& d : ask_devices(catalogue))
    out.push_back({"device " + d.id, d.ready ? State::kGood : State::kPoor, d.text, d.remedy, d.command});
  return out;
}

// the nearest parent folder that exists
fs::path existing(fs::path path) {
  std::error_code ignored;
  while (!path.empty() && path.has_relative_path() && !fs::exists(path, ignored)) path = path.parent_path();
  return path.empty() ? "." : path;
}

MachineFinding store(const std::string& where) {
  std::error_code ignored;
  const bool server = record::is_postgres(where);
  const std::string remedy = server ? say::kCheckServer() : say::kOtherPlace();
  if (const std::string no = record::address_problem(where); !no.empty())
    return {"store", State::kBad, no, remedy};
  if (!server && !fs::exists(where, ignored)) {
    const fs::path folder = existing(fs::absolute(where, ignored));
    if (fs::is_directory(folder, ignored) && access(folder.c_str(), W_OK) == 0)
      return {"store", State::kGood, say::kWillBeMade(where), ""};
    return {"store", State::kBad, say::kNotYours(where, folder.string()),
            remedy};
  }
  std::string error;
  const auto opened = record::Store::open_as_allowed(where, error);
  if (!opened) return {"store", State::kBad, error, remedy};
  const std::string damage = opened->damage();
  const std::size_t attempts = opened->attempts("").size();
  const std::string trouble = !damage.empty() ? damage : opened->trouble();
  if (!trouble.empty())
    return {"store", State::kBad, trouble,
            server ? say::kRestoreServer()
                   : say::kSalvage(where)};
  const std::string text = say::kAttemptsIn(attempts, record::shown(where));
  if (opened->read_only())
    return {"store", State::kPoor, say::kReadOnly(text), remedy};
  return {"store", State::kGood, text, ""};
}

MachineFinding disk(const std::string& where) {
  // an hour of lessons is 250 MB; below 1 GB a course would not fit
  constexpr uint64_t kEnough = uint64_t{1} << 30;
  std::error_code ignored;
  struct statvfs facts {};
  if (record::is_postgres(where)) return {"disk", State::kGood, say::kOnServer(), ""};
  const fs::path folder = existing(fs::absolute(where, ignored));
  if (statvfs(folder.c_str(), &facts) != 0)
    return {"disk", State::kBad, say::kNotAsked(folder.string()), ""};
  const uint64_t free = uint64_t{facts.f_bavail} * facts.f_frsize;
  const std::string text = say::kFree(format("%.1f", 1e-9 * static_cast<double>(free)));
  if (free >= kEnough) return {"disk", State::kGood, text, ""};
  return {"disk", State::kPoor, text,
          say::kMakeRoom(folder.string())};
}

const char* text(State state) {
  return state == State::kGood ? "good" : state == State::kPoor ? "poor" : "bad";
}

}  // namespace

int doctor(const DoctorOptions& o) {
  const std::string where = store_place(o.store);
  std::vector<MachineFinding> findings = {scheduling(), memory(), processors(), graphics(), console()};
  for (MachineFinding& f : plugins(o)) findings.push_back(std::move(f));
  findings.push_back(store(where));
  findings.push_back(disk(where));

  bool bad = false;
  auto list = nlohmann::ordered_json::array();
  for (const MachineFinding& f : findings) {
    bad |= f.state == State::kBad;
    list.push_back({{"name", f.name}, {"state", text(f.state)}, {"text", f.text}, {"remedy", f.remedy}, {"command", f.command}});
    if (o.json) continue;
    std::printf("%-4s  %-12s %s\n", text(f.state), printable(f.name).c_str(), printable(f.text).c_str());
    if (!f.remedy.empty()) std::printf("      %-12s %s\n", "", printable(f.remedy).c_str());
    if (f.remedy.find(f.command) == std::string::npos) std::printf("      %-12s %s\n", "", printable(f.command).c_str());
  }
  if (o.json) print(list);
  return bad ? kProblem : kPassed;
}

}  // namespace swage::tools
