# Writes OUT, a source that holds the text of PAGE: cmake -D PAGE=page.html -D OUT=page_text.cpp -P embed.cmake
# In pieces: compilers need not take longer literals than 65536 characters.
file(READ ${PAGE} page)
string(LENGTH "${page}" length)
set(source "#include <graze/engine/view/writing/page_text.h>\n\nnamespace graze::view {\nnamespace {\n\nconstexpr const char* kPieces[] = {\n")
set(at 0)
while(at LESS length)
  string(SUBSTRING "${page}" ${at} 30000 piece)
  string(APPEND source "R\"graze~(${piece})graze~\",\n")
  math(EXPR at "${at} + 30000")
endwhile()
string(APPEND source "};\n\n}  // namespace\n\nstd::string page_text() {\n  std::string page;\n  for (const char* piece : kPieces)\n    page += piece;\n  return page;\n}\n\n}  // namespace graze::view\n")
file(WRITE ${OUT} "${source}")
