# SPDX-License-Identifier: Apache-2.0
# Embeds the texts of a folder in the program, as a function that maps a path below the folder to its text.
# cmake -DFOLDER=DIR -DHEADER=FILE -DNAMESPACE=N -DFUNCTION=F -DOUTPUT=FILE.cpp -P embed_texts.cmake
# HEADER declares `std::string F(std::string_view path);` in NAMESPACE.
file(GLOB_RECURSE paths RELATIVE ${FOLDER} ${FOLDER}/*)
list(REMOVE_ITEM paths .clang-format)  # it configures clang-format and is not a text to embed
list(SORT paths)
get_filename_component(name ${FOLDER} NAME)
set(text "// The texts of ${name}, built in by embed_texts.cmake.\n#include \"${HEADER}\"\n\n#include <stdexcept>\n\nnamespace ${NAMESPACE} {\n\nstd::string ${FUNCTION}(std::string_view path) {\n")
foreach(path ${paths})
  file(READ ${FOLDER}/${path} content)
  string(APPEND text "    if (path == \"${path}\")\n        return R\"--text--(${content})--text--\";\n")
endforeach()
string(APPEND text "    throw std::logic_error(\"no text \" + std::string(path));\n}\n\n}  // namespace ${NAMESPACE}\n")
file(WRITE ${OUTPUT} "${text}")
