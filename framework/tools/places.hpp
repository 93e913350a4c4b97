// SPDX-License-Identifier: Apache-2.0
//
// Folders of this program and its data, the store, and the attempt that a person names. [main]
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "record/recorder.hpp"
#include "record/store.hpp"

namespace swage::tools {

/// Folder of the running program.
std::string program_folder();

/// A program beside this one, or "".
std::string beside(const std::string& program);

/// Replaces this process by the program. Returns only on failure.
void become(const std::string& program, const std::vector<std::string>& arguments);

/// True when a window could be opened somewhere.
bool has_display();

/// Data folder of Swage ("needles", "lessons/series"), installed or in the source tree (there also below resources/),
/// "" when there is none; `searched`: the places tried.
std::string data_folder(const std::string& name, std::vector<std::string>& searched);

/// Lesson 139 of the series, in which knots are pulled; "" when there is none.
std::string pull_lesson();

/// Templates of new plugins: share/swage/plugin_template of the install, resources/plugin_template of a source tree.
/// "" when there are none; `searched`: the places tried.
std::string template_folder(std::vector<std::string>& searched);

/// Path of the store: as given, or the user's own.
std::string store_place(const std::string& given);

/// Opens an existing store and creates none; nullptr with a message.
std::unique_ptr<record::Store> existing_store(const std::string& where, std::string& error);

/// Finds an attempt by its id, the beginning of an id, or "last". False with a message.
bool find_attempt(record::Store& store, const std::string& meant, record::AttemptRow& out,
                  std::string& error);

/// Loads the attempt that a person names: an exported .swage file, or an attempt of the store, as for find_attempt(). `id`: of the store's. False with a
/// message.
bool load_attempt(const std::string& what, const std::string& store_given, record::Recording& out, std::string& id, std::string& error);

}  // namespace swage::tools
