// SPDX-License-Identifier: Apache-2.0
//
// Where this program is, what lies beside it, and which attempt a person means. [main]
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "record/store.hpp"

namespace swage::tools {

/// Folder of the running program.
std::string program_folder();

/// A program beside this one, or "".
std::string beside(const std::string& program);

/// Replaces this process. Returns only when that failed.
void become(const std::string& program, const std::vector<std::string>& arguments);

/// True when a window could be opened somewhere.
bool has_display();

/// A folder of what comes with Swage ("needles", "lessons/series"), installed or in the source tree (there also below resources/),
/// "" when there is none; `searched` says where was looked.
std::string data_folder(const std::string& name, std::vector<std::string>& searched);

/// Templates of new plugins: share/swage/plugin_template of the install, resources/plugin_template of a source tree.
/// "" when there are none; `searched` then says where.
std::string template_folder(std::vector<std::string>& searched);

/// The store as given, or the user's own.
std::string store_place(const std::string& given);

/// Opens a store that is there already; reading makes none. nullptr with a sentence.
std::unique_ptr<record::Store> existing_store(const std::string& where, std::string& error);

/// The attempt meant by an id, the beginning of one, or "last". False with a sentence.
bool find_attempt(record::Store& store, const std::string& meant, record::AttemptRow& out,
                  std::string& error);

}  // namespace swage::tools
