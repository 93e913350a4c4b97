// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How metrics are called and in what unit a person reads them, as the cards of the lesson plugins say.
#pragma once

#include <QString>
#include <vector>

#include "host/plugin_info.hpp"

namespace swage::console {

/// Takes over the labels of all lesson plugins; of two labels for one metric the first stays. GUI thread.
void learn_metric_labels(const std::vector<host::PluginInfo>& plugins);

/// "time.idle" -> "Idle time". A metric without a label is told from its id.
QString metric_title(const QString& id);
/// The unit for quantity_text and its kin: "%" for a share, "yes/no" for a yes or no, else `unit`.
QString metric_unit(const QString& id, const QString& unit);
/// SWAGE_SHOW_* of the label, SWAGE_SHOW_QUANTITY without one.
int32_t metric_show(const QString& id);

/// SWAGE_BETTER_* and the formula, as the first card of that metric says; SWAGE_BETTER_NONE where no card does.
int32_t metric_better(const QString& id);
QString metric_formula(const QString& id);

/// The unit that `show` makes of `unit`.
QString shown_unit(int32_t show, const QString& unit);

}  // namespace swage::console
