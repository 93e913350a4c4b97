// SPDX-License-Identifier: Apache-2.0
//
// Glue between the C tables and the author's class: every entry checks the thread role and the order of calls,
// catches exceptions, and calls the class. Nothing here is for authors.
#pragma once

#include <swage/builder.hpp>
#include <swage/instance.hpp>
#include <swage/params.hpp>

#include <cstring>
#include <exception>
#include <memory>
#include <optional>

namespace swage::detail {

/// Which roles may call an entry, as bits 1 << SWAGE_THREAD_*.
inline constexpr uint32_t kMain = 1u << SWAGE_THREAD_MAIN;
inline constexpr uint32_t kRt = 1u << SWAGE_THREAD_RT;
inline constexpr uint32_t kIo = 1u << SWAGE_THREAD_IO;

/// When an entry may be called.
enum class When { kAlways, kInactive, kReady, kActive };  // kReady: configured and not active

struct Entry {
  const char* name;
  uint32_t index;  // 0..63, a bit of Holder::told and the number in a fault record
  uint32_t roles;
  When when;
};

inline constexpr Entry kConfigure{"configure", 0, kMain, When::kInactive};
inline constexpr Entry kActivate{"activate", 1, kMain, When::kReady};
inline constexpr Entry kDeactivate{"deactivate", 2, kMain, When::kActive};
inline constexpr Entry kDestroy{"destroy", 3, kMain, When::kInactive};
inline constexpr Entry kChange{"change", 22, kRt, When::kActive};

/// Reports about a call that breaks the rules.
inline constexpr const char* kWrongThread = "the host called from the wrong thread";
inline constexpr const char* kTooEarly = "called before a configure that succeeded";
inline constexpr const char* kNotActive = "called before activate";
inline constexpr const char* kStillActive = "called while active";
inline constexpr const char* kThrewAnything = "threw something that is not a std::exception";

inline bool same(const char* a, const char* b) { return std::strcmp(a, b) == 0; }

/// One live plugin T and the state of its guard.
template <class T>
struct Holder {
  swage_instance raw{};
  const swage_host* host = nullptr;
  std::string name;
  std::optional<T> plugin;  // made anew by every configure, so that build() starts from a fresh object
  uint32_t n_state = 0;
  uint64_t told = 0;  // entries whose call from a wrong thread has been reported
  bool ready = false, active = false;

  static Holder& of(swage_instance* instance) { return *static_cast<Holder*>(instance->self); }
};

/// The only friend of Instance.
struct Access {
  static void attach(Instance& instance, const swage_host* host, const std::string& name) {
    instance.host_ = host;
    instance.name_ = name;
  }
  static swage_result& result(Instance& instance) { return instance.result_; }
  static void activate(Instance& instance, double dt_s) { instance.activate(dt_s); }
  static void deactivate(Instance& instance) { instance.deactivate(); }
  static const void* extension(Instance& instance, const char* id) { return instance.extension(id); }
  template <class P>
  static void changed(WithParams<P>& instance) {
    instance.changed();
  }
  template <class P>
  static P& params(WithParams<P>& instance) {
    return instance.params_;
  }
};

/// Reports a fault to the host: as a record from any thread, and in words where the thread role allows text.
template <class T>
void tell(const Holder<T>& holder, const Entry& entry, int32_t code, double b, const char* what) noexcept {
  const swage_host* host = holder.host;
  host->fault(host, code, entry.index, b);
  if (host->thread_kind(host) == SWAGE_THREAD_RT) return;
  try {
    const std::string message = std::string(entry.name) + ": " + what;
    host->report(host, SWAGE_SEVERE, str(holder.name), str(message));
  } catch (...) {
    // no memory for the text; the record has been made
  }
}

/// Reports a call from the wrong thread, once per entry and instance. The call is executed nevertheless.
template <class T>
void check_role(Holder<T>& holder, const Entry& entry) noexcept {
  if constexpr (SWAGE_CHECKS != 0) {
    const int32_t kind = holder.host->thread_kind(holder.host);
    const uint32_t caller = kind >= SWAGE_THREAD_MAIN && kind <= SWAGE_THREAD_IO ? 1u << kind : 0u;
    const uint64_t bit = uint64_t{1} << entry.index;
    if ((entry.roles & caller) != 0 || (holder.told & bit) != 0) return;
    holder.told |= bit;
    tell(holder, entry, SWAGE_FAULT_THREAD, kind, kWrongThread);
  }
}

/// Reports a call that comes too early or too late; the entry then does nothing.
template <class T>
bool in_order(const Holder<T>& holder, const Entry& entry) noexcept {
  const char* wrong = nullptr;
  if (entry.when == When::kActive && !holder.active) wrong = kNotActive;
  if (entry.when == When::kReady && !holder.ready) wrong = kTooEarly;
  if ((entry.when == When::kReady || entry.when == When::kInactive) && holder.active)
    wrong = kStillActive;
  if (entry.when == When::kAlways && !holder.ready) wrong = kTooEarly;
  if (wrong != nullptr) tell(holder, entry, SWAGE_FAULT_ORDER, 0, wrong);
  return wrong == nullptr;
}

/// Runs `body`; an exception becomes SWAGE_FAULT and does not leave the plugin.
template <class T, class F>
swage_result contained(const Holder<T>& holder, const Entry& entry, F&& body) noexcept {
  try {
    return body();
  } catch (const std::exception& error) {
    tell(holder, entry, SWAGE_FAULT_THROWN, 0, error.what());
  } catch (...) {
    tell(holder, entry, SWAGE_FAULT_THROWN, 0, kThrewAnything);
  }
  return SWAGE_FAULT;
}

/// The whole guard around a call of the author's code.
template <class T, class F>
swage_result guarded(swage_instance* raw, const Entry& entry, F&& body) noexcept {
  Holder<T>& holder = Holder<T>::of(raw);
  check_role(holder, entry);
  if (!in_order(holder, entry)) return SWAGE_ERROR;
  return contained(holder, entry, [&] {
    typename T::Kind& plugin = *holder.plugin;
    Access::result(plugin) = SWAGE_OK;
    body(plugin, holder);
    return Access::result(plugin);
  });
}

/// The five functions of swage_instance for plugin T.
template <class T>
struct InstanceEntries {
  static swage_result configure(swage_instance* raw, const swage_values* values,
                                swage_builder* builder) noexcept {
    Holder<T>& holder = Holder<T>::of(raw);
    check_role(holder, kConfigure);
    if (!in_order(holder, kConfigure)) return SWAGE_ERROR;
    holder.ready = false;
    const swage_result result = contained(holder, kConfigure, [&] { return build(holder, values, builder); });
    holder.ready = result >= 0;
    return result;
  }

  static swage_result activate(swage_instance* raw, double dt_s) noexcept {
    return guarded<T>(raw, kActivate, [&](Instance& plugin, Holder<T>& holder) {
      Access::activate(plugin, dt_s);
      holder.active = Access::result(plugin) >= 0;
    });
  }

  static void deactivate(swage_instance* raw) noexcept {
    guarded<T>(raw, kDeactivate, [](Instance& plugin, Holder<T>& holder) {
      holder.active = false;
      Access::deactivate(plugin);
    });
  }

  static void destroy(swage_instance* raw) noexcept {
    Holder<T>& holder = Holder<T>::of(raw);
    check_role(holder, kDestroy);
    if (!in_order(holder, kDestroy)) deactivate(raw);
    delete &holder;
  }

  static swage_result change(swage_instance* raw, uint32_t param, const swage_value* value) noexcept {
    return guarded<T>(raw, kChange, [&](typename T::Kind& plugin, auto&) {
      const bool known = Table<T>::change(param, *value, Access::params(plugin));
      if (known) Access::changed(plugin);
      if (!known) Access::result(plugin) = SWAGE_ERROR;
    });
  }

  static const void* get_extension(swage_instance* raw, const char* id) noexcept {
    if (const void* table = T::template Tables<T>::find(id)) return table;
    if constexpr (Table<T>::has_live()) {
      static constexpr swage_live live{change};
      if (same(id, SWAGE_EXT_LIVE)) return &live;
    }
    Holder<T>& holder = Holder<T>::of(raw);
    if (!holder.plugin) return nullptr;
    try {
      if (const void* table = Access::extension(*holder.plugin, id)) return table;
    } catch (...) {
      return nullptr;
    }
    return promised(id) ? &kPromise : nullptr;
  }

 private:
  static constexpr uint32_t kPromise = 1;

  /// A trait that the plugin lists and has no table for.
  static bool promised(const char* id) {
    for (const char* const* trait = T::template Tables<T>::traits; *trait != nullptr; ++trait)
      if (same(id, *trait)) return true;
    return false;
  }

  static swage_result build(Holder<T>& holder, const swage_values* values, swage_builder* builder) {
    typename T::Kind& plugin = holder.plugin.emplace();
    if (values != nullptr) holder.name = view(values->instance_name);
    Access::attach(plugin, holder.host, holder.name);
    Table<T>::read(values, Access::params(plugin));
    typename T::Builder declare(builder);
    plugin.build(plugin.params(), declare);
    holder.n_state = declare.n_state();
    return declare.failed() ? SWAGE_ERROR : Access::result(plugin);
  }
};

/// A new instance, or nullptr when it cannot be made.
template <class T>
swage_instance* create(const swage_host* host) noexcept {
  try {
    auto holder = std::make_unique<Holder<T>>();
    using E = InstanceEntries<T>;
    holder->raw = {holder.get(), E::configure, E::activate, E::deactivate, E::destroy, E::get_extension};
    holder->host = host;
    holder->name = T::id;
    Access::attach(holder->plugin.emplace(), host, holder->name);  // extensions can be queried from now on
    return &holder.release()->raw;
  } catch (...) {
    return nullptr;
  }
}

}  // namespace swage::detail
