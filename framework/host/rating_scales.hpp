// SPDX-License-Identifier: Apache-2.0
//
// Rating scales as files (resources/scales). [main]
#pragma once

#include <string>
#include <vector>

#include "judge/rating.hpp"

namespace swage::host {

/// Reads a scale from the text of its file. False, with a sentence in `error`, for an invalid text; `out` is then unspecified.
bool read_rating_scale(const std::string& text, judge::RatingScale& out, std::string& error);

/// All scales of a folder (*.json), by file name. A faulty one is omitted, and its fault is in `errors`.
std::vector<judge::RatingScale> rating_scales(const std::string& folder, std::vector<std::string>& errors);

/// Folder of a person's own scales: $XDG_DATA_HOME/swage/scales, else ~/.local/share/swage/scales; "" without a home.
std::string own_scales_folder();
/// Adds the scales of a person's own folder. One with the id of another is omitted, and that is in `errors`.
void add_own_scales(std::vector<judge::RatingScale>& scales, std::vector<std::string>& errors);

}  // namespace swage::host
