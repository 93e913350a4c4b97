// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/store_link.hpp"

#include "console/models/said.hpp"

namespace swage::console {

std::shared_ptr<record::Store> StoreLink::store() {
  if (store_ && !broken_) return store_;
  store_.reset();
  broken_ = false;
  problem_.clear();
  std::string error;
  if (opener_) store_ = opener_(error);
  if (!store_)
    problem_ = error.empty() ? tr("Nothing is kept: the program was started without a store.")
                             : tr("The attempts cannot be read: %1").arg(said_message(error));
  if (!store_) return nullptr;
  if (const int n = store_->recover(); n > 0) Q_EMIT recovered(n);
  return store_;
}

bool StoreLink::reads() {
  const std::string trouble = store_ ? store_->trouble() : std::string();
  if (trouble.empty()) return store_ != nullptr;
  broken_ = true;
  problem_ = QString::fromStdString(trouble);
  return false;
}

}  // namespace swage::console
