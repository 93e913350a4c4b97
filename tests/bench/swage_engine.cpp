// SPDX-License-Identifier: Apache-2.0
//
// Our own rooms behind the interface that the peers stand behind: scene, contact and dynamics, without
// plugins; the needle that bends is the plugin's, without a host around it.
#include "base/hash.hpp"
#include "bending_body.hpp"
#include "both_jaws.hpp"
#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "dynamics/rebound.hpp"
#include "engine.hpp"
#include "scene/kinematics.hpp"
#include "swage_world.hpp"

namespace swage::bench {
namespace {

struct Choices {
  dynamics::Options dynamics;
  contact::Options contact;
  bool swept = true;  // false: what moves fast is looked for at its end pose alone
  int pieces = 0;     // of a needle that bends; 0: rigid
};

class Swage final : public Engine {
 public:
  Swage(const Setup& s, const Choices& c)
      : Engine(s),
        u_(unit_of(s)),
        world_(make_world(s)),
        bending_(c.pieces > 0 ? std::make_unique<BendingBody>(world_, s, c.pieces) : nullptr),
        needle_(bending_ ? BendingBody::kFirst : static_cast<uint32_t>(kNeedle)),
        detector_(world_, {contact::Pair{kNeedleObject, kJawsObject, {s.friction, 1e6, s.restitution}}},
                  c.contact),
        dynamics_(world_, c.dynamics),
        swept_(c.swept) {
    detector_.reserve(contacts_);
    target_[0] = target_[1] = Pose{};
  }

  void set_needle(const Pose& X, const Vec3& v, const Vec3& w) override {
    if (bending_) return bending_->put(X, v, w);
    world_.X_WB[kNeedle] = Pose{X.p * u_, X.q}.abi();
    world_.V_WB[kNeedle] = {toolkit::raw(Vec3(v * u_)), toolkit::raw(w)};
  }
  Pose needle() const override {
    const Pose X(world_.X_WB[needle_]);
    return {X.p / u_, X.q};
  }
  std::vector<Pose> way() const override {
    std::vector<Pose> poses;
    for (const dynamics::Waypoint& at : dynamics_.waypoints())
      if (at.body == needle_) poses.emplace_back(at.X_WB.p / u_, at.X_WB.q);
    if (!poses.empty()) poses.push_back(needle());
    return poses;
  }
  Vec3 velocity() const override { return toolkit::vec(world_.V_WB[needle_].v) / u_; }
  Vec3 angular_velocity() const override { return toolkit::vec(world_.V_WB[needle_].w); }
  void set_gravity(const Vec3& g) override { world_.gravity = toolkit::raw(Vec3(g * u_)); }
  void set_jaws(const Pose& upper, const Pose& lower, bool jump) override {
    target_[0] = Pose{upper.p * u_, upper.q}, target_[1] = Pose{lower.p * u_, lower.q};
    if (!jump) return;
    for (uint32_t k = 0; k < 2; ++k) {
      world_.X_WB[kUpper + k] = target_[k].abi();
      world_.V_WB[kUpper + k] = {};
    }
    if (setup.upper_driven) {
      world_.hinge_angle[0] = toolkit::log_rotation(upper.q).y();
      world_.hinge_rate[0] = 0;
    }
  }
  void set_torque(double closing) override { torque_ = closing * u_ * u_; }
  void set_force(const Vec3& f, const Vec3& p) override {
    force_ = f * u_, couple_ += (p - needle().p).cross(f) * u_ * u_;
  }
  void set_couple(const Vec3& t) override { couple_ += t * u_ * u_; }

  void step() override {
    for (uint32_t k = 0; setup.jaws && k < 2; ++k)
      if (world_.body[kUpper + k].motion == SWAGE_MOTION_FOLLOWS)
        scene::follow(world_, kUpper + k, target_[k]);
    // a drive asked to go far beyond its limit gives a constant torque
    if (setup.upper_driven)
      world_.drive[0] = {torque_ < 0 ? -1.0 : 1.0, 1e3 * std::abs(torque_), 0, std::abs(torque_)};
    world_.F_B_W[needle_] = {toolkit::raw(force_), toolkit::raw(couple_)};
    if (bending_) bending_->advance();
    dynamics_.free_motion(world_);
    detect();
    dynamics::FlexibleBody* const self[] = {bending_.get()};
    dynamics_.solve(world_, contacts_, {self, bending_ ? 1u : 0u}, {},
                    swept_ ? &detector_ : nullptr);
    dynamics_.finish(world_);
    ++world_.step;
    torque_ = 0, force_.setZero(), couple_.setZero();
  }
  Pose upper() const override {
    const Pose X(world_.X_WB[kUpper]);
    return {X.p / u_, X.q};
  }
  int contacts(double& deepest) const override {
    deepest = 0;
    int n = 0;
    for (const contact::Contact& c : contacts_.contact) {
      n += c.gap < 0;
      deepest = std::min(deepest, c.gap / u_);
    }
    return n;
  }
  Vec3 gives() const override { return bending_ ? bending_->gives() : Vec3::Zero(); }
  uint64_t contact_set() const override {
    base::Hash hash;
    for (const contact::Contact& c : contacts_.contact)
      if (c.gap < 0) hash.add(uint64_t{c.shape_b}).add(c.feature);
    return hash.value();
  }

 private:
  /// The detector sweeps what moves; a body without speed is looked for where it is.
  void detect() {
    if (swept_) return detector_.detect(world_, contacts_);
    const auto V_WB = world_.V_WB;
    for (auto& V : world_.V_WB) V = {};
    detector_.detect(world_, contacts_);
    world_.V_WB = V_WB;
  }

  double u_;
  scene::World world_;
  std::unique_ptr<BendingBody> bending_;
  uint32_t needle_;  // its body
  contact::Detector detector_;
  dynamics::Dynamics dynamics_;
  contact::ContactSet contacts_;
  bool swept_;
  Pose target_[2];
  double torque_ = 0;
  Vec3 force_ = Vec3::Zero(), couple_ = Vec3::Zero();
};

Gaps gaps_of(BothJaws& both, const TrajectoryPose& p) {
  Gaps g;
  const contact::Frame X_WN = both.needle_frame(p);
  for (size_t k = 0; k < 2; ++k) {
    g.contacts += both.collide(p, X_WN, k);
    for (int i = 0; i < both.found.count; ++i)
      g.gap[k] = std::min(g.gap[k], both.found.candidate[static_cast<size_t>(i)].touch.gap);
  }
  return g;
}

/// The chain of spheres under its tree, as the detector has it.
struct ChainQuery {
  scene::World world;
  contact::Detector detector;
  contact::ContactSet set;

  explicit ChainQuery(const Needle& n)
      : world(make_world(of(n))),
        detector(world, {contact::Pair{kNeedleObject, kJawsObject, {}}}, options()) {
    detector.reserve(set);
  }
  static Setup of(const Needle& n) {
    Setup s;
    s.needle = n;
    return s;
  }
  static contact::Options options() {
    contact::Options o;
    o.level = contact::Level::kThesis;
    return o;
  }
  Gaps run(const Pose& X_WN, const Pose& upper, const Pose& lower) {
    world.X_WB[kNeedle] = X_WN.abi(), world.X_WB[kUpper] = upper.abi(), world.X_WB[kLower] = lower.abi();
    detector.detect(world, set);
    Gaps g;
    for (const contact::Contact& c : set.contact)
      g.gap[c.shape_b - 1] = std::min(g.gap[c.shape_b - 1], c.gap), ++g.contacts;
    return g;
  }
};

}  // namespace

std::vector<Method> swage_methods() {
  const auto with = [](Choices c) { return [c](const Setup& s) { return std::make_unique<Swage>(s, c); }; };
  const auto free = [](dynamics::FreeMotion f) {
    Choices c;
    c.dynamics.free_motion = f;
    return c;
  };
  Choices impulse, chain, discrete, loop, bending, finest;
  bending.pieces = 12, finest.pieces = toolkit::BentWire::kMaxPieces;
  impulse.dynamics.response = dynamics::Response::kImpulse;
  chain.contact.level = contact::Level::kThesis;
  discrete.swept = false;
  loop.dynamics = {dynamics::FreeMotion::kThesis, dynamics::Response::kImpulse};
  loop.contact.level = contact::Level::kThesis;
  using enum Method::Differs;
  using enum dynamics::FreeMotion;
  std::vector<Method> methods = {
      {"swage", "swage", with({}), true},
      {"swage, chain of spheres", "thesis", with(chain), false, kInContact},
      {"swage, impulse method of the thesis", "thesis", with(impulse), true, kInContact},
      {"swage, whole loop of the thesis", "thesis", with(loop), false, kInContact},
      {"swage, without swept query", "swage", with(discrete), true, kInContact},
      {"swage, bending needle", "swage", with(bending), true, kInContact},
      {"swage, bending needle of 48 arcs", "swage", with(finest), true, kNowhere},
      {"swage, explicit Euler of the thesis", "thesis", with(free(kThesis)), true, kFree}};
  for (const auto& [name, motion] : {std::pair{"swage, symplectic Euler", kSymplecticEuler},
                                     {"swage, RK4", kRungeKutta4},
                                     {"swage, splitting of order 2", kSplitting2},
                                     {"swage, splitting of order 4", kSplitting4},
                                     {"swage, Taylor series", kTaylor}})
    methods.push_back({name, "swage", with(free(motion)), true, kFree});
  return methods;
}

std::vector<Query> swage_queries(const Needle& needle) {
  auto both = std::make_shared<BothJaws>(needle);
  auto chain = std::make_shared<ChainQuery>(needle);
  return {{"swage, exact arc", "swage", true,
           [both](const Pose& n, const Pose& u, const Pose& l) {
             return gaps_of(*both, {n, {u, l}, Phase::kFar});
           }},
          {"swage, chain of spheres of the thesis", "thesis", false,
           [chain](const Pose& n, const Pose& u, const Pose& l) { return chain->run(n, u, l); }}};
}

}  // namespace swage::bench
