# SPDX-FileCopyrightText: 2026 The Hexapose authors
# SPDX-License-Identifier: MIT
# Installs the component `development` of a build into a scratch folder, looks through its headers, and builds and runs
# the examples that came with it, with the compiler and the flags of that build.
# Needs BUILD_DIR, CONFIG, SCRATCH, DATADIR, GENERATOR, COMPILER; may have PREFIX_PATH, FLAGS, SANITIZE.
set(prefix ${SCRATCH}/prefix)
set(build ${SCRATCH}/build)
file(REMOVE_RECURSE ${SCRATCH})

function(step title)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message(NOTICE "${said}")
    message(FATAL_ERROR "${title} failed (${status}), see above")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

step("installing" ${CMAKE_COMMAND} --install ${BUILD_DIR} --config ${CONFIG} --component development --prefix ${prefix})

# Every header comes with those it includes, and none shows what a user of the library need not have.
file(GLOB_RECURSE headers RELATIVE ${prefix}/include/hexapose ${prefix}/include/hexapose/*)
if(NOT headers)
  message(FATAL_ERROR "no headers were installed below ${prefix}/include/hexapose")
endif()
foreach(header IN LISTS headers)
  file(STRINGS ${prefix}/include/hexapose/${header} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[ \t]*#[ \t]*include[ \t]*([\"<][^\">]*).*" "\\1" included "${line}")
    string(SUBSTRING "${included}" 0 1 kind)
    string(SUBSTRING "${included}" 1 -1 name)
    if(kind STREQUAL "\"" AND NOT EXISTS ${prefix}/include/hexapose/${name})
      message(SEND_ERROR "${header}: includes ${name}, which is not installed")
    elseif(kind STREQUAL "<" AND NOT name MATCHES "^(Eigen/[A-Za-z]+|[a-z_]+|unistd\\.h)$")
      message(SEND_ERROR "${header}: includes ${name}, which is neither Eigen, the standard library nor POSIX")
    endif()
  endforeach()
endforeach()

if(SANITIZE)
  string(APPEND FLAGS " -fsanitize=${SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all")
endif()
string(REPLACE ";" "\\;" prefix_path "${prefix};${PREFIX_PATH}") # one argument, though a list
step("configuring" ${CMAKE_COMMAND} -S ${prefix}/${DATADIR}/doc/hexapose/examples -B ${build} -G ${GENERATOR}
  -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_PREFIX_PATH=${prefix_path}"
  -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON)
file(STRINGS ${build}/CMakeCache.txt found REGEX "^hexapose_DIR:")
string(FIND "${found}" "=${prefix}/" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the examples found another hexapose: ${found}")
endif()
step("building" ${CMAKE_COMMAND} --build ${build} --verbose)
step("running" ${CMAKE_CTEST_COMMAND} --test-dir ${build} --verbose --no-tests=error)
message(STATUS "${said}")
