// SPDX-License-Identifier: Apache-2.0
//
// MuJoCo as Debian ships it (2.2.2), in mm, mg, s: in metres it refuses the inertia of a straight needle.
#include <mujoco/mujoco.h>

#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "engine.hpp"

namespace swage::bench {
namespace {

constexpr double kLength = 1e3, kMass = 1e6;  // per m, per kg
constexpr double kForce = kMass * kLength, kTorque = kForce * kLength;

struct Options {
  std::string integrator = "Euler";
  std::string contact;  // attributes of every geom: solref, solimp
  std::string option;   // attributes of <option>
  bool welded = false;  // jaws are position-servoed hinges on a tool welded to a mocap body; else mocap jaws
};

mjModel* load(const std::string& xml) {
  char error[1000] = "";
  auto* files = static_cast<mjVFS*>(std::malloc(sizeof(mjVFS)));
  mj_defaultVFS(files);
  mj_makeEmptyFileVFS(files, "model.xml", static_cast<int>(xml.size()));
  std::memcpy(files->filedata[0], xml.data(), xml.size());
  mjModel* m = mj_loadXML("model.xml", files, error, sizeof error);
  std::free(files);
  if (!m) throw std::runtime_error(std::string("MuJoCo refuses the model: ") + error);
  return m;
}

std::string numbers(const Vec3& v) {
  std::ostringstream o;
  o.precision(15);
  o << v.x() << ' ' << v.y() << ' ' << v.z();
  return o.str();
}

std::string jaw_meshes() {
  std::ostringstream o;
  o.precision(15);
  for (int k = 0; k < 2; ++k) {
    const Jaw j = jaw(k == 0 ? 1 : -1);
    o << "<mesh name='j" << k << "' vertex='";
    for (const Vec3& v : j.vertex) o << numbers(v * kLength) << ' ';
    o << "' face='";
    for (const auto& t : triangles(j)) o << t[0] << ' ' << t[1] << ' ' << t[2] << ' ';
    o << "'/>";
  }
  return o.str();
}

std::string needle_geoms(const Needle& n, const std::string& contact) {
  std::ostringstream o;
  o.precision(15);
  for (const Vec3& c : n.chain(100))
    o << "<geom type='sphere' size='" << n.wire_radius() * kLength << "' pos='" << numbers(c * kLength)
      << "' contype='1' conaffinity='2'" << contact << "/>";
  return o.str();
}

std::string inertial(double mass, const Vec3& moments) {
  std::ostringstream o;
  o.precision(15);
  o << "<inertial pos='0 0 0' mass='" << mass * kMass << "' diaginertia='"
    << numbers(moments * kMass * kLength * kLength) << "'/>";
  return o.str();
}

class MuJoCo final : public Engine {
 public:
  MuJoCo(const Setup& s, const Options& o)
      : Engine(s), options_(o), model_(load(xml())), data_(mj_makeData(model_)) {
    body_ = mj_name2id(model_, mjOBJ_BODY, "needle");
    const int joint = model_->body_jntadr[body_];
    q_ = model_->jnt_qposadr[joint], v_ = model_->jnt_dofadr[joint];
    for (int k = 0; k < 2; ++k) {
      jaw_[k] = mj_name2id(model_, mjOBJ_BODY, k ? "b1" : "b0");
      hinge_[k] = mj_name2id(model_, mjOBJ_JOINT, k ? "h1" : "h0");
    }
    set_gravity(Vec3::Zero());
  }
  ~MuJoCo() override {
    mj_deleteData(data_);
    mj_deleteModel(model_);
  }

  void set_needle(const Pose& X, const Vec3& v, const Vec3& w) override {
    mjtNum* q = data_->qpos + q_;
    for (int i = 0; i < 3; ++i) q[i] = X.p[i] * kLength;
    q[3] = X.q.w(), q[4] = X.q.x(), q[5] = X.q.y(), q[6] = X.q.z();
    const Vec3 w_N = X.q.conjugate() * w;
    mjtNum* u = data_->qvel + v_;
    for (int i = 0; i < 3; ++i) u[i] = v[i] * kLength, u[3 + i] = w_N[i];
    mj_forward(model_, data_);
  }
  Pose needle() const override {
    const mjtNum* q = data_->qpos + q_;
    return {Vec3{q[0], q[1], q[2]} / kLength, Quat{q[3], q[4], q[5], q[6]}};
  }
  Vec3 velocity() const override {
    const mjtNum* u = data_->qvel + v_;
    return Vec3{u[0], u[1], u[2]} / kLength;
  }
  Vec3 angular_velocity() const override {
    const mjtNum* u = data_->qvel + v_;
    return needle().q * Vec3{u[3], u[4], u[5]};
  }
  void set_gravity(const Vec3& g) override {
    for (int i = 0; i < 3; ++i) model_->opt.gravity[i] = g[i] * kLength;
  }
  void set_jaws(const Pose& upper, const Pose& lower, bool jump) override {
    if (options_.welded) {
      set_welded(upper, lower, jump);
      return;
    }
    const Pose* X[2] = {&upper, &lower};
    for (int k = 0; k < 2; ++k) {
      if (setup.upper_driven && k == 0) {
        if (jump) data_->qpos[model_->jnt_qposadr[hinge_[0]]] = toolkit::log_rotation(upper.q).y();
        continue;
      }
      set_mocap(jaw_[k], *X[k]);
    }
  }
  void set_torque(double closing) override {
    data_->qfrc_applied[model_->jnt_dofadr[hinge_[0]]] = closing * kTorque;
  }
  void set_force(const Vec3& f, const Vec3& p) override { force_ = f, couple_ += (p - needle().p).cross(f); }
  void set_couple(const Vec3& t) override { couple_ += t; }
  void step() override {
    mjtNum* x = data_->xfrc_applied + 6 * body_;
    for (int i = 0; i < 3; ++i) x[i] = force_[i] * kForce, x[3 + i] = couple_[i] * kTorque;
    mj_step(model_, data_);
    force_.setZero(), couple_.setZero();
    if (hinge_[0] >= 0) data_->qfrc_applied[model_->jnt_dofadr[hinge_[0]]] = 0;
  }
  Pose upper() const override {
    const mjtNum* p = data_->xpos + 3 * jaw_[0];
    const mjtNum* q = data_->xquat + 4 * jaw_[0];
    return {Vec3{p[0], p[1], p[2]} / kLength, Quat{q[0], q[1], q[2], q[3]}};
  }
  int contacts(double& deepest) const override {
    deepest = 0;
    for (int i = 0; i < data_->ncon; ++i) deepest = std::min(deepest, data_->contact[i].dist / kLength);
    return data_->ncon;
  }

 private:
  std::string contact_attributes() const {
    return " friction='" + std::to_string(setup.friction) + " 0 0' condim='3' " + options_.contact;
  }
  std::string jaws_xml() const {
    const double I = setup.jaw_mass * Jaw::kGrip * Jaw::kGrip;
    const std::string mass = inertial(setup.jaw_mass, Vec3::Constant(I));
    const auto body = [&](int k, const char* kind, const std::string& joint) {
      const std::string n = std::to_string(k);
      return "<body name='b" + n + "'" + kind + ">" + joint + "<geom type='mesh' mesh='j" + n +
             "' contype='2' conaffinity='1'" + contact_attributes() + "/></body>";
    };
    const auto hinge = [&](int k, const char* axis) {
      return "<joint name='h" + std::to_string(k) + "' type='hinge' axis='" + axis + "'/>" + mass;
    };
    if (options_.welded)
      return "<body name='mt' mocap='true'/><body name='tool'><freejoint/>" +
             inertial(0.05, Vec3::Constant(0.05 * 1e-4)) + body(0, "", hinge(0, "0 -1 0")) +
             body(1, "", hinge(1, "0 -1 0")) + "</body>";
    return (setup.upper_driven ? body(0, "", hinge(0, "0 1 0")) : body(0, " mocap='true'", "")) +
           body(1, " mocap='true'", "");
  }
  std::string servo_xml() const {
    const double I = setup.jaw_mass * Jaw::kGrip * Jaw::kGrip * kMass * kLength * kLength;
    const double kp = I * 4e5;  // a servo of about 100 Hz, critically damped
    std::ostringstream o;
    o.precision(15);
    o << "<equality><weld body1='mt' body2='tool' solref='0.002 1' solimp='0.999 0.9999 "
         "0.001'/></equality><actuator>";
    for (int k = 0; k < 2; ++k)
      o << "<general joint='h" << k << "' gaintype='fixed' gainprm='" << kp
        << " 0 0' biastype='affine' biasprm='0 -" << kp << " -" << 2 * std::sqrt(kp * I) << "'/>";
    o << "</actuator>";
    return o.str();
  }
  std::string xml() const {
    std::ostringstream o;
    o.precision(15);
    o << "<mujoco><compiler inertiafromgeom='false' angle='radian'/><option timestep='" << setup.dt
      << "' integrator='" << options_.integrator << "' " << options_.option
      << "/><size nconmax='400' njmax='2000'/>";
    if (setup.jaws) o << "<asset>" << jaw_meshes() << "</asset>";
    o << "<worldbody>";
    if (setup.ball_radius > 0)
      o << "<geom type='plane' size='100 100 1' contype='2' conaffinity='1'" << contact_attributes() << "/>";
    if (setup.jaws) o << jaws_xml();
    o << "<body name='needle'><freejoint/>" << inertial(setup.mass(), setup.moments());
    if (setup.ball_radius > 0)
      o << "<geom type='sphere' size='" << setup.ball_radius * kLength << "' contype='1' conaffinity='2'"
        << contact_attributes() << "/>";
    else if (setup.jaws)
      o << needle_geoms(setup.needle, contact_attributes());
    o << "</body></worldbody>";
    if (setup.jaws && options_.welded) o << servo_xml();
    o << "</mujoco>";
    return o.str();
  }
  void set_mocap(int body, const Pose& X) {
    const int i = model_->body_mocapid[body];
    if (i < 0) return;
    mjtNum* p = data_->mocap_pos + 3 * i;
    mjtNum* q = data_->mocap_quat + 4 * i;
    for (int k = 0; k < 3; ++k) p[k] = X.p[k] * kLength;
    q[0] = X.q.w(), q[1] = X.q.x(), q[2] = X.q.y(), q[3] = X.q.z();
  }
  /// The tool takes the middle of the two jaws, the hinges take half the angle between them each.
  void set_welded(const Pose& upper, const Pose& lower, bool jump) {
    const double half = 0.5 * toolkit::log_rotation(upper.q.conjugate() * lower.q).y();
    const Pose tool{upper.p, upper.q * toolkit::exp_rotation({0, half, 0})};
    set_mocap(mj_name2id(model_, mjOBJ_BODY, "mt"), tool);
    data_->ctrl[0] = half, data_->ctrl[1] = -half;
    if (!jump) return;
    mjtNum* q =
        data_->qpos + model_->jnt_qposadr[model_->body_jntadr[mj_name2id(model_, mjOBJ_BODY, "tool")]];
    for (int k = 0; k < 3; ++k) q[k] = tool.p[k] * kLength;
    q[3] = tool.q.w(), q[4] = tool.q.x(), q[5] = tool.q.y(), q[6] = tool.q.z();
    for (int k = 0; k < 2; ++k) data_->qpos[model_->jnt_qposadr[hinge_[k]]] = k ? -half : half;
  }

  Options options_;
  mjModel* model_;
  mjData* data_;
  int body_ = -1, q_ = 0, v_ = 0, jaw_[2] = {-1, -1}, hinge_[2] = {-1, -1};
  Vec3 force_ = Vec3::Zero(), couple_ = Vec3::Zero();
};

struct MuJoCoQuery {
  mjModel* model;
  mjData* data;
  int upper;

  explicit MuJoCoQuery(const Needle& n) {
    std::string xml =
        "<mujoco><compiler inertiafromgeom='false'/><asset>" + jaw_meshes() + "</asset><worldbody>";
    for (const char* k : {"0", "1"})
      xml += std::string("<body name='b") + k + "' mocap='true'><geom type='mesh' mesh='j" + k +
             "' contype='2' conaffinity='1'/></body>";
    xml += "<body name='needle'><freejoint/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>" +
           needle_geoms(n, "") + "</body></worldbody></mujoco>";
    model = load(xml);
    data = mj_makeData(model);
    upper = mj_name2id(model, mjOBJ_BODY, "b0");
  }
  ~MuJoCoQuery() {
    mj_deleteData(data);
    mj_deleteModel(model);
  }
  MuJoCoQuery(const MuJoCoQuery&) = delete;
  MuJoCoQuery& operator=(const MuJoCoQuery&) = delete;

  static void put(const Pose& X, mjtNum* p, mjtNum* q) {
    for (int k = 0; k < 3; ++k) p[k] = X.p[k] * kLength;
    q[0] = X.q.w(), q[1] = X.q.x(), q[2] = X.q.y(), q[3] = X.q.z();
  }
  Gaps run(const Pose& needle, const Pose& up, const Pose& low) {
    put(needle, data->qpos, data->qpos + 3);
    put(up, data->mocap_pos, data->mocap_quat);
    put(low, data->mocap_pos + 3, data->mocap_quat + 4);
    mj_kinematics(model, data);
    mj_comPos(model, data);  // the bounding-sphere filter needs it
    mj_collision(model, data);
    Gaps g;
    for (int i = 0; i < data->ncon; ++i) {
      const mjContact& c = data->contact[i];
      const int body = std::min(model->geom_bodyid[c.geom1], model->geom_bodyid[c.geom2]);
      const int k = body == upper ? 0 : 1;
      g.gap[k] = std::min(g.gap[k], c.dist / kLength);
    }
    g.contacts = data->ncon;
    return g;
  }
};

}  // namespace

std::vector<Method> mujoco_methods() {
  const auto with = [](Options o) { return [o](const Setup& s) { return std::make_unique<MuJoCo>(s, o); }; };
  const std::string contact = "solref='0.002 1' solimp='0.99 0.999 0.001'";
  const std::string solver = "impratio='10' cone='elliptic' noslip_iterations='10' tolerance='1e-10'";
  return {
      {"MuJoCo tuned, welded tool", "MuJoCo", with({"Euler", contact, solver, true}), false,
       Method::Differs::kInContact},  // the best found
      {"MuJoCo tuned, mocap jaws", "MuJoCo", with({"Euler", contact, solver, false}), false,
       Method::Differs::kInContact},
      {"MuJoCo default", "MuJoCo", with({"Euler", "", "", false})},
      {"MuJoCo RK4", "MuJoCo", with({"RK4", "", "", false}), false, Method::Differs::kFree},
      {"MuJoCo implicit", "MuJoCo", with({"implicit", "", "", false}), false, Method::Differs::kFree},
  };
}

std::vector<Query> mujoco_queries(const Needle& needle) {
  auto q = std::make_shared<MuJoCoQuery>(needle);
  return {{"MuJoCo spheres, mesh jaws", "MuJoCo", false,
           [q](const Pose& n, const Pose& u, const Pose& l) { return q->run(n, u, l); }}};
}

}  // namespace swage::bench
