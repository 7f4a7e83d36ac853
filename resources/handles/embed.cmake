# Writes OUTPUT, a C++ source with the text of INPUT.
file(READ ${INPUT} text)
file(WRITE ${OUTPUT} "// Made from resources/handles/handles.txt.\n"
  "#include <string_view>\n\n"
  "namespace handlebody {\n"
  "extern const std::string_view kHandleDatabaseText;\n"
  "const std::string_view kHandleDatabaseText = R\"handles(${text})handles\";\n"
  "}  // namespace handlebody\n")
