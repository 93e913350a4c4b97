// SPDX-License-Identifier: Apache-2.0
//
// Displacement of the surface, levels compliant and mesh: u = C (f + v), f the forces of this step, v the creep
// memory of earlier ones. C is of the half space or of the mesh; all else is common to both.
#include <swage/plugin.hpp>

#include <algorithm>
#include <cmath>

#include "tissue.hpp"

namespace swage::tissue {

using toolkit::Frame;
using toolkit::Pose;
using toolkit::raw;
using toolkit::vec;

namespace {

// Share of the spread: forces nearer to each other than this act at one place.
constexpr double kMerge = 0.25;
// N: a creep memory below this is dropped, as it displaces by less than a nanometre.
constexpr double kForgotten = 1e-9;

Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }
void put(double* to, const Vec3& a) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}
bool zero(const double* a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
bool same(const double* a, const double* b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }
bool same(const swage_vec3& a, const swage_vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
/// Place of a source: of its force, or without one of its creep memory.
Vec3 place_of(const Source& s) { return vec3(zero(s.f) ? s.p : s.q); }

/// Vector from b to a on the surface laid flat: distances along x grow with the slope there.
struct Way {
  double x, y;
  Way(const Vec3& a, const double* b) : x(a.x() - b[0]), y(a.y() - b[1]) {
    const double dz = a.z() - b[2];
    if (dz != 0) x = std::copysign(std::sqrt(x * x + dz * dz), x);
  }
};

/// A C B', computed column by column.
Mat3 turned(const Mat3& A, const Mat3& C, const Mat3& B) {
  Mat3 AC, out;
  for (int j = 0; j < 3; ++j) AC.col(j) = C(0, j) * A.col(0) + C(1, j) * A.col(1) + C(2, j) * A.col(2);
  for (int j = 0; j < 3; ++j) out.col(j) = B(j, 0) * AC.col(0) + B(j, 1) * AC.col(1) + B(j, 2) * AC.col(2);
  return out;
}

}  // namespace

const Frame& Tissue::frame(const Step& step) {
  const Pose X_WO(step.pose(body_));
  Asked& a = asked_;
  if (X_WO.p != a.X_WO.p || X_WO.q.coeffs() != a.X_WO.q.coeffs())
    a.n = 0, a.X_WO = X_WO, a.F_WO = Frame(X_WO);
  return a.F_WO;
}

Tissue::Spot Tissue::spot(const Frame& X_WO, const Vec3& foot_O) const {
  Spot s;
  s.foot_O = foot_O;
  const Vec3 n = wall_.normal(foot_O.x(), foot_O.y());
  const Vec3 along = Vec3(n.z(), 0, -n.x()).normalized();
  s.axes_W.col(0) = X_WO.turn(n);
  s.axes_W.col(1) = X_WO.turn(along);
  s.axes_W.col(2) = X_WO.turn(n.cross(along));
  return s;
}

/// Finds the spots of points, at the same index in asked_; returns their number.
uint32_t Tissue::look_up(const Step& step, std::span<const swage_contact_point> points) {
  Asked& a = asked_;
  const Frame& X_WO = frame(step);
  const auto n = static_cast<uint32_t>(std::min<size_t>(points.size(), kPoints));
  for (uint32_t i = 0; i < n; ++i) {
    if (i < a.n && same(a.p_W[i], points[i].p_W)) continue;
    a.p_W[i] = points[i].p_W;
    a.spot[i] = spot(X_WO, wall_.locate(X_WO.inverse_times(vec(points[i].p_W))).foot);
    if (params_.level == Level::kMesh) a.place[i] = place(a.spot[i].foot_O);
    a.related[i] = a.felt[i] = false;
  }
  return a.n = n;
}

/// Computes the displacement per force between all points, in W.
void Tissue::relate(uint32_t n) {
  Asked& a = asked_;
  if (std::all_of(a.related.begin(), a.related.begin() + n, [](bool yes) { return yes; })) return;
  const bool mesh = params_.level == Level::kMesh;
  if (mesh) mesh_.responses({a.place.data(), n}, a.response.data());
  for (uint32_t i = 0; i < n; ++i)
    for (uint32_t j = 0; j <= i; ++j) {
      if (a.related[i] && a.related[j]) continue;
      const Way way(a.spot[i].foot_O, a.spot[j].foot_O.data());
      const Mat3 C = mesh ? a.response[size_t{i} * n + j] : compliance_.between(way.x, way.y);
      a.C_W[size_t{i} * kPoints + j] = turned(a.spot[i].axes_W, C, a.spot[j].axes_W);
    }
  std::fill_n(a.related.begin(), n, true);
}

/// Computes the displacement of all points: by creep memory, and by the forces of the step before.
void Tissue::feel(const State& state, uint32_t n) {
  Asked& a = asked_;
  if (params_.level == Level::kMesh) return feel_mesh(state, n);
  std::fill_n(a.creep.begin(), n, Vec3::Zero());
  std::fill_n(a.gone.begin(), n, Vec3::Zero());
  for (const Source& s : state.source) {
    const bool creeps = !zero(s.v), bore = !zero(s.w), stayed = same(s.p, s.q_old);
    if (!creeps && !bore) continue;
    const Vec3 v = vec3(s.v), w = vec3(s.w);
    for (uint32_t i = 0; i < n; ++i) {
      const Way from_p(a.spot[i].foot_O, s.p);
      const Compliance::Give give = compliance_.give(from_p.x, from_p.y);
      if (creeps) a.creep[i] += give.of(from_p.x, from_p.y, v);
      if (!bore) continue;
      const Way from_q(a.spot[i].foot_O, s.q_old);
      a.gone[i] += (stayed ? give : compliance_.give(from_q.x, from_q.y)).of(from_q.x, from_q.y, w);
    }
  }
}

void Tissue::feel_mesh(const State& state, uint32_t n) {
  Asked& a = asked_;
  const auto loaded = [&](auto&& place_p, auto&& force) {
    a.load.clear();
    for (const Source& s : state.source)
      if (!zero(force(s))) a.load.push_back({place(vec3(place_p(s))), vec3(force(s))});
  };
  loaded([](const Source& s) { return s.p; }, [](const Source& s) { return s.v; });
  mesh_.displace({a.place.data(), n}, a.load, a.creep.data());
  loaded([](const Source& s) { return s.q_old; }, [](const Source& s) { return s.w; });
  mesh_.displace({a.place.data(), n}, a.load, a.gone.data());
}

void Tissue::advance(const Step& step) {
  if (!yields()) return;
  creep_in(step.dt());
  asked_.felt.fill(false);
  for (Source& s : step.state<State>().source)
    for (int i = 0; i < 3; ++i) {
      s.q_old[i] = s.q[i], s.w[i] = s.f[i];
      s.v[i] *= creep_.keep;
      s.f[i] = 0;
    }
  if (!edges_.move()) return;
  SlitState& slit = step.state<SlitState>();
  slit.w = slit.f, slit.f = {};
}

/// u = C (f + v): without new forces the surface moves over the step by C (v - v / keep) - C w.
void Tissue::mobility(const Step& step, std::span<const swage_contact_point> points, double* v_free,
                        double* W) {
  const uint32_t n = look_up(step, points);
  relate(n);
  feel(step.state<State>(), n);
  std::fill_n(asked_.felt.begin(), n, true);
  const double h = step.dt(), give = creep_.at_once() / (h * h), faded = (1 - 1 / creep_.keep) / h;
  const size_t stride = 3 * points.size();
  for (uint32_t i = 0; i < n; ++i) {
    const Vec3 v = faded * asked_.creep[i] - asked_.gone[i] / h;
    put(v_free + size_t{3} * i, asked_.spot[i].axes_W * v);
    for (uint32_t j = 0; j <= i; ++j) {
      const double* const C = asked_.C_W[size_t{i} * kPoints + j].data();  // by columns
      for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 3; ++c)
          W[(size_t{3} * i + r) * stride + size_t{3} * j + c] =
              W[(size_t{3} * j + c) * stride + size_t{3} * i + r] = give * C[3 * c + r];
    }
  }
  if (edges_.move()) add_edges(step, n, stride, v_free, W);
}

/// Adds the motion of the edges: all of a half moves with its edge. Linearised about the forces of the step before.
void Tissue::add_edges(const Step& step, uint32_t n, size_t stride, double* v_free, double* W) {
  const SlitEdges::Pair& w = step.state<SlitState>().w;
  const SlitEdges::Pair is = edges_.displaced(w), free = edges_.without(w);
  const bool meeting = edges_.meet(w);
  const double h = step.dt();
  const Vec3 x_W = asked_.F_WO.turn(Vec3::UnitX());
  for (size_t i = 0; i < n; ++i) {
    const size_t a = half(asked_.spot[i]);
    const Vec3 v = (free[a] - is[a]) / h * x_W;
    for (size_t r = 0; r < 3; ++r) v_free[3 * i + r] += v[static_cast<Eigen::Index>(r)];
    for (size_t j = 0; j < n; ++j) {
      const Mat3 give = edges_.between(a, half(asked_.spot[j]), meeting) / (h * h) * x_W * x_W.transpose();
      for (size_t r = 0; r < 3; ++r)
        for (size_t c = 0; c < 3; ++c)
          W[(3 * i + r) * stride + 3 * j + c] += give(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
    }
  }
}

void Tissue::displacement(const Step& step, std::span<const swage_contact_point> points, double* u_W) {
  const uint32_t n = look_up(step, points);
  const State& state = step.state<State>();
  for (uint32_t i = 0; i < n; ++i) {
    const Spot& at = asked_.spot[i];
    Vec3 u_W_i = at.axes_W * (asked_.felt[i] ? asked_.creep[i] : displaced(state, at.foot_O));
    if (edges_.move()) {
      const SlitState& slit = step.state<SlitState>();
      const SlitEdges::Pair x = asked_.felt[i] ? edges_.without(slit.w) : edges_.displaced(slit.f);
      u_W_i += x[half(at)] * asked_.F_WO.turn(Vec3::UnitX());
    }
    put(u_W + size_t{3} * i, u_W_i);
  }
}

/// The source for a force at a place, without a force yet in this step: the nearest one, or the one with the smallest
/// displacement. `size`: square of the forces by which each displaces, N2.
uint32_t Tissue::source_at(State& state, const std::array<double, kSources>& size, const Vec3& foot_O) const {
  const double merge = kMerge * params_.spread;
  uint32_t least = 0, nearest = kSources;
  double near = merge * merge;  // m2
  for (uint32_t i = 0; i < kSources; ++i) {
    const Source& s = state.source[i];
    if (size[i] < size[least]) least = i;
    if (!(size[i] > 0) || !zero(s.f)) continue;
    const double distance = (vec3(s.p) - foot_O).squaredNorm();
    if (distance < near) nearest = i, near = distance;
  }
  if (nearest < kSources) return nearest;
  state.source[least] = {};
  put(state.source[least].p, foot_O);
  return least;
}

void Tissue::apply_impulses(const Step& step, std::span<const swage_contact_point> points, const double* impulse) {
  const uint32_t n = look_up(step, points);
  asked_.felt.fill(false);
  State& state = step.state<State>();
  std::array<double, kSources> size;
  const auto measure = [&](uint32_t i) {
    size[i] = (vec3(state.source[i].f) + vec3(state.source[i].v)).squaredNorm();
  };
  for (uint32_t i = 0; i < kSources; ++i) measure(i);
  for (uint32_t i = 0; i < n; ++i) {
    const Vec3 f_W = vec3(impulse + size_t{3} * i) / step.dt();
    if (f_W.isZero(0)) continue;
    const Spot& at = asked_.spot[i];
    const uint32_t to = source_at(state, size, at.foot_O);
    Source& s = state.source[to];
    put(s.q, at.foot_O);
    put(s.f, at.axes_W.transpose() * f_W);
    measure(to);
    if (edges_.move()) step.state<SlitState>().f[half(at)] += f_W.dot(asked_.F_WO.turn(Vec3::UnitX()));
  }
  for (Source& s : state.source) put(s.v, vec3(s.v) + creep_.gain * vec3(s.f));
}

/// Displacement of a place of the surface [m, along n, 1, 2].
Vec3 Tissue::displaced(const State& state, const Vec3& foot_O) {
  Vec3 u = Vec3::Zero();
  if (params_.level == Level::kMesh) {
    const Mesh::Place at = place(foot_O);
    asked_.load.clear();
    for (const Source& s : state.source) {
      if (!zero(s.v)) asked_.load.push_back({place(vec3(s.p)), vec3(s.v)});
      if (!zero(s.f)) asked_.load.push_back({place(vec3(s.q)), vec3(s.f)});
    }
    mesh_.displace({&at, 1}, asked_.load, &u);
    return u;
  }
  const auto add = [&](const double* p, const double* f) {
    if (zero(f)) return;
    const Way way(foot_O, p);
    u += compliance_.give(way.x, way.y).of(way.x, way.y, vec3(f));
  };
  for (const Source& s : state.source) add(s.p, s.v), add(s.q, s.f);
  return u;
}

void Tissue::finish(const Step& step) {
  double dimple = 0, force = 0;
  if (yields()) {
    State& state = step.state<State>();
    const Source* deepest = nullptr;
    double most = 0;
    for (Source& s : state.source) {
      if (zero(s.f) && zero(s.v)) continue;
      const double size = (vec3(s.f) + vec3(s.v)).squaredNorm();
      if (zero(s.f) && size < kForgotten * kForgotten) s = {};
      force += std::max(0.0, -s.f[0]);
      if (size > most) deepest = &s, most = size;
    }
    if (most > 0) dimple = displaced(state, place_of(*deepest)).norm();
  }
  step.signal(dimple_, dimple);
  step.signal(force_, force);
  if (edges_.move()) step.signal(gap_, edges_.gap(step.state<SlitState>().f));
  if (mounted()) step.signal(shift_, kMountArm * step.hinge_angle(mount_));
}

/// Compliance of a place for a force at the same place.
Mat3 Tissue::own(const Vec3& foot_O) const {
  if (params_.level != Level::kMesh) return compliance_.between(0, 0);
  const Mesh::Place at = place(foot_O);
  return mesh_.between(at, at);
}

void Tissue::draw(const Step& step, Visuals& out) {
  if (!yields()) return;
  const Frame& X_WO = frame(step);
  for (const Source& s : step.state<State>().source) {
    const Vec3 amplitude = vec3(s.f) + vec3(s.v);
    if (amplitude.norm() < 1e3 * kForgotten) continue;
    const Spot at = spot(X_WO, place_of(s));
    const Vec3 rest_W = X_WO * at.foot_O;
    out.dent(raw(rest_W), raw(Vec3(rest_W + at.axes_W * (own(at.foot_O) * amplitude))), 2 * params_.spread / 3.141592653589793);
  }
}

}  // namespace swage::tissue
