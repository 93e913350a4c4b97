// SPDX-License-Identifier: Apache-2.0
#include "judge/verdict.hpp"

namespace swage::judge {

const char* text(Outcome outcome) {
  switch (outcome) {
    case Outcome::kRunning:
      return "running";
    case Outcome::kPassed:
      return "passed";
    case Outcome::kFailed:
      return "failed";
    case Outcome::kVoid:
      return "void";
    case Outcome::kAborted:
      return "aborted";
  }
  return "unknown";
}

}  // namespace swage::judge
