// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "host/builder.hpp"
#include "host/c_values.hpp"
#include "host/sentences.hpp"
#include "toolkit/math.hpp"

namespace swage::host {
namespace {

/// Fault of a height field, or "". `states`: private doubles of the instance.
std::string problem_of(const swage_height_field* f, uint32_t states) {
  // 129 x 129: the heights are saved, hashed and checked in every step
  constexpr uint32_t kMost = 129;
  if (f == nullptr || !toolkit::vec(f->X_BH.p).allFinite() ||
      std::abs(toolkit::quat(f->X_BH.q).norm() - 1) > 1e-6)
    return say::kFieldPose();
  if (std::min(f->nx, f->ny) < 2 || std::max(f->nx, f->ny) > kMost)
    return say::kFieldCount(kMost);
  if (!positive(f->dx) || !positive(f->dy) || !positive(f->below))
    return say::kFieldCells();
  const uint32_t n = f->nx * f->ny;
  const auto finite = [](double z) { return std::isfinite(z); };
  if (f->height == nullptr || !std::all_of(f->height, f->height + n, finite))
    return say::kFieldHeights();
  if (f->state != SWAGE_NONE && (f->state > states || n > states - f->state))
    return say::kFieldState();
  return "";
}

}  // namespace

struct HeightFieldCalls {
  static uint32_t declare(swage_builder* raw, uint32_t body, const swage_height_field* field,
                          uint32_t flags) {
    Builder& b = *static_cast<Builder*>(raw->host_data);
    if (!b.owns_body(body, "A height field")) return scene::kNone;
    if (const std::string wrong = problem_of(field, b.state.count); !wrong.empty()) return b.refuse(wrong);

    scene::HeightFieldInfo info{field->nx, field->ny, field->dx, field->dy, field->below, {}, scene::kNone};
    info.height.assign(field->height, field->height + info.nx * info.ny);
    if (field->state != SWAGE_NONE) info.state = b.state.first + field->state;
    scene::Shape shape;
    shape.kind = SWAGE_SHAPE_HEIGHT_FIELD;
    shape.X_BS = field->X_BH;
    shape.field = static_cast<uint32_t>(b.world_.field.size());
    const auto [low, high] = std::minmax_element(info.height.begin(), info.height.end());
    const double far = std::max(std::abs(*low - info.below), std::abs(*high));
    shape.bounding_radius = toolkit::Vec3((info.nx - 1) * info.dx, (info.ny - 1) * info.dy, far).norm();
    const uint32_t index = b.add_shape(body, shape, flags);
    if (index != scene::kNone) b.world_.field.push_back(std::move(info));
    return index;
  }
};

const swage_host_height_field& height_field_table() {
  static constexpr swage_host_height_field table{HeightFieldCalls::declare};
  return table;
}

}  // namespace swage::host
