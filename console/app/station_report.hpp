// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The report of this station to those who watch it from another: the trainee, the lesson, the state of the attempt. [main]
#pragma once

#include <QObject>

#include "console/link/run_control.hpp"
#include "console/models/lessons_model.hpp"
#include "console/models/reading.hpp"
#include "console/pages/setup_panel.hpp"
#include "record/stations.hpp"

namespace swage::console {

class StationReport : public QObject {
  Q_OBJECT
 public:
  /// All outlive this object, or reports are no longer asked for.
  StationReport(const RunControl* control, const SetupPanel* setup, const LessonsModel* lessons, QObject* parent = nullptr);
  record::StationNow now() const;

 private:
  const RunControl* control_;
  const SetupPanel* setup_;
  const LessonsModel* lessons_;
  Reader reading_;  // of the attempt
};

}  // namespace swage::console
