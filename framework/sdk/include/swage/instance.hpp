// SPDX-License-Identifier: Apache-2.0
//
// Base class of every plugin instance: its name, its host, and its reports of problems.
#pragma once

#include <swage/abi/builder.h>
#include <swage/abi/plugin.h>
#include <swage/common.hpp>

#include <string>
#include <string_view>

namespace swage {

namespace detail {
struct Access;
}

/// Base of Object, Coupling, Device and Lesson. The host is not yet known in the constructor of a plugin.
class Instance {
 public:
  Instance() = default;
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;
  virtual ~Instance() = default;

  /// Name of the instance in the lesson file. [any]
  std::string_view instance_name() const { return name_; }

 protected:
  /// Called before the first step, the last chance to allocate; dt_s: length of a step [s]. [main]
  virtual void activate(double dt_s) { static_cast<void>(dt_s); }
  virtual void deactivate() {}

  /// Tables of your own, e.g. of a trait "org.example.trait.sticky/1"; static for the life of the instance.
  /// [any]
  virtual const void* extension(std::string_view id) {
    static_cast<void>(id);
    return nullptr;
  }

  const swage_host& host() const { return *host_; }

  /// A table that the host may offer, e.g. host_extension<swage_host_pointer>(SWAGE_HOST_POINTER), or
  /// nullptr. [any]
  template <class Table>
  const Table* host_extension(const char* id) const {
    return static_cast<const Table*>(host_->get_extension(host_, id));
  }

  /// Capacities of a step of this scene; final from activate() on. Zeros from a host without the extension. [any]
  swage_capacities capacities() const SWAGE_RT {
    swage_capacities out{sizeof(swage_capacities), 0, 0, 0, 0, 0};
    if (const auto* table = host_extension<swage_host_capacities>(SWAGE_HOST_CAPACITIES))
      table->read(host_, &out);
    return out;
  }

  /// Messages to the user. [main | io]
  void note(std::string_view message) const { report(SWAGE_NOTE, message); }
  void warn(std::string_view message) const { report(SWAGE_WARNING, message); }
  /// Reports the reason and makes the present call fail. [main]
  void refuse(std::string_view message) {
    report(SWAGE_SEVERE, message);
    result_ = SWAGE_ERROR;
  }

  /// Makes the contribution of this call void; the instance stays in use. [rt | io]
  void discard() SWAGE_RT { result_ = SWAGE_DISCARD; }
  /// Asks to be quarantined; the code (0 or above) and two numbers go into the record. [rt | io]
  void give_up(int32_t code, double a = 0, double b = 0) SWAGE_RT {
    host_->fault(host_, code, a, b);
    result_ = SWAGE_ERROR;
  }

  /// The instance's own random stream, the same in every replay. [rt]
  uint64_t random_bits() SWAGE_RT { return host_->random_u64(host_); }
  /// Uniform in [0, 1). [rt]
  double random() SWAGE_RT { return static_cast<double>(random_bits() >> 11) * 0x1p-53; }

 private:
  friend struct detail::Access;

  void report(int32_t severity, std::string_view message) const {
    host_->report(host_, severity, str(name_), str(message));
  }

  const swage_host* host_ = nullptr;
  std::string name_;
  swage_result result_ = SWAGE_OK;
};

/// Keeps the checked values of the parameters.
template <class P>
class WithParams : public Instance {
 public:
  using Params = P;
  /// Values from the lesson file and the defaults; set before build(). [any]
  const Params& params() const { return params_; }

 protected:
  /// Called when a live() parameter has a new value, already in params(). [rt]
  virtual void changed() SWAGE_RT {}

 private:
  friend struct detail::Access;
  Params params_{};
};

}  // namespace swage
