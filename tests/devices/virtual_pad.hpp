// SPDX-License-Identifier: Apache-2.0
//
// A game pad that SDL itself makes up: no kernel device, no display. Package libsdl2-2.0-0.
#pragma once

#include <dlfcn.h>

#include <atomic>
#include <cstdint>
#include <string>

#include "gamepad/sdl.hpp"

namespace swage::test {

class VirtualPad {
 public:
  /// Makes SDL ready as the driver does. False: SDL is not installed.
  static bool possible() {
    std::string why;
    return gamepad::load_sdl(why) != nullptr;
  }
  VirtualPad() { plug(); }
  ~VirtualPad() { unplug(); }
  VirtualPad(const VirtualPad&) = delete;
  VirtualPad& operator=(const VirtualPad&) = delete;

  void plug() {
    constexpr int kGameController = 1;  // SDL_JOYSTICK_TYPE_GAMECONTROLLER
    index_ = call<int (*)(int, int, int, int)>("SDL_JoystickAttachVirtual")(kGameController, 6, 15, 0);
    stick_ = call<void* (*)(int)>("SDL_JoystickOpen")(index_);
    axis(gamepad::kLeftTrigger, -1);
    axis(gamepad::kRightTrigger, -1);
    update();
  }
  void unplug() {
    if (stick_ == nullptr) return;
    call<int (*)(int)>("SDL_JoystickDetachVirtual")(index_);
    call<void (*)(void*)>("SDL_JoystickClose")(stick_);
    stick_ = nullptr;
  }
  /// -1..1 of a stick; of a trigger -1 is let go.
  void axis(gamepad::Axis a, double value) {
    if (stick_ != nullptr)
      call<int (*)(void*, int, int16_t)>("SDL_JoystickSetVirtualAxis")(stick_, a, static_cast<int16_t>(value < 0 ? 32768 * value : 32767 * value));
  }
  void button(gamepad::Button b, bool down) {
    if (stick_ != nullptr) call<int (*)(void*, int, uint8_t)>("SDL_JoystickSetVirtualButton")(stick_, b, down ? 1 : 0);
  }
  void update() { call<void (*)()>("SDL_JoystickUpdate")(); }

 private:
  template <class Function>
  static Function call(const char* name) {
    static void* const sdl = dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL);
    return reinterpret_cast<Function>(dlsym(sdl, name));
  }
  int index_ = -1;
  void* stick_ = nullptr;
};

}  // namespace swage::test
