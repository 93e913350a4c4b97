// SPDX-License-Identifier: Apache-2.0
#include "hd.hpp"

#include <dlfcn.h>

#include <array>
#include <map>

#include "sentences.hpp"

namespace swage::openhaptics {
namespace {

constexpr std::array kNames = {"libHD.so", "libHD.so.3.5", "libHD.so.3.4", "libHD.so.3.0"};

template <class Function>
bool find(void* library, const char* name, Function& out, std::string& why) {
  out = reinterpret_cast<Function>(dlsym(library, name));
  if (out == nullptr) why = say::kLacks(name);
  return out != nullptr;
}

bool find_all(void* l, Hd& h, std::string& why) {
  return find(l, "hdInitDevice", h.InitDevice, why) && find(l, "hdDisableDevice", h.DisableDevice, why) &&
         find(l, "hdMakeCurrentDevice", h.MakeCurrentDevice, why) && find(l, "hdGetCurrentDevice", h.GetCurrentDevice, why) &&
         find(l, "hdBeginFrame", h.BeginFrame, why) && find(l, "hdEndFrame", h.EndFrame, why) && find(l, "hdEnable", h.Enable, why) &&
         find(l, "hdGetDoublev", h.GetDoublev, why) && find(l, "hdSetDoublev", h.SetDoublev, why) &&
         find(l, "hdGetIntegerv", h.GetIntegerv, why) && find(l, "hdGetString", h.GetString, why) && find(l, "hdGetError", h.GetError, why) &&
         find(l, "hdGetErrorString", h.GetErrorString, why) && find(l, "hdCheckCalibration", h.CheckCalibration, why) &&
         find(l, "hdUpdateCalibration", h.UpdateCalibration, why) && find(l, "hdStartScheduler", h.StartScheduler, why) &&
         find(l, "hdStopScheduler", h.StopScheduler, why) && find(l, "hdScheduleAsynchronous", h.ScheduleAsynchronous, why) &&
         find(l, "hdUnschedule", h.Unschedule, why);
}

void* load(const std::string& wanted, std::string& why) {
  if (!wanted.empty()) {
    void* const library = dlopen(wanted.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) why = dlerror();
    return library;
  }
  for (const char* name : kNames) {
    if (void* const library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
    // an error of a library that exists tells more than that of one that does not
    const std::string said = dlerror();
    if (why.empty() || said.find(std::string(name) + ": cannot open") == std::string::npos) why = said;
  }
  return nullptr;
}

}  // namespace

const Hd* load_hd(const std::string& wanted, std::string& why) {
  static std::map<std::string, Hd> ready;
  if (const auto found = ready.find(wanted); found != ready.end()) return &found->second;
  std::string said;
  void* const library = load(wanted, said);
  if (library == nullptr) {
    why = say::kNoLibrary(said);
    return nullptr;
  }
  Hd hd{};
  if (!find_all(library, hd, why)) return nullptr;
  return &(ready[wanted] = hd);
}

}  // namespace swage::openhaptics
