# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT, a C++ source that contains every page of FOLDER as a raw string (base/rule_pages/rule_pages.hpp).
# cmake -DFOLDER=docs/rules -DOUTPUT=page_texts.cpp -P embed_pages.cmake
file(GLOB pages ${FOLDER}/*.md)
list(SORT pages)
set(text "// Made from docs/rules by base/rule_pages/embed_pages.cmake.\n#include \"base/rule_pages/rule_pages.hpp\"\n\n")
string(APPEND text "namespace robochart::diagnostics {\n\nconst std::vector<PageText>& page_texts() {\n")
string(APPEND text "    static const std::vector<PageText> pages = {\n")
foreach(page ${pages})
  get_filename_component(code ${page} NAME_WE)
  file(READ ${page} content)
  string(APPEND text "        {\"${code}\", R\"page(${content})page\"},\n")
endforeach()
string(APPEND text "    };\n    return pages;\n}\n\n}  // namespace robochart::diagnostics\n")
file(WRITE ${OUTPUT} "${text}")
