# SPDX-License-Identifier: BSD-3-Clause
# cmake -D SOURCE=FILE.cpp -D "NAMES=name;..." -D "FILES=file;..." -P embed.cmake
# Writes a C++ source with a function of each name, declared in stroma/output/report/Embedded.hpp, that returns the bytes of
# the file in the same place of the list; of several files, FILE|FILE, one after the other.
set(text "// Made by cmake/embed.cmake.\n#include \"stroma/output/report/Embedded.hpp\"\nnamespace stroma::output::embedded {\n")
foreach(name files IN ZIP_LISTS NAMES FILES)
  string(REPLACE "|" ";" files "${files}")
  set(bytes "")
  foreach(file IN LISTS files)
    file(READ ${file} more HEX)
    string(APPEND bytes ${more})
  endforeach()
  string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(APPEND text "std::string_view ${name}() {\n  static const unsigned char bytes[] = {\n${bytes}};\n"
                     "  return {reinterpret_cast<const char*>(bytes), sizeof bytes};\n}\n")
endforeach()
file(WRITE ${SOURCE} "${text}}\n")
