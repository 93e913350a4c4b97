// SPDX-License-Identifier: Apache-2.0
//
// A strand with one fault, the value of its parameter `fault`: what only the validator finds. A straight piece of 10 mm along x, fixed in
// space, that can be cut once.
#include <swage/cut.hpp>
#include <swage/object.hpp>
#include <swage/strand.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace {

enum Fault { kGood, kNoRadius, kElsewhere, kOutside, kTilted, kNoTension, kUnsteady, kNoBody, kOneNode, kOtherLine, kBeyondLine, kWhole, kFaults };

constexpr double kLength = 10e-3, kNoNumber = std::numeric_limits<double>::quiet_NaN();  // m

struct Params {
  int fault = kGood;
};
struct State {
  double cut;  // m, arc length; below 0: whole
};

class Strand final : public swage::Object<Params>, public swage::Solid, public swage::Strand, public swage::StrandNodes,
                     public swage::StrandLine, public swage::Cuttable {
 public:
  static constexpr auto id = "org.example.bad.strand", version = "1.0.0", name = "Stiff strand", summary = "A strand with a fault.",
                        author = "Swage", licence = "Apache-2.0";
  static constexpr std::array fields{swage::integer<&Params::fault>("fault", "Fault", 0, kFaults - 1, "Which one; 0 is none.")};
  static constexpr std::array traits{SWAGE_TRAIT_STRAND, SWAGE_TRAIT_STRAND_NODES, SWAGE_TRAIT_STRAND_LINE, SWAGE_TRAIT_CUTTABLE};

  void build(const Params&, Builder& b) override {
    body_ = b.fixed_body("strand");
    b.capsule(body_, {0, 0, 0}, {kLength, 0, 0}, 25e-6);
    b.state<State>();
  }
  void reset(const swage::Step& step) override { step.state<State>().cut = -1; }
  const void* extension(std::string_view wanted) override {
    if (wanted == SWAGE_TRAIT_STRAND) return swage::strand_table<Strand>();
    if (wanted == SWAGE_TRAIT_STRAND_NODES) return swage::strand_nodes_table<Strand>();
    if (wanted == SWAGE_TRAIT_STRAND_LINE) return swage::strand_line_table<Strand>();
    return wanted == SWAGE_TRAIT_CUTTABLE ? swage::cuttable_table<Strand>() : nullptr;
  }

  void strand_law(const swage::Step&, swage_strand_law& out) override { out = {kLength, is(kNoRadius) ? 0 : 25e-6, 1, 1}; }
  void strand_place(const swage::Step& step, double s, swage_strand_place& out) override {
    s = std::clamp(s, 0.0, kLength);
    const swage_vec3& p = step.pose(body_).p;
    const double cut = step.state<State>().cut;
    out = {};
    out.s = is(kElsewhere) ? 0.5 * kLength : s;
    out.tension = is(kNoTension) ? kNoNumber : is(kUnsteady) ? 1e-6 * ++asked_ : 0;
    out.p_W = {p.x + s, p.y, p.z};
    out.tangent_W = {1, 0, 0}, out.normal_W = {is(kTilted) ? 0.1 : 0.0, 1, 0};
    out.body = is(kNoBody) ? 1 : 0;
    out.parted = cut >= 0 && std::abs(s - cut) < 0.1e-3;
  }
  void strand_nearest(const swage::Step& step, swage_vec3 p_W, swage_strand_place& out) override {
    strand_place(step, p_W.x - step.pose(body_).p.x, out);
    if (is(kOutside)) out.s += kLength;
  }
  uint32_t strand_nodes(const swage::Step&) override { return is(kOneNode) ? 1 : 2; }
  void strand_line(const swage::Step& step, std::span<double> p_W, std::span<uint32_t> parted) override {
    const size_t n = parted.size();
    for (size_t i = 0; i < n; ++i) {
      swage_strand_place place;
      strand_place(step, kLength * static_cast<double>(i) / static_cast<double>(n - 1), place);
      p_W[3 * i] = place.p_W.x, p_W[3 * i + 1] = place.p_W.y, p_W[3 * i + 2] = place.p_W.z + (is(kOtherLine) ? 1e-6 : 0);
      parted[i] = place.parted;
    }
    if (is(kBeyondLine)) parted.data()[n] = 1;
  }
  void cut(const swage::Step& step, double s) override {
    if (!is(kWhole)) step.state<State>().cut = s;
  }

 private:
  bool is(Fault fault) const { return params().fault == fault; }

  swage::Body body_;
  int asked_ = 0;
};

}  // namespace

SWAGE_EXPORT(Strand)
