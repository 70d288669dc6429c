# Writes OUTPUT: every file of FILES as a raw string literal, in the order of their names, as the list that FUNCTION (declared in
# HEADER, in NAMESPACE) returns; its entries are of TYPE { name, text }.
set(text "#include \"${HEADER}\"\n\nnamespace ${NAMESPACE} {\n\n")
string(APPEND text "const std::vector<${TYPE}>& ${FUNCTION}() {\n")
string(APPEND text "    static const std::vector<${TYPE}> files{\n")
list(SORT FILES)
foreach(path IN LISTS FILES)
  get_filename_component(name ${path} NAME)
  file(READ ${path} content)
  string(APPEND text "        {\"${name}\", R\"toml~(${content})toml~\"},\n")
endforeach()
string(APPEND text "    };\n    return files;\n}\n\n}  // namespace ${NAMESPACE}\n")
file(WRITE ${OUTPUT} "${text}")
