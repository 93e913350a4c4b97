// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How metrics are called and in what unit a person reads them. A lesson's card says what a metric is in a sentence; a list and an
// axis need a title.
#pragma once

#include <QString>

namespace swage::console {

/// "time.idle" -> "Idle time". What is not known is told from its id.
QString metric_title(const QString& id);
/// The unit for quantity_text and its kin: "%" for what is a share, else `unit`.
QString metric_unit(const QString& id, const QString& unit);

}  // namespace swage::console
