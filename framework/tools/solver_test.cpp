// SPDX-License-Identifier: Apache-2.0
//
// Test of the contracts of swage.object.solver/1 and /2 (abi/object.h) and of swage.object.band/1 (abi/band.h), by the tables alone.
#include <swage/abi/band.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "base/rng.hpp"
#include "host/services.hpp"
#include "host/tables.hpp"
#include "scene/chain.hpp"
#include "scene/view.hpp"
#include "toolkit/math.hpp"
#include "tools/band_test.hpp"
#include "tools/extension_tests.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using host::Finding;
using host::Mark;
using toolkit::Pose;
using toolkit::Vec3;
using Points = SolverPoints;
using Answer = SolverAnswer;
using Matrix = SolverAnswer::Matrix;
using Vector = Eigen::VectorXd;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
// relative to the largest entry of W. Rounding of a good solver stays below 1e-12
constexpr double kExact = 1e-9;
// relative to the change that the impulses make; small angles in a solver's equations leave 1e-6
constexpr double kMotion = 1e-3;
class Solver {
 public:
  Solver(Stepped& scene, uint32_t object, uint64_t seed)
      : slot_(scene.rig->objects[object]), world_(scene.rig->world), random_(seed) {
    for (uint32_t i = 0; i < slot_.body.count; ++i) moves_ |= motion(i) == SWAGE_MOTION_FLEXIBLE;
  }
  /// Whether the object has a solver and a body that it moves.
  bool moves() const { return (slot_.solver != nullptr || slot_.solver_2 != nullptr) && moves_; }

  /// "" or the fault, at the present poses.
  std::string check() {
    const auto advance = slot_.solver_2 != nullptr ? slot_.solver_2->advance : slot_.solver->advance;
    if (std::string wrong = call(host::Call::kAdvance, [&] { return advance(raw(), &view()); }); !wrong.empty())
      return wrong;
    const Points points = surface_points();
    if (points.empty()) return "";
    Answer all, again;
    if (std::string wrong = ask(points, all); !wrong.empty()) return wrong;
    if (std::string wrong = ask(points, again); !wrong.empty()) return wrong;
    if (!(all == again)) return say::kOtherBits("mobility");
    if (std::string wrong = matrix(all.W); !wrong.empty()) return wrong;
    if (std::string wrong = part(points, all); !wrong.empty()) return wrong;
    if (std::string wrong = surface(points); !wrong.empty()) return wrong;
    if (std::string wrong = band(points, all); !wrong.empty()) return wrong;
    return motion_after(points, all);
  }
  const std::string& note() const { return note_; }

 private:
  swage_instance* raw() const { return slot_.instance->raw; }
  int32_t motion(uint32_t body) const { return world_.body[slot_.body.first + body].motion; }
  const swage_object_step& view() {
    view_ = scene::view(world_, {slot_.body, slot_.particle, slot_.shape, slot_.hinge, slot_.state, slot_.signal}, &input_);
    return view_;
  }
  template <class F>
  std::string call(host::Call which, F&& f) {
    const host::ScopedRole rt(SWAGE_THREAD_RT);
    host::guarded(*slot_.instance, which, world_.step, f);
    return slot_.instance->quarantined.load() != 0 ? host::quarantine_text(*slot_.instance) : "";
  }

  std::string mobility(const Points& p, double* v_free, double* W) {
    return call(host::Call::kMobility, [&] {
      if (slot_.solver_2 != nullptr)
        return slot_.solver_2->mobility(raw(), &view(), p.size(), p.point.data(), p.place.data(), v_free, W);
      return slot_.solver->mobility(raw(), &view(), p.size(), p.point.data(), v_free, W);
    });
  }
  std::string apply_impulses(const Points& p, const Vector& j) {
    return call(host::Call::kApplyImpulses, [&] {
      if (slot_.solver_2 != nullptr)
        return slot_.solver_2->apply_impulses(raw(), &view(), p.size(), p.point.data(), p.place.data(), j.data());
      return slot_.solver->apply_impulses(raw(), &view(), p.size(), p.point.data(), j.data());
    });
  }

  std::string ask(const Points& points, Answer& out) {
    const uint32_t n = points.size();
    out.v_free = Vector::Constant(3 * n, kNan);
    out.W = Matrix::Constant(3 * n, 3 * n, kNan);
    if (std::string wrong = mobility(points, out.v_free.data(), out.W.data()); !wrong.empty())
      return wrong;
    if (out.v_free.allFinite() && out.W.allFinite()) return "";
    return say::kUnwritten(n);
  }

  static std::string matrix(const Matrix& W) {
    const double size = W.cwiseAbs().maxCoeff();
    const double skew = (W - W.transpose()).cwiseAbs().maxCoeff();
    if (skew > kExact * size)
      return say::kSkew(format("%.3g", skew), format("%.3g", size));
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(W)).eigenvalues().minCoeff();
    if (least < -kExact * size)
      return say::kPulls(format("%.3g", least), format("%.3g", size));
    return "";
  }

  // compares a part of the points with the same rows of all points
  std::string part(const Points& points, const Answer& all) {
    Points few = points;
    few.point.resize((points.size() + 1) / 2);
    few.place.resize(few.point.size());
    Answer some;
    if (std::string wrong = ask(few, some); !wrong.empty()) return wrong;
    const auto n = static_cast<Eigen::Index>(3 * few.size());
    const double size = all.W.cwiseAbs().maxCoeff(), speed = std::max(all.v_free.cwiseAbs().maxCoeff(), 1e-12);
    if ((some.W - all.W.topLeftCorner(n, n)).cwiseAbs().maxCoeff() > kExact * size ||
        (some.v_free - all.v_free.head(n)).cwiseAbs().maxCoeff() > kExact * speed)
      return say::kPart();
    return "";
  }

  std::string band(const Points& points, const Answer& all) {
    std::string gap;
    const auto* table = host::find_table<swage_band>(*slot_.instance, SWAGE_EXT_BAND, false, gap);
    if (table == nullptr) return gap;
    if (points.place.front().segment == SWAGE_NONE) return say::kBandNoChain(SWAGE_EXT_BAND);
    const uint32_t chain = world_.shape[slot_.shape.first + points.point.front().shape].chain;
    BandAsk ask{*table, world_, chain, points, all, random_(), [this] { return raw(); }, [this] { return &view(); },
                [this](host::Call which, const std::function<swage_result()>& f) { return call(which, f); }};
    return check_band(ask);
  }

  std::string surface(const Points& points) {
    if (slot_.surface == nullptr) return "";
    const uint32_t n = points.size();
    Vector u[2];
    for (Vector& one : u) {
      one = Vector::Constant(3 * n, kNan);
      if (std::string wrong = call(host::Call::kDisplacement,
                                   [&] { return slot_.surface->displacement(raw(), &view(), n, points.point.data(), one.data()); });
          !wrong.empty())
        return wrong;
      if (!one.allFinite()) return say::kSurfaceUnwritten();
    }
    return u[0] == u[1] ? "" : say::kOtherBits("displacement");
  }

  // velocities of the points after the impulses `j`, from the present state, which is restored
  std::string after(const Points& points, const Vector& j, Vector& v) {
    const scene::World saved = world_;
    Answer ignored;
    std::string wrong = ask(points, ignored);
    if (wrong.empty()) wrong = apply_impulses(points, j);
    v = Vector::Zero(j.size());
    for (uint32_t i = 0; i < points.size(); ++i)
      v.segment<3>(3 * static_cast<Eigen::Index>(i)) = velocity(points, i, saved);
    world_ = saved;
    if (wrong.empty() && !v.allFinite()) wrong = say::kImpulsesNotFinite();
    return wrong;
  }

  /// Velocity of a point as the solver wrote it; `before`: the state in which contacts were found, which gives the lever arms.
  Vec3 velocity(const Points& points, uint32_t i, const scene::World& before) const {
    const uint32_t b = slot_.body.first + points.point[i].body;
    if (const swage_chain_place& at = points.place[i]; at.segment != SWAGE_NONE) {
      const scene::ChainView chain(world_, world_.chain[world_.shape[slot_.shape.first + points.point[i].shape].chain]);
      return (1 - at.share) * chain.v(at.segment) + at.share * chain.v(at.segment + 1);
    }
    const Vec3 r = toolkit::vec(points.point[i].p_W) - toolkit::vec(before.X_WB[b].p);
    return toolkit::vec(world_.V_WB[b].v) + toolkit::vec(world_.V_WB[b].w).cross(r);
  }

  std::string motion_after(const Points& points, const Answer& all) {
    const auto n = static_cast<Eigen::Index>(3 * points.size());
    const double size = all.W.cwiseAbs().maxCoeff();
    // impulses that change velocities by about 1 mm/s: nothing yields at that
    Vector j(n), without, with;
    for (Eigen::Index i = 0; i < n; ++i) j[i] = 1e-3 / (size * static_cast<double>(n)) * random_.uniform(-1, 1);
    if (std::string wrong = after(points, Vector::Zero(n), without); !wrong.empty()) return wrong;
    if (std::string wrong = after(points, j, with); !wrong.empty()) return wrong;
    const Vector change = all.W * j;
    const double whole = change.cwiseAbs().maxCoeff(), off = (with - without - change).cwiseAbs().maxCoeff();
    // a surface may move while its body is at rest, as that of tissue; no table gives its velocity, so nothing is compared
    if (slot_.surface != nullptr && (with - without).cwiseAbs().maxCoeff() < 1e-3 * whole) {
      note_ = say::kNotCompared();
      return "";
    }
    if (off > kMotion * whole)
      return say::kImpulsesOff(format("%.3g", off), format("%.3g", whole));
    const double slip = (without - all.v_free).cwiseAbs().maxCoeff();
    if (slip > kMotion * std::max(all.v_free.cwiseAbs().maxCoeff(), whole))
      return say::kImpulsesSlip(format("%.3g", slip));
    return "";
  }

  // random places on the colliding surfaces
  Points surface_points() {
    constexpr std::size_t kMost = 12;
    Points out;
    std::vector<uint32_t> shapes;
    for (uint32_t i = 0; i < slot_.shape.count; ++i) {
      const scene::Shape& s = world_.shape[slot_.shape.first + i];
      if ((s.flags & SWAGE_SHAPE_COLLIDES) != 0 && world_.body[s.body].motion == SWAGE_MOTION_FLEXIBLE) shapes.push_back(i);
    }
    for (std::size_t k = 0; k < kMost && !shapes.empty(); ++k) {
      const uint32_t i = shapes[random_() % shapes.size()];
      const scene::Shape& shape = world_.shape[slot_.shape.first + i];
      if (shape.kind == SWAGE_SHAPE_CHAIN) {
        on_chain(shape, i, out);
        continue;
      }
      out.point.push_back(on(shape, i));
      out.place.push_back({SWAGE_NONE, 0, 0, 0});
    }
    return out;
  }

  // on the centre line, because no table gives the rotation of a piece about its own axis
  void on_chain(const scene::Shape& s, uint32_t index, Points& out) {
    const scene::ChainView chain(world_, world_.chain[s.chain]);
    const auto i = static_cast<uint32_t>(random_() % chain.segments());
    const double share = random_.uniform();
    const Vec3 p = (1 - share) * chain.p(i) + share * chain.p(i + 1);
    out.point.push_back({s.body - slot_.body.first, index, toolkit::raw(p), {0, 0, 1}});
    out.place.push_back({i, 0, share, (1 - share) * chain.s(i) + share * chain.s(i + 1)});
  }

  swage_contact_point on(const scene::Shape& s, uint32_t index) {
    Vec3 out_S(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1));
    if (out_S.norm() < 0.1) out_S = Vec3::UnitX();
    out_S.normalize();
    Vec3 p_S = s.radius * out_S;
    if (s.kind == SWAGE_SHAPE_CAPSULE || s.kind == SWAGE_SHAPE_CYLINDER) p_S.z() += s.half_length * random_.uniform(-1, 1);
    if (s.kind == SWAGE_SHAPE_ARC) {
      const double angle = s.sweep * random_.uniform();
      p_S += s.arc_radius * Vec3(std::cos(angle), std::sin(angle), 0);
    }
    if (s.kind == SWAGE_SHAPE_CONVEX) {
      const auto& vertex = world_.convex[s.convex].vertex;
      p_S = vertex[random_() % vertex.size()];
      out_S = p_S.normalized();
    }
    if (s.kind == SWAGE_SHAPE_HEIGHT_FIELD) {
      const scene::HeightFieldInfo& f = world_.field[s.field];
      const uint32_t i = static_cast<uint32_t>(random_() % f.nx), j = static_cast<uint32_t>(random_() % f.ny);
      p_S = {i * f.dx, j * f.dy, f.height[j * f.nx + i]};
      out_S = Vec3::UnitZ();
    }
    const Pose X_WS = Pose(world_.X_WB[s.body]) * Pose(s.X_BS);
    return {s.body - slot_.body.first, index, toolkit::raw(Vec3(X_WS * p_S)), toolkit::raw(Vec3(-(X_WS.q * out_S)))};
  }

  host::ObjectSlot& slot_;
  scene::World& world_;
  base::Xoshiro256 random_;
  swage_object_step view_{};
  swage_input input_{{{0, 0, 0}, {1, 0, 0, 0}}, 0, 0, 0, 0};
  bool moves_ = false;
  std::string note_;
};

}  // namespace

Finding solver(const TestScene& scene, uint64_t seed) {
  bool moved = false;
  std::string note;
  for (const std::string& params : ways_of(scene.plugin().params)) {
    Stepped s;
    std::string error;
    Wish wish;
    wish.params = params;
    if (!scene.make(wish, s, error)) continue;  // test "range" covers parameters that are refused
    const uint32_t subject = scene.subject(wish);
    Solver solver(s, subject, seed);
    for (int round = 0; round < 5; ++round) {
      std::string wrong = s.run(7);
      if (wrong.empty() && solver.moves()) wrong = solver.check();
      if (!wrong.empty()) return {Mark::kFailed, wrong + (params == "{}" ? "" : say::kParameters(params))};
    }
    moved |= solver.moves();
    if (!solver.note().empty()) note = solver.note();
  }
  if (!moved) return {Mark::kSkipped, say::kNoSolver()};
  return {Mark::kSuccess, note};
}

}  // namespace swage::tools
