// SPDX-License-Identifier: Apache-2.0
//
// A needle held still 20 um below the surface, over the whole range of every parameter of the tissue that yields: the dent never goes
// deeper than the needle, the force never beyond what an elastic solid answers at once, and no energy comes from it.
#include "pierce_energy.hpp"
#include "pierce_scene.hpp"

namespace swage::test {
namespace {

using tissue::Level;
using tissue::Tissue;
using tissue::TissueParams;

constexpr double kDepth = 20e-6;  // m, of the hold
constexpr double kHeld = 0.12;    // s, from when on the hand stands still

/// A tissue's parameters as a lesson file has them. A table of heights needs a file and is left out.
std::string text(const TissueParams& params) {
  std::string out;
  for (const Field& field : Tissue::fields) {
    const swage_param& p = field.param;
    if (p.type == SWAGE_PARAM_FILE) continue;
    double number[4] = {};
    const char* unused = nullptr;
    field.read(&params, number, &unused);
    out += std::string(out.empty() ? "\"" : ", \"") + p.id + "\": ";
    if (p.type == SWAGE_PARAM_CHOICE) {
      out += std::string("\"") + p.choices[static_cast<int>(number[0])] + "\"";
      continue;
    }
    char digits[2][40];
    for (int i = 0; i < 2; ++i) std::snprintf(digits[i], sizeof digits[i], "%.17g", number[i]);
    out += p.dimension == 2 ? std::string("[") + digits[0] + ", " + digits[1] + "]" : digits[0];
  }
  return out;
}

TissueParams with(Level level, const Field& field, double value) {
  TissueParams params;
  params.level = level;
  params.cells = 8, params.refinement = 3;  // of a mesh: the fewest, the quickest built
  const swage_value to{{value, value, value, value}, {}};
  field.assign(&params, to);
  return params;
}

/// Down to kDepth within kHeld, then still for 0.2 s. False: there is no such tissue (what does not fit is refused by its checks).
bool hold(const TissueParams& params, const std::string& what) {
  PierceScene s;
  s.tissue = text(params);
  s.leash = R"("stiffness": "50000 N/m")";
  s.duration = 0.4;
  const auto path = [](double t) {
    Pose X = PierceScene::turned({-PierceScene::kRadius, 0, 0}, 0);
    const double start = PierceScene::kWire + 5e-6, end = PierceScene::kWire - kDepth;
    X.p.z() += start + (end - start) * std::min(t / kHeld, 1.0);
    return X;
  };
  if (!s.build(path, std::string(SWAGE_BINARY_DIR "/tissue_range.json")).empty()) return false;
  const bool flat = params.form == tissue::Form::kFlat;
  Ledger ledger(s, {{2, params}});
  double deepest = 0, most = 0, settled = 0;
  s.run_until(0.32, [&] {
    if (flat) ledger.look();
    deepest = std::max(deepest, s.signal("tissue.dimple"));
    most = std::max(most, s.signal("tissue.force"));
    if (s.time() < 0.2) settled = s.signal("tissue.force");
  });
  // the overlap of the point's ball with a plane through O at rest
  const double tilt = params.form == tissue::Form::kRightSlope ? std::cos(params.slope) : 1,
               overlap = PierceScene::kWire - (PierceScene::kWire - kDepth) * tilt;
  EXPECT_LT(deepest, 1.05 * overlap) << what;
  EXPECT_LE(s.signal("tissue.force"), settled + 1e-3 * most) << what << ": it relaxes, and never grows";
  EXPECT_EQ(s.engine->stats().health.not_converged, 0u) << what;
  if (flat && ledger.most_stored > 0) {
    EXPECT_GT(ledger.deepest, -1e-6 * ledger.most_stored) << what << ": more came out than had gone in";
    EXPECT_GT(ledger.worst, -0.012 * ledger.most_stored) << what << ": made in a step";
  }
  return true;
}

/// Both ends of the range, the default and the middle between, as a ratio where the range spans decades; every choice.
std::vector<double> values(const swage_param& p) {
  std::vector<double> out;
  if (p.type == SWAGE_PARAM_CHOICE) {
    for (int i = 0; p.choices[i] != nullptr; ++i) out.push_back(i);
    return out;
  }
  const double middle = p.min > 0 && p.max > 20 * p.min ? std::sqrt(p.min * p.max) : 0.5 * (p.min + p.max);
  return {p.min, p.type == SWAGE_PARAM_INTEGER ? std::round(middle) : middle, p.max};
}

void sweep(Level level) {
  int made = 0, refused = 0;
  for (const Field& field : Tissue::fields) {
    const swage_param& p = field.param;
    if (p.type == SWAGE_PARAM_FILE || std::string(p.id) == "level") continue;
    for (const double value : values(p)) {
      const TissueParams params = with(level, field, value);
      // a table needs a file; into the left slope, the right one's mirror image, the needle's other end would go as well
      if (params.form == tissue::Form::kTable || params.form == tissue::Form::kLeftSlope) continue;
      const std::string what =
          std::string(Tissue::kLevels[static_cast<int>(level)]) + ", " + p.id + " = " + std::to_string(value);
      ++(hold(params, what) ? made : refused);
    }
  }
  EXPECT_GT(made, 60) << "most of the range is a tissue";
  EXPECT_LT(refused, 12);
}

TEST(TissueRange, CompliantStaysBounded) { sweep(Level::kCompliant); }
TEST(TissueRange, MeshStaysBounded) { sweep(Level::kMesh); }

// purely elastic, or nearly so: what is held still bears the same force for ever
TEST(TissueRange, ElasticTissueHoldsItsForce) {
  for (const Level level : {Level::kCompliant, Level::kMesh})
    for (const double relaxed : {1.0, 1 - 1e-15, 1 - 1e-12, 1 - 1e-9, 0.9999999, 0.999}) {
      TissueParams params;
      params.level = level, params.cells = 8, params.relaxed = relaxed;
      char what[80];
      std::snprintf(what, sizeof what, "%s, relaxed = %.15g", Tissue::kLevels[static_cast<int>(level)],
                    relaxed);
      EXPECT_TRUE(hold(params, what));
    }
}

}  // namespace
}  // namespace swage::test
