# SPDX-License-Identifier: LGPL-3.0-or-later
# Runs a program in an empty folder: it must succeed, print what is expected and leave the files that it promises.
# usage: cmake -D PROGRAM=<path> -D FOLDER=<path> -D PRINTS=<expression> -D WRITES=<file>,... -P run_demo.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${PROGRAM} WORKING_DIRECTORY ${FOLDER} OUTPUT_VARIABLE out ERROR_VARIABLE err RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "exit code ${code}: ${err}")
endif()
if(NOT out MATCHES "${PRINTS}")
  message(FATAL_ERROR "printed '${out}'; expected '${PRINTS}'")
endif()
string(REPLACE "," ";" files "${WRITES}")
foreach(file IN LISTS files)
  file(SIZE ${FOLDER}/${file} size) # fails if there is none
  if(size EQUAL 0)
    message(FATAL_ERROR "${file} is empty")
  endif()
endforeach()
