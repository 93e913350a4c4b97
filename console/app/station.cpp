// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/station.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace swage::console {

Station read_station(const Settings& settings) {
  Station out;
  const nlohmann::json j = nlohmann::json::parse(settings.text("station").toStdString(), nullptr, false);
  if (!j.is_object()) return out;
  try {
    Station s;
    s.size.on = j.at("on");
    s.size.screen_mm = {j.at("screen_mm").at(0), j.at("screen_mm").at(1)};
    s.size.distance_mm = j.at("distance_mm");
    s.size.eye_distance_mm = j.at("eye_distance_mm");
    s.size.scale = j.at("scale");
    s.size.held = j.at("held");
    s.size.screen_tilt_deg = j.at("screen_tilt_deg");
    s.size.mirror_tilt_deg = j.at("mirror_tilt_deg");
    if (j.contains("arm")) {
      const auto& a = j.at("arm");
      const auto& q = a.at("q");
      s.device = QString::fromStdString(a.at("device"));
      s.date = QString::fromStdString(a.at("date"));
      s.arm.X_SD = {{a.at("p").at(0), a.at("p").at(1), a.at("p").at(2)}, {q.at(0), q.at(1), q.at(2), q.at(3)}};
      s.arm.worst = a.at("worst");
      s.arm.rms = a.at("rms");
      s.registered = true;
    }
    out = s;
  } catch (const nlohmann::json::exception&) {
    // a malformed file, such as one edited by hand, counts as no measurement
  }
  return out;
}

void remember(const Station& s, Settings& settings) {
  nlohmann::ordered_json j = {{"on", s.size.on},
                              {"screen_mm", {s.size.screen_mm.width(), s.size.screen_mm.height()}},
                              {"distance_mm", s.size.distance_mm},
                              {"eye_distance_mm", s.size.eye_distance_mm},
                              {"scale", s.size.scale},
                              {"held", s.size.held},
                              {"screen_tilt_deg", s.size.screen_tilt_deg},
                              {"mirror_tilt_deg", s.size.mirror_tilt_deg}};
  const swage_pose& X = s.arm.X_SD;
  if (s.registered)
    j["arm"] = {{"device", s.device.toStdString()}, {"date", s.date.toStdString()},
                {"p", {X.p.x, X.p.y, X.p.z}},       {"q", {X.q.w, X.q.x, X.q.y, X.q.z}},
                {"worst", s.arm.worst},             {"rms", s.arm.rms}};
  settings.set("station", QString::fromStdString(j.dump()));
}

std::array<QPointF, 4> station_marks(const TrueSize& size) {
  const double x = size.screen_mm.width() / 6, y = size.screen_mm.height() / 4;
  return {QPointF(-x, y), QPointF(x, y), QPointF(x, -y), QPointF(-x, -y)};
}

}  // namespace swage::console
