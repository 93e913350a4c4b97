// SPDX-License-Identifier: Apache-2.0
#include "step/write_guard.hpp"

#include <algorithm>
#include <cstring>

namespace swage::step {

namespace {

// sizes never change after the scene was built: nothing allocates after the first take
template <class T>
void keep(std::vector<T>& to, const std::vector<T>& from) noexcept {
  if (to.size() != from.size()) to.resize(from.size());
  std::copy(from.begin(), from.end(), to.begin());
}

template <class T>
bool put_back(std::vector<T>& now, const std::vector<T>& was) noexcept {
  if (now.empty() || std::memcmp(now.data(), was.data(), now.size() * sizeof(T)) == 0) return false;
  std::copy(was.begin(), was.end(), now.begin());
  return true;
}

}  // namespace

void WriteGuard::take() noexcept {
  keep(X_WB_, world_.X_WB);
  keep(V_WB_, world_.V_WB);
  keep(particle_p_W_, world_.particle_p_W);
  keep(particle_v_W_, world_.particle_v_W);
  keep(hinge_angle_, world_.hinge_angle);
  keep(hinge_rate_, world_.hinge_rate);
}

void WriteGuard::check(host::Instance& instance, host::Call call) noexcept {
  bool wrote = put_back(world_.X_WB, X_WB_);
  wrote |= put_back(world_.V_WB, V_WB_);
  wrote |= put_back(world_.particle_p_W, particle_p_W_);
  wrote |= put_back(world_.particle_v_W, particle_v_W_);
  wrote |= put_back(world_.hinge_angle, hinge_angle_);
  wrote |= put_back(world_.hinge_rate, hinge_rate_);
  if (wrote) host::quarantine(instance, host::FaultKind::kMeddled, call, world_.step);
}

}  // namespace swage::step
