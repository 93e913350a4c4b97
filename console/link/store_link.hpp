// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The store of people and attempts, shared by all pages: opened at its first use, and again after a failure.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>

#include "record/store.hpp"

namespace swage::console {

/// How the store is opened: record::Store::open, or a test double. nullptr and `error` on failure.
using StoreOpener = std::function<std::unique_ptr<record::Store>(std::string& error)>;

class StoreLink : public QObject {
  Q_OBJECT
 public:
  explicit StoreLink(StoreOpener opener, QObject* parent = nullptr) : QObject(parent), opener_(std::move(opener)) {}

  /// nullptr when there is no store; problem() has the reason. A page that shows an attempt holds its store open.
  std::shared_ptr<record::Store> store();
  const QString& problem() const { return problem_; }
  /// Whether the last call returned complete data. False: problem() has the reason, and the next store() opens it again.
  bool reads();
  /// Whether anyone has written to the store since the last call. Cheap.
  bool changed() { return store_ && !broken_ && store_->changed(); }

 Q_SIGNALS:
  /// Attempts of a program that ended unexpectedly were closed.
  void recovered(int attempts);

 private:
  StoreOpener opener_;
  std::shared_ptr<record::Store> store_;
  QString problem_;
  bool broken_ = false;
};

}  // namespace swage::console
