// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Titles and display units of metrics, from the cards of the lesson plugins.
#pragma once

#include <QString>
#include <vector>

#include "host/plugin_info.hpp"

namespace swage::console {

/// Stores the labels of all lesson plugins; of two labels for one metric the first is used. GUI thread.
void learn_metric_labels(const std::vector<host::PluginInfo>& plugins);

/// "time.idle" -> "Idle time". A metric without a label gets a title made from its id.
QString metric_title(const QString& id);
/// The unit for quantity_text and similar functions: "%" for a share, "yes/no" for a yes or no, else `unit`.
QString metric_unit(const QString& id, const QString& unit);
/// SWAGE_SHOW_* of the label, SWAGE_SHOW_QUANTITY without one.
int32_t metric_show(const QString& id);

/// SWAGE_BETTER_* and the formula, from the first card with that metric; SWAGE_BETTER_NONE without one.
int32_t metric_better(const QString& id);
QString metric_formula(const QString& id);

/// The display unit of `unit` under `show`.
QString shown_unit(int32_t show, const QString& unit);

}  // namespace swage::console
