// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The store of people and attempts, one for all pages: opened when it is first needed, and again after it failed.
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

  /// nullptr where there is none, and problem() says why. Whoever looks at an attempt keeps its store open.
  std::shared_ptr<record::Store> store();
  const QString& problem() const { return problem_; }
  /// Whether the last call gave all there is. False: problem() says why, and the next store() opens it again.
  bool reads();
  /// Whether anything was written since the last look, by whomever. Cheap.
  bool changed() { return store_ && !broken_ && store_->changed(); }

 Q_SIGNALS:
  /// Attempts of a program that ended unexpectedly were brought to an end.
  void recovered(int attempts);

 private:
  StoreOpener opener_;
  std::shared_ptr<record::Store> store_;
  QString problem_;
  bool broken_ = false;
};

}  // namespace swage::console
