// SPDX-License-Identifier: Apache-2.0
//
// From the options of a run to its lesson file and its plugins.
#pragma once

#include "assembly/lesson_file.hpp"
#include "host/catalogue.hpp"
#include "session/session.hpp"

namespace swage::session {

/// The lesson's file with the other values that were asked for. A faulty one is read as far as it goes: one run tells everything that
/// is wrong with it. [main]
assembly::LessonFile read_lesson(const Options& options, Problems& problems);

/// The plugins that a run may use. [main]
host::Catalogue catalogue_of(const Options& options);

}  // namespace swage::session
