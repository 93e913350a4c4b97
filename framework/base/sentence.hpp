// SPDX-License-Identifier: Apache-2.0
//
// Messages for people, as the toolkit has for plugins: one catalogue per room. [main]
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::base {

using toolkit::Sentence;
using toolkit::operator""_sentence;

}  // namespace swage::base
