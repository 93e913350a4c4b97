// SPDX-License-Identifier: Apache-2.0
#include "host/elf_exports.hpp"

#include <elf.h>

#include <cstring>
#include <fstream>
#include <sstream>

namespace swage::host {

namespace {

// a struct at a place of the file; false beyond its end
template <class T>
bool read_at(const std::string& file, uint64_t offset, T& out) {
  if (offset > file.size() || file.size() - offset < sizeof(T)) return false;
  std::memcpy(&out, file.data() + offset, sizeof(T));
  return true;
}

bool shown(const Elf64_Sym& symbol) {
  const auto bind = ELF64_ST_BIND(symbol.st_info), visibility = ELF64_ST_VISIBILITY(symbol.st_other);
  // absolute symbols are names of versions
  return symbol.st_shndx != SHN_UNDEF && symbol.st_shndx != SHN_ABS && bind != STB_LOCAL &&
         (visibility == STV_DEFAULT || visibility == STV_PROTECTED);
}

}  // namespace

bool exported_symbols(const std::string& path, std::vector<std::string>& out) {
  out.clear();
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  const std::string file = content.str();
  Elf64_Ehdr header;
  if (!read_at(file, 0, header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
      header.e_ident[EI_CLASS] != ELFCLASS64)
    return false;
  for (uint32_t i = 0; i < header.e_shnum; ++i) {
    Elf64_Shdr table, strings;
    if (!read_at(file, header.e_shoff + uint64_t{i} * header.e_shentsize, table)) return false;
    if (table.sh_type != SHT_DYNSYM || table.sh_entsize != sizeof(Elf64_Sym)) continue;
    if (!read_at(file, header.e_shoff + uint64_t{table.sh_link} * header.e_shentsize, strings)) return false;
    for (uint64_t at = 0; at + sizeof(Elf64_Sym) <= table.sh_size; at += sizeof(Elf64_Sym)) {
      Elf64_Sym symbol;
      if (!read_at(file, table.sh_offset + at, symbol)) return false;
      const uint64_t name = strings.sh_offset + symbol.st_name;
      if (shown(symbol) && name < file.size()) out.emplace_back(file.c_str() + name);
    }
  }
  return true;
}

}  // namespace swage::host
