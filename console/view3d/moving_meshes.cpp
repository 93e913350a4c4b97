// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Meshes that are rebuilt as their object bends: a wire of several bodies, a thread.
#include "console/view3d/region_look.hpp"
#include "console/view3d/scene_parts.hpp"

namespace swage::console {

Mesh chain_mesh(const SceneParts& parts, const ScenePart& part, std::span<const swage_pose> X_WB) {
  const WireChain& chain = parts.chains[static_cast<size_t>(part.chain)];
  std::vector<double> line = chain.centre_line(X_WB);
  const bool sleeve = part.role == Role::kMark;
  if (sleeve) line = part_of_line(line, part.from, part.to);
  Mesh mesh;
  append_thread(line.data(), static_cast<uint32_t>(line.size() / 3),
                chain.radius * (part.collar ? kCollarGrow
                                : sleeve    ? kSleeve
                                            : 1),
                mesh, sleeve ? 0 : chain.taper);
  return mesh;
}

Mesh thread_mesh(const SceneParts& parts, const ScenePart& part, std::span<const double> p_W, double least) {
  const ThreadLine& thread = parts.threads[static_cast<size_t>(part.thread)];
  if (part.role != Role::kMark) return thread.mesh(p_W, least);
  return thread.part(p_W, least, part.from, part.to, part.collar ? kThreadCollarGrow : kThreadSleeve);
}

}  // namespace swage::console
