// SPDX-License-Identifier: Apache-2.0
#include "scene/state_image.hpp"

#include <array>
#include <cstring>

namespace swage::scene {
namespace {

using Heading = std::array<uint64_t, 9>;

Heading heading(const World& w) noexcept {
  return {kImageVersion,         w.X_WB.size(),        w.V_WB.size(),
          w.particle_p_W.size(), w.hinge_angle.size(), w.hinge_rate.size(),
          w.plugin_state.size(), w.signal.size(),      w.random.size()};
}

}  // namespace

void Writer::put_bytes(const void* data, size_t size) noexcept {
  const auto* bytes = static_cast<const std::byte*>(data);
  if (!stores_) hash_.add(bytes, size / 8);
  if (stores_ && size > 0) {
    if (ok_ && size <= buffer_.size() - size_) {
      std::memcpy(buffer_.data() + size_, bytes, size);
    } else {
      ok_ = false;
      return;
    }
  }
  size_ += size;
}

uint64_t Writer::hash() const noexcept {
  if (!stores_) return hash_.value();
  StateHash of_buffer;
  of_buffer.add(buffer_.data(), size_ / 8);
  return of_buffer.value();
}

void Reader::get_bytes(void* data, size_t size) noexcept {
  if (!ok_ || size > image_.size()) {
    ok_ = false;
    return;
  }
  if (size > 0) std::memcpy(data, image_.data(), size);
  image_ = image_.subspan(size);
}

void save(const World& world, Writer& out) noexcept {
  out.put(heading(world));
  out.put(world.step);
  out.put(world.X_WB);
  out.put(world.V_WB);
  out.put(world.particle_p_W);
  out.put(world.particle_v_W);
  out.put(world.hinge_angle);
  out.put(world.hinge_rate);
  out.put(world.hinge_torque);
  out.put(world.plugin_state);
  out.put(world.signal);
  out.put(world.random);
}

bool restore(World& world, Reader& in) noexcept {
  Heading found{};
  in.get(found);
  if (!in.ok() || found != heading(world)) {
    in.fail();
    return false;
  }
  in.get(world.step);
  in.get(world.X_WB);
  in.get(world.V_WB);
  in.get(world.particle_p_W);
  in.get(world.particle_v_W);
  in.get(world.hinge_angle);
  in.get(world.hinge_rate);
  in.get(world.hinge_torque);
  in.get(world.plugin_state);
  in.get(world.signal);
  in.get(world.random);
  return in.ok();
}

size_t image_size(const World& world) {
  Writer count;
  save(world, count);
  return count.size();
}

uint64_t hash(const World& world) noexcept {
  Writer count;
  save(world, count);
  return count.hash();
}

}  // namespace swage::scene
