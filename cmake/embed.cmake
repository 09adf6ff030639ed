# Writes a C++ file that holds text files as raw string literals, keyed by their path below ROOT.
# cmake -DROOT=dir -DFILES=a;b -DOUTPUT=file.cpp -DTABLE=name -P embed.cmake
set(text "#include \"sim/gpu/embedded_text.h\"\n\nnamespace talus {\nconst std::map<std::string, std::string_view, std::less<>>& ${TABLE}() {\n    static const std::map<std::string, std::string_view, std::less<>> files = {\n")
foreach(file IN LISTS FILES)
    file(READ "${ROOT}/${file}" body)
    string(APPEND text "{\"${file}\", R\"talus(${body})talus\"},\n")
endforeach()
string(APPEND text "    };\n    return files;\n}\n}  // namespace talus\n")
file(WRITE "${OUTPUT}" "${text}")
