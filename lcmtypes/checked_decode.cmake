# lcm-gen's decoders resize to whatever count the bytes announce and read
# strings of any length. This step puts a check before each: a count lies in
# [0, bytes left], a string has at least its final NUL and none inside. It
# fails the build when lcm-gen's output has a shape it does not know.
# What is as it was is not written again: nothing is compiled for it.
function(write_if_new path text)
  if(EXISTS ${path})
    file(READ ${path} old)
    if("${old}" STREQUAL "${text}")
      return()
    endif()
  endif()
  file(WRITE ${path} "${text}")
endfunction()

file(GLOB raw_headers ${RAW}/*.hpp)
foreach(header ${raw_headers})
  file(READ ${header} text)
  cmake_path(GET header FILENAME name)

  string(REGEX MATCHALL "\n    this->[a-z_0-9]+\\.resize\\(this->" top "${text}")
  string(REGEX MATCHALL "\\.resize\\(this->" every "${text}")
  list(LENGTH top num_top)
  list(LENGTH every num_every)
  string(REGEX MATCHALL "\n        this->[a-z_0-9]+\\.resize\\(this->" nested "${text}")
  list(LENGTH nested num_nested)
  math(EXPR num_known "${num_top} + ${num_nested}")
  if(NOT num_known EQUAL num_every)
    message(FATAL_ERROR "${name}: a resize this step cannot guard; use one-dimensional arrays")
  endif()
  string(REGEX REPLACE
    "\n( +)(this->[a-z_0-9]+\\.resize\\((this->[a-z_0-9]+)\\);)"
    "\n\\1if(\\3 < 0 || \\3 > maxlen - pos) return -1;\n\\1\\2" text "${text}")

  string(REGEX REPLACE
    "if\\((__[a-z_0-9]+) > maxlen - pos\\) return -1;"
    "if(\\1 < 1 || \\1 > maxlen - pos || memchr(static_cast<const char*>(buf) + offset + pos, 0, \\1) != static_cast<const char*>(buf) + offset + pos + \\1 - 1) return -1;"
    text "${text}")
  string(REPLACE "#include <lcm/lcm_coretypes.h>"
    "#include <lcm/lcm_coretypes.h>\n#include <string.h>" text "${text}")
  write_if_new(${OUT}/${name} "${text}")
endforeach()

file(GLOB lcm_files ${TYPES}/*.lcm)
list(SORT lcm_files)
set(all "")
set(texts "")
foreach(file ${lcm_files})
  file(READ ${file} text)
  string(APPEND all "${text}")
  cmake_path(GET file FILENAME name)
  string(APPEND texts "    {\"${name}\", R\"lcm(${text})lcm\"},\n")
endforeach()
string(SHA256 digest "${all}")
string(SUBSTRING ${digest} 0 15 digest)
write_if_new(${OUT}/types_digest.h
  "#pragma once\n#include <cstdint>\nnamespace cell {\n/// Digest of the texts of all message types.\ninline constexpr int64_t kTypesDigest = 0x${digest};\n}  // namespace cell\n")
write_if_new(${OUT}/type_texts.h
  "#pragma once\n#include <string_view>\nnamespace cell {\nstruct TypeText {\n  std::string_view file;\n  std::string_view text;\n};\n/// The texts of all message types, by file.\ninline constexpr TypeText kTypeTexts[] = {\n${texts}};\n}  // namespace cell\n")
