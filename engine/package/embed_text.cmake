# Writes OUT, a source that defines NAMESPACE::FUNCTION() of HEADER, which returns the text of FILE:
#   cmake -D FILE=page.html -D OUT=page_text.cpp -D HEADER=graze/... -D NAMESPACE=graze::view -D FUNCTION=page_text -P embed_text.cmake
# In pieces: compilers need not take longer literals than 65536 characters.
file(READ ${FILE} text)
string(LENGTH "${text}" length)
set(source "#include <${HEADER}>\n\nnamespace ${NAMESPACE} {\nnamespace {\n\nconstexpr const char* kPieces[] = {\n")
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} 30000 piece)
  string(APPEND source "R\"graze~(${piece})graze~\",\n")
  math(EXPR at "${at} + 30000")
endwhile()
string(APPEND source "};\n\n}  // namespace\n\nstd::string ${FUNCTION}() {\n  std::string text;\n  for (const char* piece : kPieces)\n    text += piece;\n  return text;\n}\n\n}  // namespace ${NAMESPACE}\n")
file(WRITE ${OUT} "${source}")
