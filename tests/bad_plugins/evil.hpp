// SPDX-License-Identifier: Apache-2.0
//
// What the evil plugins share: one library holds many ids, and each id is one fault. Plain C tables without the wrapper, which
// would stop most of them.
#pragma once

#include <dlfcn.h>
#include <swage/abi/plugin.h>

#include <clocale>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

namespace evil {

/// A fault: the last part of the plugin's id, and in one sentence what it does.
struct Fault {
  const char *name, *does;
};

/// Name of the folder that the library with this address was loaded from: that of its bundle, which is the id of the fault.
inline std::string bundle_of(const void* address) {
  Dl_info info{};
  dladdr(address, &info);
  std::string path = info.dli_fname != nullptr ? info.dli_fname : "";
  path.resize(path.rfind('/') == std::string::npos ? 0 : path.rfind('/'));
  return path.substr(path.rfind('/') + 1);
}

inline void sleep_ms(long ms) {
  const timespec t{ms / 1000, ms % 1000 * 1'000'000};
  nanosleep(&t, nullptr);
}

/// Never comes back, without using the processor.
[[noreturn]] inline void block() {
  for (;;) sleep_ms(1000);
}

/// Never comes back, and uses all of a processor.
[[noreturn]] inline void spin() {
  volatile unsigned n = 0;
  for (;;) n = n + 1;
}

[[noreturn]] inline void crash() {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
  abort();
}

[[noreturn]] inline void overflow_stack() {
  struct Deep {
    static int down(volatile char* last) {
      volatile char page[4096];
      page[0] = last[0];
      return last[0] != 0 ? down(page) + page[0] : 0;  // never 0, which no compiler may know
    }
  };
  volatile char first[1] = {1};
  exit(Deep::down(first));
}

/// Rounds upwards from here on.
inline void set_rounding() {
#if defined(__x86_64__)
  unsigned mode;
  asm volatile("stmxcsr %0" : "=m"(mode));
  mode |= 0x4000u;
  asm volatile("ldmxcsr %0" : : "m"(mode));
#endif
}

/// The faults that fit any function: true when `name` ends in one of them, and then it has happened.
inline bool misbehave(const std::string& what) {
  if (what == "crashes") crash();
  if (what == "overflows") overflow_stack();
  if (what == "aborts") abort();
  if (what == "exits") exit(0);
  if (what == "quits") _Exit(0);
  if (what == "loops") spin();
  if (what == "blocks") block();
  if (what == "throws") throw 1;
  if (what == "rounds") set_rounding();
  if (what == "translates" && setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) setlocale(LC_ALL, "C.UTF-8");
  return what == "rounds" || what == "translates";
}

/// "configure_crashes": misbehaves when `function` is "configure".
inline void misbehave_in(const char* function, const std::string& fault) {
  const std::size_t n = std::strlen(function);
  if (fault.compare(0, n, function) == 0 && fault.size() > n && fault[n] == '_') misbehave(fault.substr(n + 1));
}

/// What any function can do wrong: the second half of a fault's name, "forces_throws".
inline constexpr Fault kAnywhere[] = {
    {"throws", "Throws there."},
    {"loops", "Never comes back from there, and uses all of a processor."},
    {"blocks", "Never comes back from there."},
    {"crashes", "Reads nowhere there."},
    {"overflows", "Calls itself there until the stack is full."},
    {"aborts", "Calls abort() there."},
    {"exits", "Ends the program with a good exit code there."},
    {"quits", "Ends the program there without any exit handler."},
    {"rounds", "Changes the rounding mode there."},
    {"translates", "Changes the language of the program there."},
};

/// The descriptors of a library of faults, made once from its list and from functions times kAnywhere.
class Catalogue {
 public:
  Catalogue(int32_t kind, const char* prefix, const std::vector<Fault>& faults, const std::vector<const char*>& functions,
            const char* const* traits)
      : prefix_(prefix) {
    for (const Fault& f : faults) add(kind, f.name, f.does, traits);
    for (const char* function : functions)
      for (const Fault& f : kAnywhere) add(kind, std::string(function) + "_" + f.name, f.does, traits);
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      descriptors_[i].id = ids_[i].c_str();
      descriptors_[i].name = ids_[i].c_str() + prefix_.size();
    }
  }
  uint32_t count() const { return static_cast<uint32_t>(descriptors_.size()); }
  const swage_descriptor* at(uint32_t i) const { return i < count() ? &descriptors_[i] : nullptr; }
  /// The fault that an id stands for; "" for an id of nobody.
  std::string fault(const char* id) const {
    for (const std::string& known : ids_)
      if (known == id) return known.substr(prefix_.size());
    return "";
  }

 private:
  void add(int32_t kind, const std::string& name, const char* does, const char* const* traits) {
    ids_.push_back(prefix_ + name);
    descriptors_.push_back({sizeof(swage_descriptor), kind, nullptr, "1.0.0", nullptr, does, "Swage", "Apache-2.0", traits});
  }

  std::string prefix_;
  std::vector<std::string> ids_;
  std::vector<swage_descriptor> descriptors_;
};

}  // namespace evil
