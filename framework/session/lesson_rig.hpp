// SPDX-License-Identifier: Apache-2.0
//
// The lesson file and the plugins for the options of a run.
#pragma once

#include "assembly/lesson_file.hpp"
#include "host/catalogue.hpp"
#include "session/session.hpp"

namespace swage::session {

/// The lesson's file with the settings of the options. A faulty file is read as far as possible, so that one run reports all of its
/// faults. [main]
assembly::LessonFile read_lesson(const Options& options, Problems& problems);

/// The plugins that a run may use. [main]
host::Catalogue catalogue_of(const Options& options);

}  // namespace swage::session
