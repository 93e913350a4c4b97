// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QTableView>

namespace swage::console {

/// The events of an attempt (an EventLog, or a filter of one) as a list: time and event, and below in smaller letters the
/// meaning. A separate column for the meaning would show two words of it in a window of 1280 pixels.
QTableView* make_event_table(QAbstractItemModel* events, QWidget* parent);

}  // namespace swage::console
