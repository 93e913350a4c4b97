// SPDX-License-Identifier: Apache-2.0
//
// The guide shows code that exists: each block is a run of lines of an instantiated template, and each quoted message
// stands in the sources.
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "scene/capacities.hpp"
#include "snapshot/snapshot.hpp"
#include "step/limits.hpp"
#include "test_places.hpp"

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = SWAGE_SOURCE_DIR;
const fs::path kGuide = kRoot / "framework/sdk/guide";

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// The templates as the guide's reader has them: "object/clip.cpp" -> text.
std::map<std::string, std::string> instantiated() {
  const struct {
    const char *kind, *file, *name;
  } examples[] = {{"object", "clip", "Clip"},
                  {"flexible", "loop", "Loop"},
                  {"coupling", "touch", "Touch"},
                  {"device", "circle", "Circle"},
                  {"hardware", "pen", "Pen"},
                  {"lesson", "reach", "Reach"}};
  std::map<std::string, std::string> files;
  for (const auto& e : examples) {
    const auto fill = [&e](const std::string& text) {
      // names of one word: the title is the name
      return replaced(
          replaced(replaced(replaced(text, "@ID@", std::string("org.example.") + e.file), "@FILE@", e.file), "@NAME@", e.name),
          "@TITLE@", e.name);
    };
    for (const auto& entry : fs::directory_iterator(kRoot / "resources/plugin_template" / e.kind))
      files[std::string(e.kind) + "/" + fill(entry.path().filename().string())] = fill(read(entry.path()));
  }
  // and what no template has: a plugin that our tests build and run
  files["series/111_insertion_quarter.json"] = read(kRoot / "lessons/series/111_insertion_quarter.json");
  files["series/118_stitch_dry.json"] = read(kRoot / "lessons/series/118_stitch_dry.json");
  files["leash/leash.cpp"] = read(kRoot / "tests/plugins_for_tests/leash/leash.cpp");
  files["sticky/sticky.cpp"] = read(kRoot / "tests/plugins_for_tests/sticky/sticky.cpp");
  return files;
}

struct Block {
  std::string language, source, text;  // source: of the comment above it, "" for none
  int line = 0;
};

std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> blocks;
  std::istringstream in(page);
  std::string line, above;
  bool inside = false;
  for (int number = 1; std::getline(in, line); ++number) {
    const bool fence = line.starts_with("```");
    if (fence && !inside) blocks.push_back({line.substr(3), above, "", number});
    if (fence) inside = !inside;
    if (inside && !fence) blocks.back().text += line + "\n";
    const bool comment = line.starts_with("<!-- ") && line.ends_with(" -->");
    above = comment ? line.substr(5, line.size() - 9) : "";
  }
  return blocks;
}

std::vector<std::string> pages() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kGuide))
    if (entry.path().extension() == ".md") names.push_back(entry.path().filename().string());
  return names;
}

/// What is wrong with the blocks of a page, one line each.
std::string wrong_blocks(const std::string& page, const std::map<std::string, std::string>& files) {
  std::string wrong;
  for (const Block& block : blocks_of(page)) {
    const std::string where = std::to_string(block.line) + ": ";
    const auto file = files.find(block.source);
    if (block.source.empty())
      wrong += where + "code without a comment that names its file\n";
    else if (file == files.end())
      wrong += where + "there is no " + block.source + "\n";
    else if (("\n" + file->second).find("\n" + block.text) == std::string::npos)
      wrong += where + "not in " + block.source + "\n";
  }
  return wrong;
}

TEST(Guide, shows_code_that_the_tests_compile) {
  const auto files = instantiated();
  size_t blocks = 0;
  for (const std::string& name : pages()) {
    const std::string page = read(kGuide / name);
    EXPECT_EQ(wrong_blocks(page, files), "") << name;
    blocks += blocks_of(page).size();
  }
  EXPECT_GE(blocks, 9u);
}

TEST(Guide, code_that_has_drifted_is_found) {
  const std::map<std::string, std::string> files{{"object/clip.cpp", "int a;\nint b;\nint c;\n"}};
  EXPECT_EQ(wrong_blocks("<!-- object/clip.cpp -->\n```cpp\nint b;\nint c;\n```\n", files), "");
  EXPECT_EQ(wrong_blocks("<!-- object/clip.cpp -->\n```cpp\nint a;\nint c;\n```\n", files),
            "2: not in object/clip.cpp\n");
  EXPECT_EQ(wrong_blocks("<!-- object/clap.cpp -->\n```cpp\nint a;\n```\n", files),
            "2: there is no object/clap.cpp\n");
  EXPECT_EQ(wrong_blocks("```cpp\nint a;\n```\n", files), "1: code without a comment that names its file\n");
}

/// Every "page.md" in "](page.md)".
std::vector<std::string> links_of(const std::string& page) {
  std::vector<std::string> links;
  for (size_t at = 0; (at = page.find("](", at)) != std::string::npos; at += 2)
    links.push_back(page.substr(at + 2, page.find(')', at) - at - 2));
  return links;
}

TEST(Guide, links_lead_somewhere) {
  size_t links = 0;
  for (const std::string& name : pages()) {
    for (const std::string& link : links_of(read(kGuide / name))) {
      EXPECT_TRUE(fs::exists(kGuide / link)) << name << " -> " << link;
      ++links;
    }
  }
  EXPECT_GE(links, 9u);
}

/// All sources of the framework with adjacent string literals joined, as the compiler sees them.
std::string all_literals() {
  std::string all;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "framework")) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".hpp" || extension == ".cpp" || extension == ".h") all += read(entry.path());
  }
  std::string joined;
  for (size_t at = 0; at < all.size(); ++at) {
    const size_t next = all[at] == '"' ? all.find_first_not_of(" \n", at + 1) : std::string::npos;
    if (next != std::string::npos && all[next] == '"')
      at = next;
    else
      joined += all[at];
  }
  return joined;
}

/// What the first column of a table row quotes: "| `...` | ...".
std::string quoted_message(const std::string& line) {
  const size_t end = line.find("` |");
  return line.starts_with("| `") && end != std::string::npos ? line.substr(3, end - 3) : "";
}

/// The pieces of a quoted message between what varies.
std::vector<std::string> fixed_pieces(const std::string& message) {
  std::vector<std::string> pieces;
  const std::string dots = "…";
  size_t from = 0;
  while (true) {
    const size_t to = message.find(dots, from);
    const std::string piece = message.substr(from, to - from);
    if (!piece.empty()) pieces.push_back(piece);
    if (to == std::string::npos) return pieces;
    from = to + dots.size();
  }
}

TEST(Guide, quotes_messages_that_exist) {
  const std::string sources = all_literals();
  std::istringstream page(read(kGuide / "errors.md"));
  size_t messages = 0;
  for (std::string line; std::getline(page, line);) {
    const std::string message = quoted_message(line);
    if (message.empty()) continue;
    ++messages;
    for (const std::string& piece : fixed_pieces(message))
      EXPECT_NE(sources.find(piece), std::string::npos) << "no source says: " << piece;
  }
  EXPECT_GE(messages, 15u);
  EXPECT_EQ(sources.find("a message that nobody says, spelt in no source"), std::string::npos);
}

/// The second column of the row of a table that begins with `what`; "" where there is none.
std::string at_most(const std::string& page, const std::string& what) {
  const size_t row = page.find("\n| " + what + " | ");
  if (row == std::string::npos) return "";
  const size_t from = row + what.size() + 6;
  return page.substr(from, page.find(" | ", from) - from);
}

/// The value of a constant in a source, as it is written there.
std::string written(const fs::path& file, const std::string& name) {
  const std::string text = read(kRoot / file);
  const size_t at = text.find(" " + name + " = ");
  if (at == std::string::npos) return "";
  const size_t from = at + name.size() + 4;
  return text.substr(from, text.find(';', from) - from);
}

// what the page on limits says is what the sources hold
TEST(Guide, limits_are_those_of_the_sources) {
  const std::string page = read(kGuide / "limits.md");
  const auto number = [](double x) {
    std::ostringstream out;
    out << x;
    return out.str();
  };
  const auto reserved = [](uint32_t usual, uint32_t most) {
    return std::to_string(usual) + ", with `reserve_points` up to " + std::to_string(most);
  };
  const swage::scene::Capacities usual, most = swage::scene::kLargest;
  EXPECT_EQ(at_most(page, "contact points solved in a step"), reserved(usual.contacts, most.contacts));
  EXPECT_EQ(at_most(page, "contact points of one flexible body"), reserved(usual.points, most.points));
  EXPECT_EQ(at_most(page, "contacts and ties solved together with flexible bodies"), reserved(usual.rows, most.rows));
  EXPECT_EQ(at_most(page, "ties in a step"), std::to_string(usual.ties));
  EXPECT_NE(page.find("more than " + std::to_string(usual.points) + " points at once"), std::string::npos);
  using namespace swage::snapshot;
  EXPECT_EQ(at_most(page, "bodies, objects, particles"), number(kMaxBodies) + ", " + number(kMaxObjects) + ", " + number(kMaxParticles));
  EXPECT_EQ(at_most(page, "signals, metrics, marks, devices"),
            number(kMaxSignals) + ", " + number(kMaxMetrics) + ", " + number(kMaxMarks) + ", " + number(kMaxDevices));
  EXPECT_EQ(at_most(page, "drawn: contacts; primitives beside shapes"), number(kMaxContacts) + "; " + number(kMaxVisuals) + ", " + number(kMaxVisualsOfOne) + " by one plugin");
  EXPECT_EQ(at_most(page, "shapes; vertices or faces of one polyhedron; vertices of one chain"),
            written("framework/host/builder.cpp", "kMaxShapes") + "; " + written("framework/host/builder.cpp", "kMaxConvex") + "; " +
                written("framework/host/chain.cpp", "kMost"));
  EXPECT_EQ(at_most(page, "private numbers (`state`)"), "1 Mi in one call, 8 Mi in all");
  EXPECT_EQ(written("framework/host/builder.cpp", "kMaxState"), "8u << 20");
  EXPECT_EQ(at_most(page, "how fast a tool follows its hand"),
            number(swage::step::kMaxToolSpeed) + " lengths of the scene a second, " + number(swage::step::kMaxToolTurn) + " rad/s");
}

// every kind of shape has its column
TEST(Guide, names_every_shape_in_the_table_of_pairs) {
  const std::string page = read(kGuide / "limits.md"), header = read(kRoot / "framework/sdk/include/swage/abi/builder.h");
  const std::string head = page.substr(page.find("| | sphere"), page.find('\n', page.find("| | sphere")) - page.find("| | sphere"));
  size_t kinds = 0;
  const std::string define = "#define SWAGE_SHAPE_";
  for (size_t at = 0; (at = header.find(define, at)) != std::string::npos; ++at) {
    const size_t from = at + define.size(), end = header.find(' ', from);
    // flags have a u behind their number
    if (header.substr(end, header.find('\n', end) - end).find('u') == 2) continue;
    std::string kind = replaced(header.substr(from, end - from), "_", " ");
    for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    EXPECT_NE(head.find(kind), std::string::npos) << kind;
    ++kinds;
  }
  EXPECT_EQ(kinds, 7u) << "of chains, fields and so on: a new one needs its column";
}

}  // namespace
