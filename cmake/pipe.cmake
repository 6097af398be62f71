# Runs the example of live depth on what the program WRITER writes to FOLDER, and compares its maps bit by bit.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
execute_process(COMMAND ${EMULATOR} "${WRITER}" --write "${FOLDER}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND ${EMULATOR} "${READER}" "${FOLDER}/tables.lml" 128x96 --threads 3
  INPUT_FILE "${FOLDER}/frames.raw"
  OUTPUT_FILE "${FOLDER}/maps.raw"
  RESULT_VARIABLE code
  ERROR_VARIABLE said)
message("${said}")
# The second of three pairs has a black frame.
if(NOT code EQUAL 3 OR NOT said MATCHES "map 1 is NaN: frames must hold light" OR NOT said MATCHES "3 maps of 32x24 from 6 frames")
  message(FATAL_ERROR "exit code ${code}")
endif()
file(SHA256 "${FOLDER}/maps.raw" maps)
file(SHA256 "${FOLDER}/depth.raw" depth)
if(NOT maps STREQUAL depth)
  message(FATAL_ERROR "maps.raw and depth.raw differ")
endif()
