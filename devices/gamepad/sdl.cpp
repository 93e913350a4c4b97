// SPDX-License-Identifier: Apache-2.0
#include "sdl.hpp"

#include <dlfcn.h>

#include <limits>

#include "sentences.hpp"

namespace swage::gamepad {

namespace {

constexpr uint32_t kInitGameController = 0x2000;  // SDL_INIT_GAMECONTROLLER
constexpr const char* kLibrary = "libSDL2-2.0.so.0";

template <class Function>
bool find(void* library, const char* name, Function& out, std::string& why) {
  out = reinterpret_cast<Function>(dlsym(library, name));
  if (out == nullptr) why = say::kLacks(kLibrary, name);
  return out != nullptr;
}

bool find_all(void* library, Sdl& s, std::string& why) {
  return find(library, "SDL_InitSubSystem", s.InitSubSystem, why) && find(library, "SDL_SetHint", s.SetHint, why) &&
         find(library, "SDL_GetError", s.GetError, why) && find(library, "SDL_NumJoysticks", s.NumJoysticks, why) &&
         find(library, "SDL_IsGameController", s.IsGameController, why) &&
         find(library, "SDL_GameControllerOpen", s.GameControllerOpen, why) &&
         find(library, "SDL_GameControllerClose", s.GameControllerClose, why) &&
         find(library, "SDL_GameControllerGetAttached", s.GameControllerGetAttached, why) &&
         find(library, "SDL_GameControllerGetAxis", s.GameControllerGetAxis, why) &&
         find(library, "SDL_GameControllerGetButton", s.GameControllerGetButton, why) &&
         find(library, "SDL_GameControllerName", s.GameControllerName, why) &&
         find(library, "SDL_GameControllerNameForIndex", s.GameControllerNameForIndex, why) &&
         find(library, "SDL_GameControllerEventState", s.GameControllerEventState, why) &&
         find(library, "SDL_GameControllerUpdate", s.GameControllerUpdate, why) &&
         find(library, "SDL_GameControllerGetJoystick", s.GameControllerGetJoystick, why) &&
         find(library, "SDL_JoystickCurrentPowerLevel", s.JoystickCurrentPowerLevel, why);
}

}  // namespace

double battery_of(int level) {
  constexpr double kShare[] = {0.05, 0.2, 0.7, 1};  // EMPTY, LOW, MEDIUM, FULL
  return level >= 0 && level < 4 ? kShare[level] : std::numeric_limits<double>::quiet_NaN();
}

const Sdl* load_sdl(std::string& why) {
  static Sdl sdl{};
  static bool ready = false;
  if (ready) return &sdl;
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    why = say::kNoLibrary(kLibrary);
    return nullptr;
  }
  if (!find_all(library, sdl, why)) return nullptr;
  // events also without an SDL window in front; Ctrl-C stays the program's; no event queue, as nobody would empty it
  sdl.SetHint("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1");
  sdl.SetHint("SDL_NO_SIGNAL_HANDLERS", "1");
  if (sdl.InitSubSystem(kInitGameController) != 0) {
    why = say::kNotStarted(sdl.GetError());
    return nullptr;
  }
  sdl.GameControllerEventState(0);
  ready = true;
  return &sdl;
}

}  // namespace swage::gamepad
