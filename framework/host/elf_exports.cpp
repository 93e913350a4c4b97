// SPDX-License-Identifier: Apache-2.0
#include "host/elf_exports.hpp"

#include <elf.h>

#include <cstring>

#include "base/hash.hpp"
#include "toolkit/read_file.hpp"

namespace swage::host {

namespace {

// reads a struct at an offset of the file; false beyond its end
template <class T>
bool read_at(const std::string& file, uint64_t offset, T& out) {
  if (offset > file.size() || file.size() - offset < sizeof(T)) return false;
  std::memcpy(&out, file.data() + offset, sizeof(T));
  return true;
}

bool is_library(const std::string& file, Elf64_Ehdr& header) {
  return read_at(file, 0, header) && std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 &&
         header.e_ident[EI_CLASS] == ELFCLASS64 && header.e_shentsize == sizeof(Elf64_Shdr);
}

bool shown(const Elf64_Sym& symbol) {
  const auto bind = ELF64_ST_BIND(symbol.st_info), visibility = ELF64_ST_VISIBILITY(symbol.st_other);
  // absolute symbols are version names
  return symbol.st_shndx != SHN_UNDEF && symbol.st_shndx != SHN_ABS && bind != STB_LOCAL &&
         (visibility == STV_DEFAULT || visibility == STV_PROTECTED);
}

}  // namespace

bool exported_symbols(const std::string& path, std::vector<std::string>& out) {
  out.clear();
  std::string file, why;
  Elf64_Ehdr header;
  if (!toolkit::read_file(path, kMostLibraryBytes, file, why) || !is_library(file, header)) return false;
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

uint64_t hash_of_kept(const std::string& bytes) {
  base::Hash hash;
  const auto add = [&hash](const char* data, std::size_t size) {
    hash.add(data, size).add(static_cast<uint64_t>(size));
  };
  Elf64_Ehdr header;
  std::vector<Elf64_Shdr> section(is_library(bytes, header) ? header.e_shnum : 0);
  if (section.empty()) add(bytes.data(), bytes.size());
  for (std::size_t i = 0; i < section.size(); ++i)
    if (!read_at(bytes, header.e_shoff + i * sizeof(Elf64_Shdr), section[i])) section[i] = {};
  const auto names_paths = [&](std::size_t i) {
    if (section[i].sh_type == SHT_DYNAMIC) return true;
    for (const Elf64_Shdr& s : section)
      if (s.sh_type == SHT_DYNAMIC && s.sh_link == i) return true;
    return false;
  };
  for (std::size_t i = 0; i < section.size(); ++i) {
    const Elf64_Shdr& s = section[i];
    const bool there = s.sh_offset <= bytes.size() && s.sh_size <= bytes.size() - s.sh_offset;
    if ((s.sh_flags & SHF_ALLOC) == 0 || s.sh_type == SHT_NOBITS || !there || names_paths(i)) continue;
    hash.add(static_cast<uint64_t>(s.sh_addr));
    add(bytes.data() + s.sh_offset, s.sh_size);
  }
  return hash.value();
}

}  // namespace swage::host
