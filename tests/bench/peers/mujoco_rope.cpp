// SPDX-License-Identifier: Apache-2.0
//
// A rope of MuJoCo as its manual makes one: a tree of rods with ball joints, each a spring of EI over the length of a rod. In mm, mg, s.
#include "peers/rope.hpp"

#include <mujoco/mujoco.h>

#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace swage::bench {
namespace {

constexpr double kLength = 1e3, kMass = 1e6;  // per m, per kg
/// Springs are damped by this time: the slowest swing is damped critically, and the joints' springs, explicit in time, are stable.
constexpr double kDamped = 25e-3;  // s

std::string model_of(const RopeSetup& s) {
  const double l = s.length / s.segments * kLength, spring = s.bending / (s.length / s.segments) * kMass * kLength * kLength;
  std::ostringstream o;
  o.precision(15);
  o << "<mujoco><option timestep='0.001' gravity='0 0 " << -9.80665 * kLength << "'/><compiler boundmass='1e-12' boundinertia='1e-15'/><worldbody>";
  for (int i = 1; i < s.segments; ++i)
    o << "<body pos='" << l << " 0 0'><joint type='ball' stiffness='" << spring << "' damping='" << spring * kDamped
      << "'/><geom type='capsule' fromto='0 0 0 " << l << " 0 0' size='" << 0.5 * s.diameter * kLength << "' mass='"
      << s.line_mass * s.length / s.segments * kMass << "' contype='0' conaffinity='0'/>";
  o << "<site name='end' pos='" << l << " 0 0'/>";
  for (int i = 1; i < s.segments; ++i) o << "</body>";
  o << "</worldbody></mujoco>";
  return o.str();
}

class MuJoCoRope final : public Rope {
 public:
  explicit MuJoCoRope(const RopeSetup& s) {
    const std::string xml = model_of(s);
    char error[1000] = "";
    auto* files = static_cast<mjVFS*>(std::malloc(sizeof(mjVFS)));
    mj_defaultVFS(files);
    mj_makeEmptyFileVFS(files, "rope.xml", static_cast<int>(xml.size()));
    std::memcpy(files->filedata[0], xml.data(), xml.size());
    model_ = mj_loadXML("rope.xml", files, error, sizeof error);
    std::free(files);
    if (!model_) throw std::runtime_error(std::string("MuJoCo refuses the rope: ") + error);
    data_ = mj_makeData(model_);
    mj_forward(model_, data_);
  }
  ~MuJoCoRope() override { mj_deleteData(data_), mj_deleteModel(model_); }
  void step() override { mj_step(model_, data_); }
  Vec3 end() const override { return Vec3(data_->site_xpos[0], data_->site_xpos[1], data_->site_xpos[2]) / kLength; }

 private:
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

}  // namespace

std::unique_ptr<Rope> mujoco_rope(const RopeSetup& s) { return std::make_unique<MuJoCoRope>(s); }

}  // namespace swage::bench
