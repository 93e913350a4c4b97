// SPDX-License-Identifier: Apache-2.0
#include "session/knot_copy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "assembly/lesson_file.hpp"
#include "scene/chain.hpp"
#include "session/sentences.hpp"
#include "toolkit/knot/reader.hpp"
#include "toolkit/knot/touch.hpp"

namespace swage::session {

namespace {

using Json = nlohmann::ordered_json;
using base::Severity;
using toolkit::KnotThrow;
using toolkit::Vec3;

// Distance that a pin keeps from every strand, beside its radius and that of the thread [m]. Smaller: a strand that touches a pin from the start on.
constexpr double kClear = 20e-6;
// Steps of the search for a place of the pins [m], and of the direction in which they are drawn [rad].
constexpr double kStep = 50e-6, kTurn = std::numbers::pi / 12;

/// A piece of a thread, from one cut or end to the next, and its knot.
struct Piece {
  uint32_t chain = 0, first = 0, count = 0;  // of vertices
  std::vector<Vec3> p_W;                     // m
  toolkit::KnotName name;
  KnotThrow tied;  // first throw of the knot with the most throws, up to its loop
  int throws = 0;
};

/// The knot with the most throws in the word, as its first throw and their number.
void choose(const toolkit::KnotWord& word, Piece& piece) {
  for (int i = 0; i < word.throws;) {
    int end = i + 1;
    while (end < word.throws && word.tied[static_cast<size_t>(end)].knot == word.tied[static_cast<size_t>(i)].knot) ++end;
    if (end - i > piece.throws) piece.throws = end - i, piece.tied = word.tied[static_cast<size_t>(i)];
    i = end;
  }
}

void read_piece(Piece& piece, double diameter) {
  constexpr int kWork = 100000;  // tests of two pieces in a call; only the number of calls depends on it
  const auto thread = std::make_unique<toolkit::KnotThread>();
  const auto reader = std::make_unique<toolkit::KnotReader>();
  const auto n = static_cast<int>(piece.count);
  if (!thread->begin(piece.p_W.front().data(), n)) return;
  while (!reader->read(*thread, kWork, piece.name)) {}
  if (!piece.name.certain) return;
  choose(piece.name.word, piece);
  if (piece.throws > 0) piece.tied = toolkit::KnotTouch(piece.p_W.front().data(), n, diameter).up_to_loop(piece.tied);
}

/// The piece with the most throws; without any where there is none.
Piece find_knot(const scene::World& world) {
  Piece best;
  for (uint32_t c = 0; c < world.chain.size(); ++c) {
    const scene::ChainView chain(world, world.chain[c]);
    for (uint32_t i = 0; i < chain.vertices();) {
      Piece piece{c, i, 1, {chain.p(i)}, {}, {}, 0};
      while (i + piece.count < chain.vertices() && chain.radius(i + piece.count - 1) > 0) piece.p_W.push_back(chain.p(i + piece.count)), ++piece.count;
      i += piece.count;
      read_piece(piece, 2 * chain.radius(piece.first));
      if (piece.throws > best.throws) best = std::move(piece);
    }
  }
  return best;
}

Vec3 at(const Piece& piece, double place) {
  const auto i = static_cast<size_t>(std::clamp(place, 0.0, piece.count - 2.0));
  return piece.p_W[i] + (place - static_cast<double>(i)) * (piece.p_W[i + 1] - piece.p_W[i]);
}

/// A frame F with the loop about its origin in its plane z = 0, and the pins at +-kPinPlace on its x.
struct Frame {
  Vec3 origin_W = Vec3::Zero();
  Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  Vec3 to(const Vec3& p_W) const {
    const Vec3 r = p_W - origin_W;
    return {x.dot(r), y.dot(r), z.dot(r)};
  }
};

/// Its y towards the knot, so that the pins draw both strands of the loop alike.
Frame frame_of(const Piece& piece, const std::vector<Vec3>& loop) {
  Frame frame;
  Vec3 area = Vec3::Zero(), middle = Vec3::Zero();
  for (const Vec3& p : loop) middle += p / static_cast<double>(loop.size());
  for (size_t i = 0; i < loop.size(); ++i) area += (loop[i] - middle).cross(loop[(i + 1) % loop.size()] - middle);
  const Vec3 knot = 0.5 * (at(piece, piece.tied.strand[0].last) + at(piece, piece.tied.strand[1].first));
  frame.origin_W = middle;
  frame.z = area.normalized();
  frame.y = (knot - middle - frame.z.dot(knot - middle) * frame.z).normalized();
  frame.x = frame.y.cross(frame.z);
  return frame;
}

/// Distance of a point from a segment, both seen along z.
double apart(double px, double py, const Vec3& a, const Vec3& b) {
  const double ex = b.x() - a.x(), ey = b.y() - a.y(), squared = ex * ex + ey * ey;
  const double t = squared > 0 ? std::clamp(((px - a.x()) * ex + (py - a.y()) * ey) / squared, 0.0, 1.0) : 0;
  return std::hypot(px - a.x() - t * ex, py - a.y() - t * ey);
}

/// Whether the loop, seen along z and closed where the knot is, goes about a point.
bool goes_about(const std::vector<Vec3>& loop, double px, double py) {
  double turned = 0;  // rad
  for (size_t i = 0; i < loop.size(); ++i) {
    const Vec3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const double ax = a.x() - px, ay = a.y() - py, bx = b.x() - px, by = b.y() - py;
    turned += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return std::abs(turned) > std::numbers::pi;
}

/// Room of two pins whose middle is at (x, y) in a frame turned by `angle` about z [m]; negative where the loop does not go about both.
double room(const std::vector<Vec3>& line, const std::vector<Vec3>& loop, double x, double y, double angle) {
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {-1.0, 1.0}) {
    const double px = x + side * kPinPlace * std::cos(angle), py = y + side * kPinPlace * std::sin(angle);
    if (!goes_about(loop, px, py)) return -1;
    for (size_t i = 0; i + 1 < line.size(); ++i) least = std::min(least, apart(px, py, line[i], line[i + 1]));
  }
  return least;
}

/// Moves the frame to where the pins have the most room, drawn as near to its x as there is room for them.
bool make_room(const Piece& piece, const std::vector<Vec3>& loop_W, double needed, Frame& frame) {
  std::vector<Vec3> line, loop;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& p : piece.p_W) line.push_back(frame.to(p));
  for (const Vec3& p : loop_W) loop.push_back(frame.to(p)), low = low.cwiseMin(loop.back()), high = high.cwiseMax(loop.back());
  for (int turn = 0; turn <= 6; ++turn)
    for (const double angle : {turn * kTurn, -turn * kTurn}) {
      double best = needed, best_x = 0, best_y = 0;
      for (double x = low.x(); x <= high.x(); x += kStep)
        for (double y = low.y(); y <= high.y(); y += kStep)
          if (const double r = room(line, loop, x, y, angle); r > best) best = r, best_x = x, best_y = y;
      if (best <= needed) continue;
      frame.origin_W += best_x * frame.x + best_y * frame.y;
      const Vec3 x = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
      frame.y = frame.z.cross(x), frame.x = x;
      return true;
    }
  return false;
}

std::string word_of(const Piece& piece) {
  std::string out;
  const auto& word = piece.name.word;
  for (int i = 0; i < word.throws; ++i) {
    const KnotThrow& t = word.tied[static_cast<size_t>(i)];
    if (t.knot == piece.tied.knot) out += (out.empty() ? "" : " ") + std::to_string(t.sign * t.turns);
  }
  return out;
}

std::string millimetres(double m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7f mm", 1e3 * m);
  return text;
}

std::string path_of(const Piece& piece, const Frame& frame) {
  std::string text;
  for (const Vec3& p_W : piece.p_W) {
    char point[96];
    const Vec3 p = 1e3 * frame.to(p_W);
    std::snprintf(point, sizeof point, "%s%.7f %.7f %.7f", text.empty() ? "" : ", ", p.x(), p.y(), p.z());
    text += point;
  }
  return text + " mm";
}

/// The object that has the chain.
uint32_t object_of(const scene::World& world, uint32_t chain) {
  for (const scene::Shape& shape : world.shape)
    if (shape.chain == chain) return shape.object;
  return scene::kNone;
}

/// The thread's own parameters, but for where it starts; files by their absolute paths: lesson 139 may lie elsewhere.
void copy_params(const host::Rig& rig, const Json& params, KnotCopy& out) {
  static const std::set<std::string> kStart = {"start", "path", "paths", "shape", "coil_radius", "first", "last", "length", "segments"};
  for (const auto& [key, value] : params.items()) {
    if (kStart.count(key) > 0) continue;
    std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    for (const host::GivenFile& file : rig.files)
      if (file.written == text) text = std::filesystem::absolute(file.path).string();
    out.settings.push_back("knot." + key + "=" + text);
  }
}

/// How the thread touches itself in the attempt.
void copy_contact(const assembly::LessonFile& file, KnotCopy& out) {
  for (const assembly::LessonCoupling& coupling : file.couplings) {
    if (coupling.plugin != "swage.coupling.contact" || coupling.a != out.thread || coupling.b != out.thread) continue;
    const Json params = Json::parse(coupling.params, nullptr, false);
    for (const char* key : {"friction", "stiffness"})
      if (params.contains(key)) out.settings.push_back("itself." + std::string(key) + "=" + (params[key].is_string() ? params[key].get<std::string>() : params[key].dump()));
    if (params.contains("friction") && params["friction"].is_number()) out.friction = params["friction"].get<double>();
  }
}

bool refuse(const host::Rig& rig, const std::string& why, base::Problems& problems) {
  problems.push_back({Severity::kError, rig.descriptor_path, why});
  return false;
}

}  // namespace

bool copy_knot(const host::Rig& rig, const scene::World& world, KnotCopy& out, base::Problems& problems) {
  Piece piece = find_knot(world);
  if (piece.throws == 0) return refuse(rig, say::kNoKnot(), problems);
  const scene::ChainView chain(world, world.chain[piece.chain]);
  const auto loop_begin = static_cast<size_t>(std::ceil(piece.tied.strand[0].last)), loop_end = static_cast<size_t>(std::floor(piece.tied.strand[1].first));
  std::vector<Vec3> loop;
  for (size_t i = loop_begin; i <= loop_end; ++i) loop.push_back(piece.p_W[i]);
  Frame frame;
  if (loop.size() > 3) frame = frame_of(piece, loop);
  if (loop.size() <= 3 || !make_room(piece, loop, kPinRadius + chain.radius(piece.first) + kClear, frame)) return refuse(rig, say::kNoRoom(), problems);

  assembly::LessonFile file;
  if (!assembly::parse_lesson(rig.descriptor_text, rig.descriptor_path, file, problems)) return false;
  const uint32_t object = object_of(world, piece.chain);
  if (object >= file.objects.size()) return refuse(rig, say::kNoKnot(), problems);
  const Json params = Json::parse(file.objects[object].params, nullptr, false);
  const bool whole = piece.count == chain.vertices();
  if (!whole && params.contains("finer")) return refuse(rig, say::kFinerAndCut(), problems);

  out.thread = file.objects[object].name;
  out.word = word_of(piece);
  const auto arc = [&](double place) {
    const auto i = static_cast<uint32_t>(place);
    const double s = chain.s(piece.first + i), next = chain.s(std::min(piece.first + i + 1, piece.first + piece.count - 1));
    return s + (place - i) * (next - s) - chain.s(piece.first);
  };
  const double from = arc(piece.tied.strand[0].last), to = arc(piece.tied.strand[1].first);
  out.loop = to - from;
  copy_params(rig, params, out);
  copy_contact(file, out);
  const double length = chain.s(piece.first + piece.count - 1) - chain.s(piece.first);
  for (const char* one : {"knot.paths=", "knot.shape=0", "knot.start=nodes"}) out.settings.emplace_back(one);
  out.settings.push_back("knot.length=" + millimetres(length));
  out.settings.push_back("knot.segments=" + std::to_string(piece.count - 1));
  out.settings.push_back("knot.path=" + path_of(piece, frame));
  out.settings.push_back("lesson.from=" + millimetres(from));
  out.settings.push_back("lesson.to=" + millimetres(to));
  return true;
}

}  // namespace swage::session
